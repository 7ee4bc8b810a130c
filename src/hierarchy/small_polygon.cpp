// SPDX-License-Identifier: BSD-3-Clause
#include "hierarchy/small_polygon.h"

#include <algorithm>
#include <cmath>

#include "polygon/convexity.h"

namespace tricover::detail {
namespace {

void addRings(const PolygonData& polygon, SmallPolygon& small) {
  unsigned i = 0;
  const auto add = [&](unsigned end) {
    small.firsts |= 0x10001u << i;
    small.lasts |= 0x10001u << (end - 1);
    const unsigned first = i;
    for (; i < end; ++i) small.next[i] = static_cast<std::uint8_t>(i + 1 < end ? i + 1 : first);
  };
  for (std::size_t ring = 0; ring < polygon.ringCount(); ++ring) {
    const std::size_t begin = polygon.edgeBegin(ring), end = polygon.edgeEnd(ring);
    for (std::size_t e = begin; e < end; ++e) small.position[i + e - begin] = static_cast<std::uint8_t>(e);
    add(i + static_cast<unsigned>(end - begin));
  }
  if (static_cast<int>(i) < small.lanes) add(static_cast<unsigned>(small.lanes));
}

}  // namespace

std::unique_ptr<SmallPolygon> emptySmallPolygon(int lanes) {
  std::unique_ptr<SmallPolygon> small(new (lanes) SmallPolygon{});
  small->lanes = lanes;
  auto* values = reinterpret_cast<float*>(small.get() + 1);
  for (float** array : {&small->x, &small->y, &small->nx, &small->ny, &small->d, &small->middle, &small->half}) {
    *array = values;
    values = std::fill_n(values, lanes, 0.0f);
  }
  return small;
}

std::unique_ptr<const SmallPolygon> makeSmallPolygon(const PolygonData& polygon, const std::vector<Vec2>& local) {
  const std::size_t n = polygon.path.size() - polygon.ringCount();
  if (n > SmallPolygon::kMost) return nullptr;
  std::unique_ptr<SmallPolygon> small = emptySmallPolygon(n > kLanes ? SmallPolygon::kMost : kLanes);
  small->count = static_cast<int>(n);
  small->edges = (1u << n) - 1;
  small->fill = polygon.fill;
  addRings(polygon, *small);
  const double outwards = convexityOf(polygon).direction < 0 ? -1 : 1;
  for (int i = 0; i < small->lanes; ++i) {
    const std::size_t k = small->position[std::min(i, small->count - 1)];
    const Vec2 edge = local[k + 1] - local[k];
    const double length = edge.norm();
    if (!(length > 0x1p-30)) return nullptr;  // its direction wouldn't survive rounding
    const Vec2 normal = Vec2(edge.y(), -edge.x()) * (outwards / length);
    small->x[i] = static_cast<float>(local[k].x());
    small->y[i] = static_cast<float>(local[k].y());
    small->nx[i] = static_cast<float>(normal.x());
    small->ny[i] = static_cast<float>(normal.y());
    small->d[i] = static_cast<float>(normal.dot(local[k]));
    const Vec2 middle = local[k] + 0.5 * edge;
    small->middle[i] = static_cast<float>(normal.x() * middle.y() - normal.y() * middle.x());
    small->half[i] = static_cast<float>(0.5 * length);
  }
  const auto [low_x, high_x] = std::minmax_element(small->x, small->x + small->lanes);
  const auto [low_y, high_y] = std::minmax_element(small->y, small->y + small->lanes);
  small->low_x = *low_x, small->high_x = *high_x;
  small->low_y = *low_y, small->high_y = *high_y;
  return small;
}

}  // namespace tricover::detail
