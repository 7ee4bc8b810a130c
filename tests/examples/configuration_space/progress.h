// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <iostream>

namespace configuration_space {

/// Says how much is done, how fast, and how long the rest will take: on a terminal in one line, twice a second;
/// elsewhere (a log, mpirun) by a line at most every `seconds`.
class Progress {
 public:
  /// Of `all` chunks, `missing` are to be made.
  Progress(std::size_t missing, std::size_t all, double seconds)
      : all_(all), first_(missing), every_(on_terminal_ ? 0.5 : seconds) {}

  void show(std::size_t missing) {
    if (missing == 0) return clear();
    const Clock::time_point now = Clock::now();
    if (std::chrono::duration<double>(now - last_).count() < every_ || missing == first_) return;
    last_ = now;
    const double seconds = std::chrono::duration<double>(now - begin_).count();
    const double rate = static_cast<double>(first_ - missing) / seconds;
    char line[100];
    std::snprintf(line, sizeof line, "%zu of %zu chunks, %.0f a second, %.0f s to go", all_ - missing, all_, rate,
                  static_cast<double>(missing) / rate);
    clear();
    std::cerr << line << (on_terminal_ ? "" : "\n") << std::flush;
  }
  ~Progress() { clear(); }

 private:
  using Clock = std::chrono::steady_clock;

  void clear() const {
    if (on_terminal_) std::cerr << "\r\33[K" << std::flush;
  }

  bool on_terminal_ = isatty(STDERR_FILENO) != 0;
  std::size_t all_, first_;
  double every_;
  Clock::time_point begin_ = Clock::now(), last_ = begin_;
};

}  // namespace configuration_space
