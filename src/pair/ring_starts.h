// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "polygon/polygon_data.h"

namespace tricover::detail {

/// The starts by which containment is asked for. Rings whose edges meet are connected, and what doesn't cross another
/// polygon's edges is, where it is connected, either in that region or not: so one start serves for all of them, that
/// of the first.
class RingStarts : public Derived::Thing {
 public:
  /// Exact as far as it goes: where edges of very many rings meet, some are left unconnected.
  explicit RingStarts(const PolygonData& polygon);

  std::size_t count() const { return starts_.size(); }

  /// Those in the box from `low` to `high`, as numbers of rings, in order; NaN stands for no bound.
  std::vector<std::uint32_t> within(const Vec2& low, const Vec2& high) const;

 private:
  struct Start {
    Vec2 at;
    std::uint32_t ring;
  };

  void arrange(std::size_t begin, std::size_t end, int axis);
  template <typename Show>
  void visit(std::size_t begin, std::size_t end, int axis, const Vec2& low, const Vec2& high, Show show) const;

  std::vector<Start> starts_;  ///< a k-d tree: the middle one of a range parts the others, by x and by y in turn
};

/// Builds them, unless there are few rings.
void buildRingStarts(const PolygonData& polygon);

/// Null where every ring is to be asked: of few rings, and until that has cost about as much as finding them does.
/// Which ring is the first to be in a region doesn't depend on it.
const RingStarts* ringStarts(const PolygonData& polygon);

/// Tells what asking every ring has cost: so many rings, of which so many were located.
void countRings(const PolygonData& polygon, std::size_t rings, std::size_t located);

}  // namespace tricover::detail
