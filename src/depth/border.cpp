// SPDX-License-Identifier: BSD-3-Clause
#include "depth/border.h"

#include <algorithm>
#include <optional>

#include "hierarchy/hierarchy.h"
#include "pair/complement.h"
#include "penetration/rings.h"

namespace tricover::detail {
namespace {

struct Borders : Derived::Thing {
  explicit Borders(const PolygonData& polygon) {
    const std::optional<std::vector<Ring>> rings = borderRings(polygon);
    if (!rings)
      region = &polygon;
    else if (!rings->empty())
      own = PolygonData::make(RingsView(*rings), {FillRule::EvenOdd, polygon.fill.is_complement}), region = own;
  }
  ~Borders() override {
    if (own != nullptr) own->release();
  }

  const PolygonData* region = nullptr;
  PolygonData* own = nullptr;
};

}  // namespace

const PolygonData* withBordersOnly(const PolygonData& polygon) {
  if (polygon.isDegenerate()) return nullptr;
  const std::vector<std::int8_t>& sides = regionSidesOf(polygon).rings;
  if (std::all_of(sides.begin(), sides.end(), [](std::int8_t side) { return side != 0; })) return &polygon;
  return hierarchyOf(polygon).borders.made<Borders>(polygon).region;
}

}  // namespace tricover::detail
