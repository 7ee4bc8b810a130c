// SPDX-License-Identifier: BSD-3-Clause
#include "pair/world_frame.h"

#include <algorithm>
#include <cmath>

#include "numbers/double_double.h"
#include "numbers/power_of_two.h"

namespace tricover::detail {
namespace {

/// A quarter of the way from b's S to a's, in the world: a quarter, not to overflow.
Vec2 quarterToA(const PosedPair& pair) {
  Vec2 result;
  const auto &a = pair.pose_a.matrix(), &b = pair.pose_b.matrix();
  const Vec2 s_a = pair.a.origin / 4, s_b = pair.b.origin / 4;
  for (int axis = 0; axis < 2; ++axis) {
    const DoubleDouble shift = twoSum(a(axis, 2) / 4, -b(axis, 2) / 4);
    const DoubleDouble to_a = twoProduct(a(axis, 0), s_a.x()) + twoProduct(a(axis, 1), s_a.y());
    const DoubleDouble to_b = twoProduct(b(axis, 0), s_b.x()) + twoProduct(b(axis, 1), s_b.y());
    result[axis] = (shift + (to_a - to_b)).high;
  }
  return result;
}

/// The way between the origins is below 2^404 of it, so that squares don't overflow.
double unitFor(const PosedPair& pair, const Vec2& quarter_to_a) {
  const double least = powerOfTwo(std::max(exponentOf(quarter_to_a.lpNorm<1>()) - 400, -1000));
  return std::max({pair.b.unit, pair.a.unit * 0x1p-200, least});
}

}  // namespace

WorldFrame::WorldFrame(const PosedPair& pair)
    : pair_(pair),
      linear_a_(pair.pose_a.linear()),
      linear_b_(pair.pose_b.linear()),
      quarter_to_a_(quarterToA(pair)),
      unit_(unitFor(pair, quarter_to_a_)),
      scale_a_(pair.a.unit / unit_),
      scale_b_(pair.b.unit / unit_),
      origin_a_(quarter_to_a_ / unit_ * 4),
      quarter_origin_(linear_b_ * (pair.b.origin / 4) + pair.pose_b.translation() / 4) {
  error_ = kPointError * (scale_a_ + scale_b_ + origin_a_.lpNorm<1>());
}

}  // namespace tricover::detail
