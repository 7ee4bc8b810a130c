// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "numbers/rigidity.h"
#include "tricover/scene.h"

namespace tricover::detail {

/// Calls task(i) for every i in [0, count) on the user's threads.
template <typename Task>
void inParallel(const Parallel& parallel, std::size_t count, const Task& task) {
  if (parallel) return parallel(count, task);
  for (std::size_t i = 0; i < count; ++i) task(i);
}

/// Short tasks are handed over in chunks of this number, because each costs microseconds to hand over.
constexpr std::size_t kChunk = 512;

/// Does the same in chunks.
template <typename Task>
void inParallelTasks(const Parallel& parallel, std::size_t count, const Task& task) {
  inParallel(parallel, (count + kChunk - 1) / kChunk, [&](std::size_t chunk) {
    const std::size_t end = std::min((chunk + 1) * kChunk, count);
    for (std::size_t i = chunk * kChunk; i < end; ++i) task(i);
  });
}

/// Returns what gather(i, list) adds to lists, in the order of i, whatever runs it.
template <typename Found, typename Gather>
std::vector<Found> gatherInParallel(const Parallel& parallel, std::size_t count, const Gather& gather) {
  std::vector<std::vector<Found>> lists((count + kChunk - 1) / kChunk);
  inParallelTasks(parallel, count, [&](std::size_t i) { gather(i, lists[i / kChunk]); });
  std::vector<Found> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// Throws, naming which of many poses it is.
inline void requireRigid(const Pose& pose, const char* name, std::size_t index) {
  if (!isPlainlyRigid(pose)) checkPose(pose, (name + ("[" + std::to_string(index)) + "]").c_str());
}

/// Returns query(pose) of each pose, in their order.
template <typename Answer, typename Query>
std::vector<Answer> answersAt(const std::vector<Pose>& poses, const Parallel& parallel, const Query& query) {
  for (std::size_t i = 0; i < poses.size(); ++i) requireRigid(poses[i], "poses", i);
  std::vector<Answer> answers(poses.size());
  inParallelTasks(parallel, poses.size(), [&](std::size_t i) { answers[i] = query(poses[i]); });
  return answers;
}

}  // namespace tricover::detail
