// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

namespace tricover::detail {

/// An exact number m * 2^k: sums, differences and products of doubles without rounding, overflow or underflow.
///
/// Sign and magnitude; limb i weighs 2^(64 (low + i)), so that operands are aligned by index alone. `Limbs` holds them.
template <class Limbs>
class DyadicIn {
 public:
  using Dyadic = DyadicIn;
  DyadicIn() = default;

  explicit DyadicIn(double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    const int field = static_cast<int>(bits >> 52 & 0x7ff);
    std::uint64_t mantissa = bits & 0xfffffffffffffULL;
    if (field != 0) mantissa |= 1ULL << 52;
    if (mantissa == 0) return;
    sign_ = bits >> 63 ? -1 : 1;
    const int exponent = (field != 0 ? field : 1) - 1075 + 64 * kBias;  // biased to be positive: / and % floor
    low_ = exponent / 64 - kBias;
    const Wide wide = static_cast<Wide>(mantissa) << (exponent % 64);
    limbs_[0] = static_cast<std::uint64_t>(wide);
    limbs_[1] = static_cast<std::uint64_t>(wide >> 64);
    size_ = 2;
    trim();
  }

  DyadicIn(const Dyadic& other) { *this = other; }
  Dyadic& operator=(const Dyadic& other) {
    if (this == &other) return *this;
    sign_ = other.sign_;
    low_ = other.low_;
    size_ = other.size_;
    std::copy_n(other.limbs_.begin(), size_, limbs_.begin());
    return *this;
  }

  int sign() const { return sign_; }

  /// mantissa * 2^exponent, the exponent even.
  struct Scaled {
    double mantissa;
    int exponent;
  };

  /// This number, right to 2^-52 of itself, in mantissas of 1 to 2^128: the top limb isn't 0, so what is below the two
  /// highest is less than 2^-64 of them; two conversions and a sum round.
  Scaled scaled() const {
    const int top = low_ + size_ - 1;
    const double magnitude = static_cast<double>(at(top)) * 0x1p64 + static_cast<double>(at(top - 1));
    return {sign_ * magnitude, 64 * (top - 1)};
  }

  Dyadic operator-() const {
    Dyadic result(*this);
    result.sign_ = -sign_;
    return result;
  }

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) { return sum(a, b, b.sign_); }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return sum(a, b, -b.sign_); }

  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    Dyadic result;
    if (a.sign_ == 0 || b.sign_ == 0) return result;
    result.sign_ = a.sign_ * b.sign_;
    result.low_ = a.low_ + b.low_;
    result.size_ = a.size_ + b.size_;
    std::fill_n(result.limbs_.begin(), result.size_, 0);
    for (int i = 0; i < a.size_; ++i) {
      std::uint64_t carry = 0;
      for (int j = 0; j < b.size_; ++j) {
        const Wide t = static_cast<Wide>(a.limbs_[index(i)]) * b.limbs_[index(j)] + result.limbs_[index(i + j)] + carry;
        result.limbs_[index(i + j)] = static_cast<std::uint64_t>(t);
        carry = static_cast<std::uint64_t>(t >> 64);
      }
      result.limbs_[index(i + b.size_)] = carry;
    }
    result.trim();
    return result;
  }

 private:
  __extension__ using Wide = unsigned __int128;
  static constexpr int kBias = 64;

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  /// The limb that weighs 2^(64 i).
  std::uint64_t at(int i) const { return i < low_ || i >= low_ + size_ ? 0 : limbs_[index(i - low_)]; }

  /// a plus b, taking b's sign as given.
  static Dyadic sum(const Dyadic& a, const Dyadic& b, int sign_b) {
    if (sign_b == 0) return a;
    if (a.sign_ == 0) {
      Dyadic result(b);
      result.sign_ = sign_b;
      return result;
    }
    if (a.sign_ == sign_b) return combine<false>(a, b, sign_b);
    const int order = compareMagnitude(a, b);
    if (order == 0) return Dyadic();
    return order > 0 ? combine<true>(a, b, a.sign_) : combine<true>(b, a, sign_b);
  }

  /// |a| + |b|, or |a| - |b| where |a| > |b|.
  template <bool Subtract>
  static Dyadic combine(const Dyadic& a, const Dyadic& b, int sign) {
    Dyadic result;
    result.sign_ = sign;
    result.low_ = std::min(a.low_, b.low_);
    const int high = std::max(a.low_ + a.size_, b.low_ + b.size_);
    result.size_ = high - result.low_;
    std::uint64_t carry = 0;
    for (int i = result.low_; i < high; ++i) {
      const Wide x = a.at(i), y = static_cast<Wide>(b.at(i)) + carry;
      const Wide t = Subtract ? x - y : x + y;
      result.limbs_[index(i - result.low_)] = static_cast<std::uint64_t>(t);
      carry = static_cast<std::uint64_t>(t >> 64) & 1;
    }
    if (!Subtract && carry) result.limbs_[index(result.size_++)] = carry;
    result.trim();
    return result;
  }

  static int compareMagnitude(const Dyadic& a, const Dyadic& b) {
    const int high = std::max(a.low_ + a.size_, b.low_ + b.size_);
    for (int i = high - 1, low = std::min(a.low_, b.low_); i >= low; --i)
      if (a.at(i) != b.at(i)) return a.at(i) > b.at(i) ? 1 : -1;
    return 0;
  }

  /// Drops zero limbs at both ends; the value isn't zero.
  void trim() {
    while (limbs_[index(size_ - 1)] == 0) --size_;
    int zeros = 0;
    while (limbs_[index(zeros)] == 0) ++zeros;
    if (zeros == 0) return;
    size_ -= zeros;
    low_ += zeros;
    std::copy_n(limbs_.begin() + zeros, size_, limbs_.begin());
  }

  int sign_ = 0, low_ = 0, size_ = 0;
  Limbs limbs_;
};

/// Capacity, for the largest use (a squared distance against a squared margin): a posed coordinate R p + t is a
/// multiple of 2^-2148 and below 2^1026, a difference of two takes at most 51 limbs, a product of differences 103, the
/// square of that 206. Of points outside of everything, a few bits larger, only products of differences are made.
using Dyadic = DyadicIn<std::array<std::uint64_t, 216>>;

/// Outside of the stack. Capacity, for the squared distance from where two lines meet: the two products of differences
/// that a fraction consists of, times a product of differences, 206 limbs, squared.
struct HeapLimbs {
  std::uint64_t& operator[](std::size_t i) { return all[i]; }
  std::uint64_t operator[](std::size_t i) const { return all[i]; }
  auto begin() { return all.begin(); }
  auto begin() const { return all.begin(); }
  std::vector<std::uint64_t> all = std::vector<std::uint64_t>(416);
};
using LongDyadic = DyadicIn<HeapLimbs>;

}  // namespace tricover::detail
