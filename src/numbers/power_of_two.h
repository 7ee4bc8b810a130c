// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>

namespace tricover::detail {

constexpr int kExponentBias = 1023, kFractionBits = 52;

/// The exponent of a normal double that isn't negative; -1023 of smaller ones, 1024 of infinity.
inline int exponentOf(double value) {
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return static_cast<int>(bits >> kFractionBits) - kExponentBias;
}

/// The next double above a finite one that isn't negative: their bits count.
inline double nextAbove(double value) {
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  ++bits;
  std::memcpy(&value, &bits, sizeof bits);
  return value;
}

/// 2^exponent, of a normal double's exponent.
inline double powerOfTwo(int exponent) {
  const std::uint64_t bits = static_cast<std::uint64_t>(exponent + kExponentBias) << kFractionBits;
  double power;
  std::memcpy(&power, &bits, sizeof power);
  return power;
}

}  // namespace tricover::detail
