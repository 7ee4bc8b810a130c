// SPDX-License-Identifier: BSD-3-Clause
#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tricover::support {
namespace {

constexpr double kTurn = 6.283185307179586;

}  // namespace

Ring rectangle(double x_low, double y_low, double x_high, double y_high) {
  return {{x_low, y_low}, {x_high, y_low}, {x_high, y_high}, {x_low, y_high}};
}

Ring star(Random& random, int n, double radius_low, double radius_high, const Vec2& center) {
  Ring ring;
  for (int i = 0; i < n; ++i) {
    const double angle = kTurn * (i + random.real(0, 0.9)) / n, radius = random.real(radius_low, radius_high);
    ring.emplace_back(center.x() + radius * std::cos(angle), center.y() + radius * std::sin(angle));
  }
  return ring;
}

Ring anyConvex(Random& random, double radius, int most, double flattest) {
  const int n = random.integer(3, random.oneIn(4) ? most : std::min(most, 16));
  const double flat = random.oneIn(3) ? std::pow(flattest, random.unit()) : 1;
  Ring ring = random.oneIn(6) ? rectangle(-radius, -radius, radius, radius) : star(random, n, radius, radius);
  for (Vec2& p : ring) p.y() *= flat;
  return ring;
}

Ring regular(int n, double radius, const Vec2& center) {
  Ring ring;
  for (int i = 0; i < n; ++i) {
    const double angle = kTurn * i / n;
    ring.emplace_back(center.x() + radius * std::cos(angle), center.y() + radius * std::sin(angle));
  }
  return ring;
}

Ring comb(int teeth, double pitch, double width, double height) {
  const double length = pitch * (teeth - 1) + width;
  Ring ring = {{0, -1}, {length, -1}};
  for (int i = teeth - 1; i >= 0; --i) {
    ring.insert(ring.end(), {{i * pitch + width, 0}, {i * pitch + width, height}, {i * pitch, height}, {i * pitch, 0}});
  }
  return ring;
}

Ring wedge(Random& random, const Vec2& direction, double length) {
  const Vec2 along = direction.normalized() * length, across(-along.y(), along.x());
  return {{0, 0}, along - random.real(0.1, 0.9) * across, along + random.real(0.1, 0.9) * across};
}

EdgeIndex anyEdge(Random& random, const Polygon& polygon) {
  return random.integer(0, static_cast<int>(polygon.edgeCount()) - 1);
}

Vec2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

Ring reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

Ring eitherWay(Random& random, Ring ring) { return random.coin() ? std::move(ring) : reversed(std::move(ring)); }

Ring scaled(Ring ring, double factor) {
  for (Vec2& vertex : ring) vertex *= factor;
  return ring;
}

Ring shifted(Ring ring, const Vec2& by) {
  for (Vec2& vertex : ring) vertex += by;
  return ring;
}

Ring withRepeatedAndMidpoints(Random& random, const Ring& ring) {
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& v = ring[i];
    const Vec2& w = ring[(i + 1) % ring.size()];
    result.insert(result.end(), static_cast<std::size_t>(random.integer(1, 2)), v);
    if (random.coin()) result.push_back(0.5 * v + 0.5 * w);
  }
  return result;
}

