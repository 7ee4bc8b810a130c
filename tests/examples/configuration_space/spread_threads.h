// SPDX-License-Identifier: BSD-3-Clause
// The chunks on this machine's threads.
#pragma once

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>

#include <mutex>

#include "job.h"
#include "progress.h"
#include "result_file.h"

namespace configuration_space {

inline void spread(const Job& job, ResultFile& result, Progress& progress, std::size_t threads) {
  const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism, threads);
  const std::vector<std::size_t>& left = result.left();
  std::mutex writing;
  oneapi::tbb::parallel_for(std::size_t{0}, left.size(), [&](std::size_t i) {
    const Bytes bytes = job.chunk(left[i]);
    const std::lock_guard<std::mutex> lock(writing);
    result.write(left[i], bytes);
    progress.show(result.missing());
  });
}

}  // namespace configuration_space
