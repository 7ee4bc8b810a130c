// SPDX-License-Identifier: BSD-3-Clause
#include "world_frame.h"

#include <algorithm>
#include <cmath>

namespace tricover::detail {
namespace {

/// A sum of doubles and products, as if in twice the precision: what each step rounds off is kept beside it.
class Sum {
 public:
  void add(double x) {
    const double sum = high_ + x, of_x = sum - high_;
    low_ += (high_ - (sum - of_x)) + (x - of_x);
    high_ = sum;
  }
  void addProduct(double x, double y) {
    const double product = x * y;
    add(product);
    low_ += std::fma(x, y, -product);
  }
  double value() const { return high_ + low_; }

 private:
  double high_ = 0, low_ = 0;
};

/// A quarter of the way from b's S to a's, in the world: a quarter, not to overflow.
Vec2 quarterToA(const PosedPair& pair) {
  Vec2 result;
  const auto &a = pair.pose_a.matrix(), &b = pair.pose_b.matrix();
  const Vec2 s_a = pair.a.origin / 4, s_b = pair.b.origin / 4;
  for (int axis = 0; axis < 2; ++axis) {
    Sum sum;
    sum.add(a(axis, 2) / 4);
    sum.add(-b(axis, 2) / 4);
    sum.addProduct(a(axis, 0), s_a.x());
    sum.addProduct(-b(axis, 0), s_b.x());
    sum.addProduct(a(axis, 1), s_a.y());
    sum.addProduct(-b(axis, 1), s_b.y());
    result[axis] = sum.value();
  }
  return result;
}

}  // namespace

WorldFrame::WorldFrame(const PosedPair& pair)
    : pair_(pair),
      linear_a_(pair.pose_a.linear()),
      linear_b_(pair.pose_b.linear()),
      unit_(std::max(pair.b.unit, pair.a.unit * 0x1p-200)),
      scale_a_(pair.a.unit / unit_),
      scale_b_(pair.b.unit / unit_),
      origin_a_(quarterToA(pair) / unit_ * 4),
      world_origin_(pair.pose_b * pair.b.origin) {
  error_ = 16 * kUlp * (scale_a_ + scale_b_ + origin_a_.lpNorm<1>());
}

}  // namespace tricover::detail
