// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "polygon/polygon_data.h"

namespace tricover::detail {

/// The ring starts by which containment is decided. Rings whose edges meet are connected. Connected rings that don't
/// cross another polygon's edges lie in that polygon as a whole or not at all, so the start of the first such ring
/// serves for all of them. The hierarchy finds the starts.
class RingStarts : public Derived::Thing {
 public:
  /// Exact as far as it goes: where edges of very many rings meet, some are left unconnected.
  explicit RingStarts(const PolygonData& polygon);

  /// The positions of the edges that begin at a start within `radius` of a point, and of some others, in ascending
  /// order. In the polygon's frame; all starts if the radius is NaN.
  std::vector<std::uint32_t> near(const Vec2& point, double radius) const;

 private:
  const PolygonData& polygon_;
  std::vector<std::uint8_t> marked_;  ///< see visitMarkedNear()
};

/// Builds the starts, unless there are few rings.
void buildRingStarts(const PolygonData& polygon);

/// Null where every ring is to be tested: of few rings, and until queries have paid as much as finding the starts costs
/// (ski-rental). Which ring is the first inside a region doesn't depend on it.
const RingStarts* ringStarts(const PolygonData& polygon);

/// Pays what a query cost that tested every ring and located so many starts.
void countRings(const PolygonData& polygon, std::size_t rings, std::size_t located);

}  // namespace tricover::detail
