// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "shapes.h"
#include "stages.h"
#include "tricover/polygon.h"
#include "tricover/pose.h"

namespace tricover::fuzz {

/// Makes degenerate polygons and poses of bytes; zeros follow the last one, so every input is a case. While it lives,
/// polygons derive what that last one says.
class ByteReader {
 public:
  ByteReader(const std::uint8_t* data, std::size_t size)
      : data_(data), size_(size), up_to_(static_cast<detail::Stages>(size > 0 ? data[size - 1] % 4 : 0)) {}

  std::uint8_t byte() { return at_ < size_ ? data_[at_++] : 0; }
  int integer(int low, int high) { return low + byte() % (high - low + 1); }

  double anyDouble() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits = bits << 8 | byte();
    double value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }
  double finiteDouble() {
    const double value = anyDouble();
    return std::isfinite(value) ? value : 1;
  }

  /// Mostly a small grid's, some an ulp or two beside it, few anything.
  double coordinate(int cells = 8) {
    const int kind = byte();
    const double cell = kind % cells - cells / 2;
    if (kind < 160) return cell;
    if (kind < 232) return support::nudged(cell, integer(-2, 2));
    if (kind < 248) return cell / 3;
    constexpr double kSpecial[] = {1e-6, 1e6, 1e-160, 1e150, 1e300, std::numeric_limits<double>::denorm_min(), 1e15};
    return kind < 255 ? kSpecial[kind - 248] : finiteDouble();
  }

  Vec2 point(int cells = 8) {
    const double x = coordinate(cells);
    return {x, coordinate(cells)};
  }

  /// Up to three rings of up to twelve vertices in all; half of them on a grid of four points by four.
  Polygon polygon() {
    const int kind = byte();
    std::vector<Ring> rings(static_cast<std::size_t>(1 + kind % 3));
    for (Ring& ring : rings) {
      const int count = integer(3, 12 / static_cast<int>(rings.size()));
      for (int i = 0; i < count; ++i) ring.push_back(point(kind & 128 ? 8 : 4));
    }
    return Polygon(std::move(rings), kind & 64 ? FillRule::NonZero : FillRule::EvenOdd);
  }

  Pose pose() {
    const int kind = byte();
    Pose result = Pose::Identity();
    if (kind & 1) result.linear() << 0, -1, 1, 0;
    if (kind & 2) result.linear() *= -1;
    if ((kind & 12) == 4) result = support::turnedAndMoved(integer(0, 255) * 0.0246, 0, 0);
    if ((kind & 12) == 8) result = support::throughFloat(support::turnedAndMoved(integer(0, 255) * 0.0246, 0, 0));
    if (kind & 16) result = support::mirrored(result);
    if (kind & 96) result.translation() = point(12);
    return result;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_, at_ = 0;
  support::UpTo up_to_;
};

/// Prints the case and ends the process, which is how a fuzz target reports.
[[noreturn]] void fail(const char* what, const std::string& reproduction);

}  // namespace tricover::fuzz
