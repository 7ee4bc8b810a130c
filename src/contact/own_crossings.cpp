// SPDX-License-Identifier: BSD-3-Clause
#include "contact/own_crossings.h"

#include <algorithm>
#include <memory>

#include "numbers/convex_hull.h"

namespace tricover::detail {
namespace {

struct Tangles : Derived::Thing {
  explicit Tangles(bool some_) : some(some_) {}

  bool some;
};

bool findTangle(const PolygonData& polygon) {
  const std::vector<std::uint32_t> order = verticesByPlace(polygon);
  const auto areEqual = [&](std::uint32_t v, std::uint32_t w) { return polygon.path[v] == polygon.path[w]; };
  bool found = std::adjacent_find(order.begin(), order.end(), areEqual) != order.end();
  if (!found) forEachOwnCrossing(polygon, [&](std::size_t, std::size_t) { return !(found = true); });
  return found;
}

}  // namespace

std::vector<std::uint32_t> verticesByPlace(const PolygonData& polygon) {
  std::vector<std::uint32_t> order;
  for (std::size_t r = 0; r < polygon.ringCount(); ++r)
    for (std::size_t v = polygon.edgeBegin(r); v < polygon.edgeEnd(r); ++v)
      order.push_back(static_cast<std::uint32_t>(v));
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t v, std::uint32_t w) { return isBefore(polygon.path[v], polygon.path[w]); });
  return order;
}

bool meetsItself(const PolygonData& polygon) {
  const Derived::Thing* tangles =
      hierarchyOf(polygon).tangles.built([&] { return std::make_unique<const Tangles>(findTangle(polygon)); });
  return static_cast<const Tangles*>(tangles)->some;
}

}  // namespace tricover::detail
