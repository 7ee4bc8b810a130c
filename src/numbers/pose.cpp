// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/pose.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "numbers/angle.h"
#include "numbers/errors.h"
#include "numbers/rigidity.h"

namespace tricover {
namespace {

void requireFiniteEntries(const Pose& pose, const char* name) {
  const auto& m = pose.matrix();
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 3; ++column) {
      if (std::isfinite(m(row, column))) continue;
      const std::string place = std::to_string(row);
      detail::refuse(name, column == 2 ? "translation(" + place + ") is not finite"
                                       : "linear(" + place + ", " + std::to_string(column) + ") is not finite");
    }
}

}  // namespace

Pose poseAt(double x, double y, double heading) {
  constexpr double kQuarterTurn = detail::kPi / 2, kMostQuarters = 1 << 20;  // beyond, everything is near one
  const double quarters = std::round(heading / kQuarterTurn);
  const bool is_quarter =
      std::abs(quarters) <= kMostQuarters && std::abs(heading - quarters * kQuarterTurn) <= 0x1p-51 * std::abs(heading);
  double cosine = std::cos(heading), sine = std::sin(heading);
  if (is_quarter) cosine = std::round(cosine), sine = std::round(sine);
  Pose pose = Pose::Identity();
  pose.linear() << cosine, -sine, sine, cosine;
  pose.translation() << x, y;
  return pose;
}

void checkPose(const Pose& pose, const char* name) {
  requireFiniteEntries(pose, name);
  const double* columns = pose.data();  // of three
  const detail::Gram gram(detail::load2(columns), detail::load2(columns + 3));
  const double off = std::max({gram.norms[0], gram.norms[1], gram.dot});
  // Negated for NaN, which the product of entries may be whose squares overflow.
  if (!(off <= kRigidTolerance))
    detail::refuse(name, detail::offRigid(off),
                   "a pose only turns, mirrors and moves: tricover::nearestRigid() drops the rest");
}

Pose nearestRigid(const Pose& pose, const char* name) {
  requireFiniteEntries(pose, name);
  const Eigen::Matrix2d given = pose.linear();
  const double largest = given.cwiseAbs().maxCoeff();
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  const Eigen::Matrix2d r = given.unaryExpr([&](double entry) { return std::ldexp(entry, -exponent); });
  // 2 R is the sum of a multiple of a rotation, (c, -s; s, c), and of one of a mirroring, (c, s; s, -c). The nearest
  // map is what is longer of the two; their squares differ by 4 det R. Of entries below 2 coordinates err by 4U,
  // lengths by 23U.
  const Vec2 turn(r(0, 0) + r(1, 1), r(1, 0) - r(0, 1)), mirror(r(0, 0) - r(1, 1), r(1, 0) + r(0, 1));
  const double turned = turn.norm(), mirrored = mirror.norm();
  if (std::abs(turned - mirrored) <= 64 * detail::kUnitRoundoff)
    detail::refuse(name, "linear() takes the plane to a line or a point", "no rigid map is nearest to that");
  Pose rigid = pose;
  if (turned > mirrored) {
    const Vec2 u = turn / turned;
    rigid.linear() << u.x(), -u.y(), u.y(), u.x();
  } else {
    const Vec2 u = mirror / mirrored;
    rigid.linear() << u.x(), u.y(), u.y(), -u.x();
  }
  return rigid;
}

}  // namespace tricover
