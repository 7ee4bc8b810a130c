// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>

#include "distance/distance_query.h"
#include "numbers/errors.h"
#include "pair/world_frame.h"
#include "polygon/cache_contents.h"
#include "polygon/polygon_data.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"

namespace tricover::detail {

/// Refuses a complement, which no translation or no shortest one separates from another region.
inline void requireBounded(const Polygon& a, const Polygon& b) {
  for (const auto& [polygon, name] : {std::pair(&a, "a"), std::pair(&b, "b")})
    if (polygon->isComplement())
      refuse(name, "a complement has no depth as a whole", "use contacts() with ContactDetail::LocalDepth");
}

/// Where two regions that are apart are nearest, and the unit vector from a to b there.
struct NearestContact {
  DistanceResult nearest;
  Vec2 normal;
};

NearestContact nearestContact(const PosedPair& pair, const DistanceQuery& query = {});

/// So many translations are tried at most.
constexpr std::size_t kMostTranslations = 20000;

/// Whether the regions are farther apart than the margin once both have been translated so. Exact.
bool areApartMoved(const PosedPair& pair, const Vec2& by_a, const Vec2& by_b, double margin);

/// penetration() of operands that are known to overlap, but for the margin, in the kernel's order. The last step may
/// try some translations more than `most`.
Penetration penetrationInOrder(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                               double margin, std::size_t most = kMostTranslations, PenetrationHint* hint = nullptr);

}  // namespace tricover::detail
