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

/// The same for what takes so little time that many are one task for the user, since handing one over costs
/// microseconds: task(begin, end, chunk) for each chunk of [0, count).
constexpr std::size_t kChunk = 512;
constexpr std::size_t chunksOf(std::size_t count) { return (count + kChunk - 1) / kChunk; }
template <typename Task>
void inParallelChunks(const Parallel& parallel, std::size_t count, const Task& task) {
  inParallel(parallel, chunksOf(count),
             [&](std::size_t chunk) { task(chunk * kChunk, std::min((chunk + 1) * kChunk, count), chunk); });
}

/// And by task(i).
template <typename Task>
void inParallelTasks(const Parallel& parallel, std::size_t count, const Task& task) {
  inParallelChunks(parallel, count, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) task(i);
  });
}

/// Throws, naming which of many poses it is.
inline void requireRigid(const Pose& pose, const char* name, std::size_t index) {
  if (!isPlainlyRigid(pose)) checkPose(pose, (name + ("[" + std::to_string(index)) + "]").c_str());
}

}  // namespace tricover::detail