std::vector<Ring> redirected(Random& random, std::vector<Ring> rings) {
  for (Ring& ring : rings) {
    if (random.coin()) ring = reversed(std::move(ring));
    std::rotate(ring.begin(), ring.begin() + random.integer(0, static_cast<int>(ring.size()) - 1), ring.end());
  }
  for (std::size_t i = rings.size() - 1; i > 0; --i) {
    std::swap(rings[i], rings[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
  }
  return rings;
}

Pose pose(double xx, double xy, double x, double yx, double yy, double y) {
  Pose result = Pose::Identity();
  result.matrix().topRows<2>() << xx, xy, x, yx, yy, y;
  return result;
}

Pose turnedAndMoved(double angle, double x, double y) {
  Pose result = Pose::Identity();
  result.linear() = Eigen::Rotation2Dd(angle).toRotationMatrix();
  result.translation() = Vec2(x, y);
  return result;
}

void turn(Pose& pose, double angle) {
  const Vec2 position = pose.translation();
  pose = support::turnedAndMoved(std::atan2(pose.linear()(1, 0), pose.linear()(0, 0)) + angle, 0, 0);
  pose.translation() = position;
}

Pose mirrored(Pose pose) {
  pose.linear().col(1) *= -1;
  return pose;
}

Pose throughFloat(const Pose& pose) {
  Pose result = Pose::Identity();
  result.linear() = pose.linear().cast<float>().cast<double>();
  result.translation() = pose.translation().cast<float>().cast<double>();
  return result;
}

Pose distorted(Random& random, Pose pose) {
  // The entries of R^T R - I are the twofold of these, but for their squares; also when it turns on.
  constexpr double kMost = 0.499 * kRigidTolerance;
  const bool at_the_limit = random.coin();
  const auto entry = [&] { return at_the_limit ? (random.coin() ? kMost : -kMost) : random.real(-kMost, kMost); };
  Eigen::Matrix2d stretch = Eigen::Matrix2d::Identity();
  stretch(0, 0) += entry();
  stretch(1, 1) += entry();
  stretch(0, 1) = stretch(1, 0) = entry();
  pose.linear() = pose.linear() * stretch;
  return pose;
}

Pose randomPose(Random& random, double reach) {
  return turnedAndMoved(random.real(0, kTurn), random.real(-reach, reach), random.real(-reach, reach));
}

double nudged(double value, int steps) {
  const double towards = steps < 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
  for (int i = 0; i < std::abs(steps); ++i) value = std::nextafter(value, towards);
  return value;
}

Vec2 nudged(Random& random, const Vec2& point, int most) {
  return {nudged(point.x(), random.integer(-most, most)), nudged(point.y(), random.integer(-most, most))};
}

Motion randomMotion(Random& random, const Polygon& polygon, double size) {
  Motion motion;
  motion.start = randomPose(random, 2 * size);
  if (random.oneIn(5)) motion.start = mirrored(motion.start);
  if (random.oneIn(3)) return motion;
  const auto shift = [&] { return Vec2(4 * size * Vec2(random.real(-1, 1), random.real(-1, 1))); };
  motion.shift = random.coin() ? shift() : Vec2(-random.real(0.5, 2) * motion.start.translation());
  if (random.oneIn(3)) return motion;
  motion.pivot = random.coin() ? polygon.coveringOrigin() : shift();
  motion.angle = random.real(-1, 1) * (random.oneIn(3) ? 30 : 3);
  if (random.oneIn(3)) {
    motion.shift_2 = shift();
    motion.shift_3 = shift();
    motion.angle_2 = random.real(-3, 3);
    motion.angle_3 = random.real(-3, 3);
  }
  return motion;
}

Ring withStraightVertices(Random& random, Ring ring) {
  double most = 0;
  for (const Vec2& p : ring) most = std::max(most, p.lpNorm<Eigen::Infinity>());
  const double unit = std::ldexp(1, std::ilogb(most) - 24);  // eighths of sides between multiples of it are doubles
  for (Vec2& p : ring) p = unit * (p / unit).array().round();
  const int kind = random.integer(0, 2);
  const std::size_t one = static_cast<std::size_t>(random.integer(0, static_cast<int>(ring.size()) - 1));
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &v = ring[i], &w = ring[(i + 1) % ring.size()];
    result.push_back(v);
    for (int k = 1; k < 8; ++k)
      if (kind == 0 ? k == 4 : kind == 1 ? random.oneIn(3) : i == one) result.push_back(v + k / 8.0 * (w - v));
  }
  if (random.oneIn(4)) {
    const Pose turned = turnedAndMoved(random.real(0, kTurn), 0, 0);
    for (Vec2& p : result) p = turned * p;
  }
  return result;
}

Polygon goneRoundOften(std::vector<Ring> rings) {
  std::size_t edges = 0, times = 3;  // odd: the same under even-odd
  for (const Ring& ring : rings) edges += ring.size();
  while (times * edges <= 16) times += 2;
  for (Ring& ring : rings) {
    const Ring once = ring;
    for (std::size_t k = 1; k < times; ++k) ring.insert(ring.end(), once.begin(), once.end());
  }
  return Polygon(rings);
}

}  // namespace tricover::support
