// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>

namespace tricover::detail {

/// 2^exponent, of a normal double's exponent.
inline double powerOfTwo(int exponent) {
  constexpr int kBias = 1023, kFraction = 52;
  const std::uint64_t bits = static_cast<std::uint64_t>(exponent + kBias) << kFraction;
  double power;
  std::memcpy(&power, &bits, sizeof power);
  return power;
}

}  // namespace tricover::detail
