// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "hierarchy/inner_discs.h"

namespace tricover::detail {

/// Discs that are proven to lie in the polygon's region, many enough to fill most of it, in its units from S. Built at
/// the first call, once for all copies and threads: O(n) with a large constant.
const std::vector<Disc>& discCoverOf(const PolygonData& polygon);
/// The few of them that most queries ask first, the largest of all first; of a degenerate polygon none.
std::vector<Disc> largestDiscsOf(const PolygonData& polygon);

/// Where in the plane of translations a disc of a and one of b overlap: discs of their own, the sums of one of a and
/// one of -b. What holds a cell of that plane is looked for among the few that are near it.
class DiscSums {
 public:
  DiscSums() = default;
  /// Of discs in the order of their sizes; each is grown by so much. The largest with up to `most`, and so on.
  DiscSums(const std::vector<Disc>& a, const std::vector<Disc>& b, double grown, std::size_t most);

  /// Whether one of them holds all within `radius` of t.
  bool hold(const Vec2& t, double radius) const;
  /// Whether one of them holds all of a segment.
  bool holdSegment(const Vec2& v, const Vec2& w) const;

  /// Those that reach far into what is within `radius` of t: the ones worth asking about parts of it.
  DiscSums near(const Vec2& t, double radius) const;
  /// Whether near() is worth its while.
  bool areMany() const { return x_.size() > 16; }

 private:
  void add(double x, double y, double radius);

  std::vector<double> x_, y_, radius_;
  double largest_ = 0;  ///< radius
};

}  // namespace tricover::detail
