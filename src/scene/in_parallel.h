// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

#include "numbers/rigidity.h"
#include "tricover/scene.h"

namespace tricover::detail {

/// task(i) for every i in [0, count), by what the user gave for it.
template <typename Task>
void inParallel(const Parallel& parallel, std::size_t count, const Task& task) {
  if (parallel) return parallel(count, task);
  for (std::size_t i = 0; i < count; ++i) task(i);
}

/// The same for what takes so little time that many are one task for the user: handing one over costs microseconds.
template <typename Task>
void inParallelTasks(const Parallel& parallel, std::size_t count, const Task& task) {
  constexpr std::size_t kMany = 512;
  inParallel(parallel, (count + kMany - 1) / kMany, [&](std::size_t chunk) {
    const std::size_t end = std::min((chunk + 1) * kMany, count);
    for (std::size_t i = chunk * kMany; i < end; ++i) task(i);
  });
}

/// Throws, naming which of many poses it is.
inline void requireRigid(const Pose& pose, const char* name, std::size_t index) {
  if (!isPlainlyRigid(pose)) checkPose(pose, (name + ("[" + std::to_string(index)) + "]").c_str());
}

}  // namespace tricover::detail
