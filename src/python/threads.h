// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <algorithm>
#include <cstddef>
#include <functional>

namespace tricover_python {

/// tricover::Parallel on so many threads, 0: as many as there are processors. The error of the first task that has one
/// is rethrown. Doesn't need the GIL.
void inParallel(std::size_t threads, std::size_t count, const std::function<void(std::size_t)>& task);
std::function<void(std::size_t, const std::function<void(std::size_t)>&)> parallelOn(std::size_t threads);

/// Calls query(i) for every i in [0, count) on threads, at least `each` to a task, while other Python threads run.
template <typename Query>
void forEachInParallel(std::size_t count, std::size_t threads, std::size_t each, const Query& query) {
  const pybind11::gil_scoped_release released;
  each = std::max(each, std::min<std::size_t>(256, count / 64));
  inParallel(threads, (count + each - 1) / each, [&](std::size_t task) {
    for (std::size_t i = task * each; i < std::min(count, (task + 1) * each); ++i) query(i);
  });
}

}  // namespace tricover_python
