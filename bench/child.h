// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace tricover::bench {

/// Answers the query with that number.
using Asker = std::function<double(std::size_t i)>;

/// What `make()` answers to `count` queries in a child process, where it may throw, crash or hang. NaN where it threw
/// or answered that, and for all that it didn't come to: it has one second of CPU time.
std::vector<double> askInChild(std::size_t count, const std::function<Asker()>& make);

}  // namespace tricover::bench
