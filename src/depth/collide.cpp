// SPDX-License-Identifier: BSD-3-Clause
// collide() with any margin: by the kernel of margins from 0 on, or by depth.
#include "pair/collide.h"

#include <limits>

#include "depth/depth_in_order.h"
#include "numbers/errors.h"
#include "pair/interiors.h"
#include "pair/kernel_order.h"
#include "polygon/cache_access.h"

namespace tricover {
namespace {

/// Where the margin is negative, or not finite.
[[gnu::cold, gnu::noinline]] bool collideDeeper(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                                const Pose& pose_b, detail::Certificate* cache,
                                                const CollideOptions& options) {
  detail::requireFiniteMargin(options.margin, "margin");
  detail::requireFiniteNotNegative(options.tolerance, "tolerance");
  detail::requireTouching(options.touching);
  if (!detail::collideWithin(a, pose_a, b, pose_b, cache, {})) return false;
  const double allowed = -options.margin;
  const double depth = detail::inKernelOrder(
      a.data(), pose_a, b.data(), pose_b,
      [&](const auto&... operands) { return detail::depthInOrder(operands..., {allowed}).upper_bound; }, [](double) {});
  return options.touching == Touching::Allowed ? depth > allowed : depth >= allowed;
}

[[gnu::always_inline]] inline bool collideAny(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                              const Pose& pose_b, detail::Certificate* cache,
                                              const CollideOptions& options) {
  if (!(options.margin >= 0 && options.margin <= std::numeric_limits<double>::max()))
    return collideDeeper(a, pose_a, b, pose_b, cache, options);
  return detail::collideWithin(a, pose_a, b, pose_b, cache, options);
}

}  // namespace

bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
             const CollideOptions& options) {
  return collideAny(a, pose_a, b, pose_b, nullptr, options);
}

bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, PairCache& cache,
             const CollideOptions& options) {
  return collideAny(a, pose_a, b, pose_b, &detail::contentsOf(cache).collision, options);
}

}  // namespace tricover
