// SPDX-License-Identifier: BSD-3-Clause
#include "depth/border.h"

#include <algorithm>

#include "penetration/rings.h"

namespace tricover::detail {

const PolygonData* withBordersOnly(const PolygonData& polygon) {
  if (polygon.isDegenerate()) return nullptr;
  return &polygon;
}

}  // namespace tricover::detail
