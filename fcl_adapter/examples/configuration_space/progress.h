// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <iostream>

namespace configuration_space {

/// Says on a terminal, twice a second, how much is done.
class Progress {
 public:
  void show(std::size_t missing, std::size_t all) {
    const auto now = std::chrono::steady_clock::now();
    if (!on_terminal_ || now - last_ < std::chrono::milliseconds(500)) return;
    last_ = now;
    std::cerr << "\r" << 100 * (all - missing) / all << " % " << std::flush;
  }
  ~Progress() {
    if (on_terminal_) std::cerr << "\r      \r";
  }

 private:
  bool on_terminal_ = isatty(STDERR_FILENO) != 0;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace configuration_space
