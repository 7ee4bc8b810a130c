// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/signed_distance.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "convex/posed_vertices.h"
#include "distance/distance_query.h"
#include "distance/distance_result.h"
#include "pair/kernel_order.h"
#include "penetration/penetration.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/depth.h"

namespace tricover {

SignedDistance signedDistance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                              const DistanceOptions& options) {
  detail::checkOptions(options);
  if (collide(a, pose_a, b, pose_b)) {
    const Depth d = depth(a, pose_a, b, pose_b);
    if (d.upper_bound > 0) return {-d.upper_bound - options.margin, d.normal, d.point_a, d.point_b, d.edge_a, d.edge_b};
    const std::vector<Contact> touches = contacts(a, pose_a, b, pose_b, {0, 1, ContactDetail::LocalDepth});
    if (!touches.empty()) {
      const Contact& touch = touches[0];
      return {0 - options.margin, touch.normal, touch.point, touch.point, touch.edge_a, touch.edge_b};
    }
  }
  return detail::inKernelOrder(
      detail::dataOf(a), pose_a, detail::dataOf(b), pose_b,
      [&](const auto&... operands) -> SignedDistance {
        const detail::PosedPair pair(operands...);
        const auto [nearest, normal] = detail::nearestContact(pair, {options});
        // 0 exactly where they are within the margin: there the distance without one tells by how much.
        const double within =
            nearest.distance > 0 || options.margin == 0
                ? 0
                : std::min(detail::distanceInOrder(detail::PosedVertices(pair), {}).distance - options.margin, 0.0);
        return {nearest.distance + within, normal, nearest.point_a, nearest.point_b, nearest.edge_a, nearest.edge_b};
      },
      [](SignedDistance& result) {
        result.normal = -result.normal;
        std::swap(result.point_a, result.point_b);
        std::swap(result.edge_a, result.edge_b);
      });
}

}  // namespace tricover
