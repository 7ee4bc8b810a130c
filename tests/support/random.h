// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace tricover::support {

/// SplitMix64, with distributions of its own: the standard's differ between libraries, and a seed must mean one case.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double real(double low, double high) { return low + (high - low) * unit(); }

  /// Both ends included.
  int integer(int low, int high) {
    return low + static_cast<int>(bits() % (static_cast<std::uint64_t>(high - low) + 1));
  }

  bool coin() { return integer(0, 1) == 1; }
  bool oneIn(int n) { return integer(1, n) == 1; }

 private:
  std::uint64_t state_;
};

}  // namespace tricover::support
