// SPDX-License-Identifier: BSD-3-Clause
#include "contact/own_crossings.h"

#include <algorithm>
#include <memory>

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
  if (!found) forEachOwnCrossing(polygon, -1, [&](std::size_t, std::size_t) { return !(found = true); });
  return found;
}

}  // namespace

std::vector<std::uint32_t> verticesByPlace(const PolygonData& polygon) {
  std::vector<std::uint32_t> order = sortedByPlace(polygon.path);
  const auto closes = [&](std::uint32_t v) { return v == polygon.edgeEnd(polygon.ringOf(v)); };
  order.erase(std::remove_if(order.begin(), order.end(), closes), order.end());
  return order;
}

bool meetsItself(const PolygonData& polygon) {
  const Derived::Thing* tangles =
      hierarchyOf(polygon).tangles.built([&] { return std::make_unique<const Tangles>(findTangle(polygon)); });
  return static_cast<const Tangles*>(tangles)->some;
}

}  // namespace tricover::detail
