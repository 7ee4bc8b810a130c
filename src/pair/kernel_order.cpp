// SPDX-License-Identifier: BSD-3-Clause
#include "pair/kernel_order.h"

namespace tricover::detail {

int compareData(const PolygonData& a, const PolygonData& b) {
  const auto compared = [](auto x, auto y) { return x < y ? -1 : x > y ? 1 : 0; };
  if (const int order = compared(a.path.size(), b.path.size()); order != 0) return order;
  if (const int order = compared(a.ringCount(), b.ringCount()); order != 0) return order;
  if (const int order = compared(static_cast<int>(a.fill), static_cast<int>(b.fill)); order != 0) return order;
  for (std::size_t k = 0; k < a.path.size(); ++k)
    for (const int i : {0, 1})
      if (const double x = a.path[k][i], y = b.path[k][i]; isSmaller(x, y) || isSmaller(y, x))
        return isSmaller(x, y) ? -1 : 1;
  for (std::size_t ring = 0; ring < a.ringCount(); ++ring)
    if (const int order = compared(a.edgeBegin(ring), b.edgeBegin(ring)); order != 0) return order;
  return 0;
}

}  // namespace tricover::detail
