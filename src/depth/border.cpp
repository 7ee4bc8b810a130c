// SPDX-License-Identifier: BSD-3-Clause
#include "depth/border.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "hierarchy/hierarchy.h"
#include "overlay/complement.h"
#include "overlay/rings.h"
#include "polygon/edge_walk.h"

namespace tricover::detail {
namespace {

struct Borders : Derived::Thing {
  explicit Borders(const PolygonData& polygon) {
    std::optional<BorderRings> found = borderRings(polygon);
    if (!found) {
      region = &polygon;
    } else if (!found->rings.empty()) {
      own = PolygonData::make(RingsView(found->rings), {FillRule::EvenOdd, polygon.fill.is_complement});
      region = own;
      edges = std::move(found->edges);
    }
  }
  ~Borders() override {
    if (own != nullptr) own->release();
  }

  const PolygonData* region = nullptr;
  PolygonData* own = nullptr;
  std::vector<EdgePosition> edges;  ///< by the numbers of own edges: positions in the polygon
};

}  // namespace

const PolygonData* withBordersOnly(const PolygonData& polygon) {
  const std::vector<std::int8_t>& sides = regionSidesOf(polygon).rings;
  if (std::all_of(sides.begin(), sides.end(), [](std::int8_t side) { return side != 0; })) return &polygon;
  return hierarchyOf(polygon).borders.made<Borders>(polygon).region;
}

Polygon bordersOf(const Polygon& polygon) {
  const PolygonData* const region = withBordersOnly(dataOf(polygon));
  if (region == nullptr || region == &dataOf(polygon) || region->fill.is_complement) return polygon;
  std::vector<Ring> rings;
  for (std::size_t ring = 0; ring < region->ringCount(); ++ring) rings.push_back(region->vertices(ring));
  return Polygon(rings);
}

Polygon wallsOf(const Polygon& polygon) {
  const PolygonData* const region = withBordersOnly(dataOf(polygon));
  std::vector<Ring> walls;
  if (region != nullptr)
    forEachEdge(*region, [&](EdgePosition edge) {
      walls.push_back({region->path[edge], region->path[edge + 1], region->path[edge + 1]});
      return true;
    });
  return Polygon(walls);
}

EdgePosition givenEdge(const PolygonData& polygon, const PolygonData& region, EdgePosition position) {
  if (&region == &polygon) return position;
  return hierarchyOf(polygon).borders.made<Borders>(polygon).edges[static_cast<std::size_t>(
      region.edgeNumber(position))];
}

}  // namespace tricover::detail
