// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "tricover/scene.h"

namespace tricover::detail {

/// task(i) for every i in [0, count), by what the user gave for it.
template <typename Task>
void inParallel(const Parallel& parallel, std::size_t count, const Task& task) {
  if (parallel) return parallel(count, task);
  for (std::size_t i = 0; i < count; ++i) task(i);
}

}  // namespace tricover::detail
