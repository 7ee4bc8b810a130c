// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstring>

#include "hierarchy/hierarchy.h"
#include "numbers/float4.h"
#include "polygon/convexity.h"

namespace tricover::detail {
namespace {

Double2 rootOf(Double2 v) { return Double2{std::sqrt(v[0]), std::sqrt(v[1])}; }

void store2(float* to, Float2 v) { std::memcpy(to, &v, sizeof v); }

void addRings(const PolygonData& polygon, SmallPolygon& small) {
  unsigned i = 0;
  const auto add = [&](unsigned end) {
    small.firsts |= 0x10001u << i;
    small.lasts |= 0x10001u << (end - 1);
    small.next[end - 1] = static_cast<std::uint8_t>(i);
    for (; i + 1 < end; ++i) small.next[i] = static_cast<std::uint8_t>(i + 1);
    i = end;
  };
  for (std::size_t ring = 0; ring < polygon.ringCount(); ++ring) {
    const EdgePosition begin = polygon.edgeBegin(ring), end = polygon.edgeEnd(ring);
    for (EdgePosition e = begin; e < end; ++e) small.position[i + e - begin] = static_cast<std::uint8_t>(e);
    add(i + (end - begin));
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

std::unique_ptr<const SmallPolygon> makeSmallPolygon(const PolygonData& polygon, const Vec2* local) {
  const std::size_t n = polygon.path.size() - polygon.ringCount();
  if (n > SmallPolygon::kMost || polygon.fill.is_complement) return nullptr;  // lanes are of bounded regions
  std::unique_ptr<SmallPolygon> small = emptySmallPolygon(n > kLanes ? SmallPolygon::kMost : kLanes);
  small->count = static_cast<int>(n);
  small->edges = (1u << n) - 1;
  small->fill = polygon.fill.rule;
  addRings(polygon, *small);
  const double outwards = convexityOf(polygon).direction < 0 ? -1 : 1;
  Double2 low = load2(local[0].data()), high = low;
  int i = 0;
  for (; i < small->count; i += 2) {  // two edges side by side
    const std::size_t k = small->position[i], l = small->position[std::min(i + 1, small->count - 1)];
    const Double2 v = load2(local[k].data()), w = load2(local[l].data());
    low = smaller(smaller(v, w), low);
    high = larger(larger(v, w), high);
    const Double2 v_along = load2(local[k + 1].data()) - v, w_along = load2(local[l + 1].data()) - w;
    const Double2 x{v[0], w[0]}, y{v[1], w[1]}, along_x{v_along[0], w_along[0]}, along_y{v_along[1], w_along[1]};
    const Double2 length = rootOf(along_x * along_x + along_y * along_y);
    if (bitsOf(length > 0x1p-30) != 3) return nullptr;  // its direction wouldn't survive rounding
    const Double2 scale = outwards / length, nx = along_y * scale, ny = -along_x * scale;
    store2(small->x + i, narrowed(x));
    store2(small->y + i, narrowed(y));
    store2(small->nx + i, narrowed(nx));
    store2(small->ny + i, narrowed(ny));
    store2(small->d + i, narrowed(nx * x + ny * y));
    store2(small->middle + i, narrowed(nx * (y + 0.5 * along_y) - ny * (x + 0.5 * along_x)));
    store2(small->half + i, narrowed(0.5 * length));
  }
  for (float* array : {small->x, small->y, small->nx, small->ny, small->d, small->middle, small->half})
    for (int lane = i; lane < small->lanes; lane += 2) store2(array + lane, Float2{array[i - 1], array[i - 1]});
  const Float2 low_xy = narrowed(low), high_xy = narrowed(high);
  small->low_x = low_xy[0], small->high_x = high_xy[0];
  small->low_y = low_xy[1], small->high_y = high_xy[1];
  return small;
}

}  // namespace tricover::detail
