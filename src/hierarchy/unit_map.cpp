// SPDX-License-Identifier: BSD-3-Clause
#include "hierarchy/unit_map.h"

#include "numbers/rigidity.h"

namespace tricover::detail {

/// What the way back may stretch an error by: both poses' defects, and this product's rounding.
constexpr double kStretch = 1 + 0x1p-10;
static_assert(kStretch > (1 + 2 * kLargestDefect) * (1 + 2 * kLargestDefect));

UnitMap inverse(const UnitMap& map) {
  const double d = 1 / (map.r00 * map.r11 - map.r01 * map.r10), scale = 1 / map.scale;
  const double r00 = map.r11 * d, r01 = -map.r01 * d, r10 = -map.r10 * d, r11 = map.r00 * d;
  return {r00,
          r01,
          r10,
          r11,
          -(r00 * map.tx + r01 * map.ty) * scale,
          -(r10 * map.tx + r11 * map.ty) * scale,
          scale,
          map.error * scale * kStretch};
}

}  // namespace tricover::detail
