// SPDX-License-Identifier: BSD-3-Clause
// Many poses of one polygon against a scene.
#include <algorithm>
#include <vector>

#include "scene/in_parallel.h"

namespace tricover {

std::vector<bool> Scene::collides(const Polygon& polygon, const std::vector<Pose>& poses, const CollideOptions& options,
                                  const BodyFilter& filter, const Parallel& parallel) const {
  for (std::size_t i = 0; i < poses.size(); ++i) detail::requireRigid(poses[i], "poses", i);
  std::vector<char> answers(poses.size());  // threads can't share a vector of bits
  detail::inParallelTasks(parallel, poses.size(),
                          [&](std::size_t i) { answers[i] = collides(polygon, poses[i], options, filter); });
  return {answers.begin(), answers.end()};
}

}  // namespace tricover
