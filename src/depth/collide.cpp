// SPDX-License-Identifier: BSD-3-Clause
// collide() with any margin: by the kernel of margins from 0 on, or by depth.
#include "depth/collide.h"

#include "depth/depth_in_order.h"
#include "numbers/rigidity.h"
#include "overlay/interiors.h"
#include "pair/collide.h"
#include "pair/kernel_order.h"
#include "polygon/cache_access.h"
#include "tricover/collide.h"

namespace tricover {
namespace detail {
namespace {

/// Where the margin is negative.
[[gnu::cold, gnu::noinline]] bool collideDeeper(const PolygonData& a, const Pose& pose_a, const PolygonData& b,
                                                const Pose& pose_b, double defect, Certificate* cache,
                                                const CollideOptions& options) {
  if (!collide(a, pose_a, b, pose_b, defect, cache, {})) return false;
  const double allowed = -options.margin;
  const double depth = inKernelOrder(
      a, pose_a, b, pose_b, [&](const auto&... operands) { return depthInOrder(operands..., {allowed}).upper_bound; },
      [](double) {});
  return options.touching == Touching::Allowed ? depth > allowed : depth >= allowed;
}

[[gnu::always_inline]] inline bool checkAndCollide(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                                   const Pose& pose_b, Certificate* cache,
                                                   const CollideOptions& options) {
  checkOptions(options);
  const double defect = requireRigid(pose_a, pose_b);
  return collideChecked(detail::dataOf(a), pose_a, detail::dataOf(b), pose_b, defect, cache, options);
}

}  // namespace

bool collideChecked(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b, double defect,
                    Certificate* cache, const CollideOptions& options) {
  if (options.margin < 0) return collideDeeper(a, pose_a, b, pose_b, defect, cache, options);
  return regionsCollide(a, pose_a, b, pose_b, defect, cache, options);
}

}  // namespace detail

bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
             const CollideOptions& options) {
  return detail::checkAndCollide(a, pose_a, b, pose_b, nullptr, options);
}

bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, PairCache& cache,
             const CollideOptions& options) {
  return detail::checkAndCollide(a, pose_a, b, pose_b, &detail::contentsOf(cache).collision, options);
}

}  // namespace tricover
