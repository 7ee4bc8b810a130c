// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/signed_distance.h"

#include <utility>

#include "distance/options.h"
#include "pair/kernel_order.h"
#include "penetration/penetration.h"
#include "tricover/collide.h"

namespace tricover {

SignedDistance signedDistance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                              const DistanceOptions& options) {
  detail::checkOptions(options);
  const bool meet = collide(a, pose_a, b, pose_b);
  if (meet) detail::requireBounded(a, b);
  return detail::inKernelOrder(
      a.data(), pose_a, b.data(), pose_b,
      [&](const auto&... operands) -> SignedDistance {
        if (meet) {
          const Penetration p = detail::penetrationInOrder(operands..., 0);
          return {-options.margin - p.depth, p.normal, p.point_a, p.point_b, p.edge_a, p.edge_b};
        }
        // Errors are of what the margin leaves.
        detail::DistanceQuery query;
        if (options.margin == 0) query.DistanceOptions::operator=(options);
        const auto [nearest, normal] = detail::nearestContact(detail::PosedPair(operands...), query);
        return {nearest.distance - options.margin,
                normal,
                nearest.point_a,
                nearest.point_b,
                nearest.edge_a,
                nearest.edge_b};
      },
      [](SignedDistance& result) {
        result.normal = -result.normal;
        std::swap(result.point_a, result.point_b);
        std::swap(result.edge_a, result.edge_b);
      });
}

}  // namespace tricover
