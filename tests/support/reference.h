// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmpxx.h>

#include <optional>
#include <utility>
#include <vector>

#include "families.h"
#include "tricover/locate.h"

namespace tricover::support {

/// The exact reference made fast: long doubles with a bound of their errors decide what they can, pairs of edges that
/// they leave in doubt are asked of tests/support/exact_reference.h. Shares nothing with the kernel but the types.
/// Where long double is double (or overflows), more is in doubt, and it is slower.
class Reference {
 public:
  explicit Reference(const Case& c);

  bool collide() const;
  /// Numbered as in Polygon::edgeStart, in order.
  std::vector<std::pair<EdgeIndex, EdgeIndex>> meetingEdges() const;

  /// Where a point of the polygon's own frame lies.
  static Location locate(const Polygon& polygon, const Vec2& point);

  /// Whether the distance is at most `margin`.
  bool within(double margin) const;

  /// Bounds of the distance, both 0 where they collide.
  struct Bounds {
    long double low, high;
  };
  Bounds distance() const;
  /// The square of the distance itself.
  mpq_class distanceSquared() const;

 private:
  struct Point {
    long double x, y;
  };
  struct Edge {
    Point v, w, low, high;
  };
  struct Posed {
    Posed(const Polygon& polygon, const Pose& pose);
    bool holds(const Point& p, long double p_error, bool& in_doubt) const;
    std::vector<Edge> edges;
    std::vector<std::size_t> starts;  ///< the rings' first edges
    FillRule fill;
    long double error;  ///< of each coordinate
  };
  enum class Answer { No, Yes, Doubt };

  static int side(const Point& p, const Point& q, const Point& r, long double error_pq, long double error_r);
  Answer meet(const Edge& e, const Edge& f) const;
  bool meetExactly(std::size_t i, std::size_t j) const;
  bool holdsRing(bool in_a) const;
  Bounds apart(const Edge& e, const Edge& f) const;

  const Case& case_;
  Posed a_, b_;
  mutable std::optional<bool> collides_;
};

/// One ring that turns the same way at every vertex, once around, beyond doubt.
bool isStrictlyConvex(const Polygon& polygon);

/// How deep two of them that overlap are in each other, by the least gap over the faces of both: in long doubles.
Reference::Bounds convexDepth(const Case& c);

}  // namespace tricover::support
