// SPDX-License-Identifier: BSD-3-Clause
// Many poses of one polygon against a scene.
#include <algorithm>
#include <vector>

#include "scene/in_parallel.h"

namespace tricover {

std::vector<bool> Scene::collides(const Polygon& polygon, const std::vector<Pose>& poses, const CollideOptions& options,
                                  const BodyFilter& filter, const Parallel& parallel) const {
  // A task is long beside what it costs to hand it over. Threads can't share a vector of bits.
  constexpr std::size_t kPoses = 512;
  const std::size_t count = poses.size();
  std::vector<char> answers(count);
  const auto task = [&](std::size_t chunk) {
    const std::size_t begin = chunk * kPoses, end = std::min(begin + kPoses, count);
    for (std::size_t i = begin; i < end; ++i) answers[i] = collides(polygon, poses[i], options, filter);
  };
  const std::size_t chunks = (count + kPoses - 1) / kPoses;
  detail::inParallel(parallel, chunks, task);
  return {answers.begin(), answers.end()};
}

}  // namespace tricover
