// SPDX-License-Identifier: BSD-3-Clause
// Polygons that are moved or scaled for good.
#include <cmath>
#include <vector>

#include "numbers/errors.h"
#include "polygon/polygon_data.h"
#include "tricover/polygon.h"

namespace tricover {
namespace {

template <typename Map>
Polygon mapped(const Polygon& polygon, Map map) {
  const detail::PolygonData& data = polygon.data();
  std::vector<Ring> rings;
  rings.reserve(data.ringCount());
  for (std::size_t r = 0; r < data.ringCount(); ++r)
    for (Vec2& vertex : rings.emplace_back(data.vertices(r))) vertex = map(vertex);
  return Polygon(rings, polygon.fillRule());
}

}  // namespace

Polygon Polygon::translated(const Vec2& by) const {
  detail::requireFinite(by, "by");
  return mapped(*this, [&](const Vec2& vertex) { return Vec2(vertex + by); });
}

Polygon Polygon::scaled(double factor) const {
  if (!(factor > 0 && std::isfinite(factor))) detail::refuse("factor", "it must be finite and positive");
  return mapped(*this, [&](const Vec2& vertex) { return Vec2(factor * vertex); });
}

}  // namespace tricover
