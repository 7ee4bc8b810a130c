// SPDX-License-Identifier: BSD-3-Clause
// Part of tricover_plain_double and of tricover_plain_float, where `tricover` is a macro for that name.
#include "plain_core.h"

#include "measure.h"
#include "tricover/collide.h"

namespace tricover {

PlainWalk plainWalk(const PlainRings& fixed, const PlainRings& moving, const Pose& fixed_pose) {
  return [a = Polygon(fixed), b = Polygon(moving), fixed_pose](const Pose* poses, std::size_t positions,
                                                               std::size_t period, std::size_t run, std::size_t first,
                                                               std::vector<std::uint32_t>& hits) {
    bench::forEachSample({period, run, first}, positions, [&](std::size_t i) {
      if (collide(a, fixed_pose, b, poses[i])) hits.push_back(static_cast<std::uint32_t>(i));
    });
  };
}

}  // namespace tricover
