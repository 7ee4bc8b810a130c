// SPDX-License-Identifier: BSD-3-Clause
// Many poses of one polygon against a scene.
#include <algorithm>

#include "scene/in_parallel.h"

namespace tricover {

void Scene::collides(const Polygon& polygon, const Pose* poses, std::size_t count, bool* answers,
                     const Parallel& parallel, const CollideOptions& options, std::uint32_t mask) const {
  // A task is long beside what it costs to hand it over.
  constexpr std::size_t kPoses = 512;
  const auto task = [&](std::size_t chunk) {
    const std::size_t begin = chunk * kPoses, end = std::min(begin + kPoses, count);
    for (std::size_t i = begin; i < end; ++i) answers[i] = collides(polygon, poses[i], options, mask);
  };
  const std::size_t chunks = (count + kPoses - 1) / kPoses;
  detail::inParallel(parallel, chunks, task);
}

}  // namespace tricover
