// SPDX-License-Identifier: BSD-3-Clause
// Eight boxes of a block and a box that moves beside them. See simd_gaps.h for Lanes.
#pragma once

#include "hierarchy/simd_gaps.h"

namespace tricover::detail::simd {

/// Eight pairs, seen from one end of an interval: the share of it that separates them, and whether all of it does.
template <class Lanes>
struct IntervalSide {
  Lanes share;
  unsigned apart;

  /// A gap is at least from - (from - to + chord_error) s + chord_error s^2 after a share s. With slope = from - to +
  /// chord_error it has its first root at 2 from / (slope + root(slope^2 - 4 chord_error from)), and none where that is
  /// not real or `to` is above `chord_error`. (As slope^2 is off by 5 2^-24 of itself, the root is by 2^-10 of slope;
  /// the caller pays.)
  [[gnu::always_inline]] void offer(Lanes from, Lanes to, Lanes chord_error) {
    const Lanes zero = Lanes::all(0), gap = larger(from, zero), slope = (gap - to) + chord_error;
    const Lanes square = slope * slope - chord_error * gap * 4.0f;
    apart |= above(gap, zero) & (above(to, chord_error) | above(zero, square));
    const Lanes below = larger(slope + root(larger(square, zero)), Lanes::all(1e-30f));
    share = larger(share, (gap + gap) / below);
  }
};

/// Rounding, of what gaps are computed from, which the slack is for (kGapRounding is above 32 2^-24): a gap itself
/// 2^-19; `to` by what rounds slope, 2^-22 (from + to + chord_error), where chord_error <= 4 max(from, to) if the two
/// are parted, and from and to are at most twice the sum, 2^-18; `from` by what rounds the squares, 2^-21 of it. Four
/// times 2^-19 is more. Of the share, 2^-9 is for its root and for all that rounds it.
template <class Lanes>
unsigned cutIntervals(const Block& block, const MovingBox& moving, double chord_error_with_block,
                      double chord_error_with_box, double slack_, float* from_begin, float* from_end) {
  const auto f = [](double value) { return static_cast<float>(value); };
  const auto upwards = [f](double value) { return f(value * (1 + 0x1p-16) + 0x1p-100); };
  const float along = f(moving.along), across = f(moving.across), slack = upwards(slack_);
  const Lanes with_block = Lanes::all(upwards(chord_error_with_block)),
              with_box = Lanes::all(upwards(chord_error_with_box));
  const Boxes<Lanes> box = boxesOf<Lanes>(block);
  Lanes d[4][2], gap[4][2];
  for (int end = 0; end < 2; ++end) {
    const float x = f(moving.ux[end]), y = f(moving.uy[end]);
    const Lanes dx = box.x - f(moving.x[end]), dy = box.y - f(moving.y[end]);
    const Lanes c = absolute(box.ux * x + box.uy * y), s = absolute(box.ux * y - box.uy * x);
    const Lanes reach[4] = {box.along + c * along + s * across, box.across + s * along + c * across,
                            box.along * c + box.across * s + along, box.along * s + box.across * c + across};
    d[0][end] = box.ux * dx + box.uy * dy;
    d[1][end] = box.ux * dy - box.uy * dx;
    d[2][end] = dx * x + dy * y;
    d[3][end] = dy * x - dx * y;
    for (int i = 0; i < 4; ++i) gap[i][end] = reach[i] + slack;
  }
  IntervalSide<Lanes> first{Lanes::all(0), 0}, last{Lanes::all(0), 0};
  for (int i = 0; i < 4; ++i) {
    const Lanes chord_error = i < 2 ? with_block : with_box;
    first.offer(absolute(d[i][0]) - gap[i][0], flipped(d[i][1], d[i][0]) - gap[i][1], chord_error);
    last.offer(absolute(d[i][1]) - gap[i][1], flipped(d[i][0], d[i][1]) - gap[i][0], chord_error);
  }
  constexpr float kShare = 1 - 0x1p-9f;
  const Lanes begin = first.share * kShare, end = last.share * kShare;
  begin.store(from_begin);
  end.store(from_end);
  return lanesOf(block) & ~(first.apart | last.apart | above(begin + end, Lanes::all(1)));
}

}  // namespace tricover::detail::simd
