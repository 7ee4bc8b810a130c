// SPDX-License-Identifier: BSD-3-Clause
// The kernel's stages one by one, through its private headers: an exact fallback must not hide a broken filter.
#include "numbers/predicates.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "numbers/dyadic.h"
#include "pair/posed_pair.h"
#include "tricover/collide.h"

namespace tricover::detail {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// A double of any magnitude, now and then special.
double anyDouble(Random& random) {
  switch (random() % 12) {
    case 0:
      return 0;
    case 1:
      return std::numeric_limits<double>::denorm_min() * static_cast<double>(random() % 8);
    case 2:
      return std::numeric_limits<double>::max() * (random() % 2 ? 1 : -1);
    case 3:
      return static_cast<double>(random() % 9) - 4;
    default:
      return std::ldexp(uniform(random, -1, 1), static_cast<int>(random() % 2096) - 1072);
  }
}

struct ExactPoint {
  mpq_class x, y;
};

ExactPoint posed(const PosedPoint& p) {
  if (p.pose == nullptr) return {p.local.x(), p.local.y()};
  const auto& m = p.pose->matrix();
  return {mpq_class(m(0, 0)) * p.local.x() + mpq_class(m(0, 1)) * p.local.y() + mpq_class(m(0, 2)),
          mpq_class(m(1, 0)) * p.local.x() + mpq_class(m(1, 1)) * p.local.y() + mpq_class(m(1, 2))};
}

int trueOrientation(const PosedPoint& p, const PosedPoint& q, const PosedPoint& r) {
  const ExactPoint a = posed(p), b = posed(q), c = posed(r);
  return sgn(mpq_class((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)));
}

enum class PoseKind { Double, Float, Mirrored };

Pose randomPose(Random& random, double reach, PoseKind kind) {
  const double angle = uniform(random, -4, 4);
  Pose pose = Pose::Identity();
  pose.linear() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  if (kind == PoseKind::Mirrored) pose.linear().col(1) *= -1;
  pose.translation() << uniform(random, -reach, reach), uniform(random, -reach, reach);
  if (kind == PoseKind::Float) pose.linear() = pose.linear().cast<float>().cast<double>().eval();
  return pose;
}

Polygon randomPolygon(Random& random, double size, double offset = 0) {
  Ring ring;
  const std::size_t n = 3 + random() % 10;
  for (std::size_t i = 0; i < n; ++i)
    ring.push_back(Vec2(offset + uniform(random, -size, size), offset + uniform(random, -size, size)));
  return Polygon({ring});
}

TEST(Dyadic, AgreesWithRationalsOverTheWholeRange) {
  Random random(1);
  std::array<int, 3> signs{};
  for (int i = 0; i < 20000; ++i) {
    const double a = anyDouble(random), b = anyDouble(random), c = anyDouble(random), d = anyDouble(random);
    // Nearly cancelling every other time: (a + e)(b - f) against a b.
    const bool near = i % 2 != 0;
    const double p = near ? std::nextafter(a, d) : c, q = near ? std::nextafter(b, -d) : d;
    if (!std::isfinite(p) || !std::isfinite(q)) continue;
    const Dyadic exact = (Dyadic(a) + Dyadic(c)) * Dyadic(b) - Dyadic(p) * Dyadic(q) + -(Dyadic(c) * Dyadic(b));
    const mpq_class truth =
        (mpq_class(a) + mpq_class(c)) * mpq_class(b) - mpq_class(p) * mpq_class(q) - mpq_class(c) * mpq_class(b);
    ASSERT_EQ(exact.sign(), sgn(truth)) << std::hexfloat << a << " " << b << " " << c << " " << p << " " << q;
    const Dyadic square = exact * exact - Dyadic(a) * Dyadic(a) * Dyadic(d) * Dyadic(d);
    ASSERT_EQ(square.sign(), sgn(mpq_class(truth * truth - mpq_class(a) * mpq_class(a) * mpq_class(d) * mpq_class(d))));
    ++signs[static_cast<std::size_t>(exact.sign() + 1)];
  }
  for (int count : signs) EXPECT_GT(count, 400);
}

TEST(OrientExact, IsAlternatingAndTrueUnderMixedPoses) {
  Random random(2);
  std::array<int, 3> signs{};
  for (int i = 0; i < 3000; ++i) {
    const double scale = i % 3 == 0 ? 1e300 : i % 3 == 1 ? 1e-300 : 1;
    const PoseKind kind = i % 2 != 0 ? PoseKind::Mirrored : PoseKind::Float;
    const Pose one = randomPose(random, scale, PoseKind::Double), two = randomPose(random, scale, kind);
    const Vec2 v(uniform(random, -scale, scale), uniform(random, -scale, scale));
    std::array<PosedPoint, 3> p{PosedPoint{&one, v}, PosedPoint{&two, Vec2(-v.y(), v.x())}, PosedPoint{nullptr, v}};
    if (i % 4 == 0) p[2] = p[0];                      // repeated: 0
    if (i % 4 == 1) p[2] = PosedPoint{&one, -2 * v};  // p[1] off the line, or
    if (i % 8 == 1) p[1] = PosedPoint{&one, 4 * v};   // exactly collinear under one pose
    const int sign = orientExact(p[0], p[1], p[2]);
    ASSERT_EQ(sign, trueOrientation(p[0], p[1], p[2])) << i;
    ASSERT_EQ(orientExact(p[1], p[2], p[0]), sign);
    ASSERT_EQ(orientExact(p[2], p[0], p[1]), sign);
    ASSERT_EQ(orientExact(p[1], p[0], p[2]), -sign);
    ASSERT_EQ(orientExact(p[0], p[2], p[1]), -sign);
    ASSERT_EQ(orientExact(p[2], p[1], p[0]), -sign);
    ++signs[static_cast<std::size_t>(sign + 1)];
  }
  for (int count : signs) EXPECT_GT(count, 300);
}

/// A point off the line of two others by 2^-40 down to 2^-120 of their size: beyond what doubles tell, and beyond what
/// two of them tell. It is given by a pose that adds low digits to high ones.
TEST(OrientExact, IsRightWithinRoundingOfALine) {
  Random random(9);
  int agreed = 0, zeros = 0, right = 0;
  for (int i = 0; i < 20000; ++i) {
    const bool tiny = i % 16 == 0;  // and the third one far away
    const int exponent = tiny ? -1000 : i % 4 == 0 ? static_cast<int>(random() % 1200) - 800 : 0;
    const double scale = std::ldexp(1, exponent), offset = i % 3 == 0 ? 1e6 * scale : 0;
    const Pose one = randomPose(random, i % 3 == 1 ? 1e6 * scale : scale, PoseKind::Double);
    const auto local = [&] { return Vec2(offset + uniform(random, -scale, scale), uniform(random, -scale, scale)); };
    const PosedPoint p{&one, local()}, q{&one, local()};
    const ExactPoint from = posed(p), to = posed(q);
    const mpq_class part = uniform(random, -1, 2) * mpq_class(tiny ? 0x1p1000 : 1) * mpq_class(tiny ? 0x1p300 : 1);
    const double off = std::ldexp(uniform(random, -1, 1), -40 - static_cast<int>(random() % 80));
    const mpq_class x = from.x + part * (to.x - from.x) + off * (to.y - from.y);
    const mpq_class y = from.y + part * (to.y - from.y) - off * (to.x - from.x);
    Pose pose_r = Pose::Identity();
    pose_r.linear() *= 0x1p-40;
    pose_r.translation() << x.get_d(), y.get_d();
    const mpq_class low_x = (x - pose_r.translation().x()) * mpq_class(0x1p40);
    const mpq_class low_y = (y - pose_r.translation().y()) * mpq_class(0x1p40);
    const PosedPoint r{&pose_r, Vec2(low_x.get_d(), low_y.get_d())};
    const int truth = trueOrientation(p, q, r);
    ASSERT_EQ(orientExact(p, q, r), truth) << i << " " << std::hexfloat << off << " " << scale;
    ASSERT_EQ(orientExact(r, q, p), -truth) << i;
    agreed += truth == (off > 0 ? -1 : 1);
    zeros += truth == 0;
    right += truth < 0;
  }
  EXPECT_GT(agreed, 15000);
  EXPECT_LT(agreed, 20000) << "none beyond the digits of two doubles";
  EXPECT_LT(zeros, 2000);
  EXPECT_GT(right, 8000);
  EXPECT_LT(right, 12000);
}

TEST(OrientExact, IsRightWhereProductsUnderflowOrOverflow) {
  const auto orient = [](Vec2 p, Vec2 q, Vec2 r) { return orientation(p, q, r); };
  EXPECT_EQ(orient({1e-170, 0}, {0, 1e-170}, {0, 0}), 1);
  EXPECT_EQ(orient({0, 0}, {1e-300, 1e-300}, {2e-300, 2e-300}), 0);
  EXPECT_EQ(orient({0, 0}, {1e-300, 1e-300}, {2e-300, 2e-300 * (1 + 1e-15)}), 1);
  EXPECT_EQ(orient({0, 0}, {5e-324, 0}, {0, 5e-324}), 1);
  EXPECT_EQ(orient({-1e308, -1e308}, {1e308, 1e308}, {0, 5e-324}), 1);
  EXPECT_EQ(orient({-1e308, -1e308}, {1e308, 1e308}, {0, 0}), 0);
  EXPECT_EQ(orient({0, 0}, {1e150, 1e-150}, {1e-150, 1e150}), 1);
  EXPECT_EQ(orient({0, 0}, {1e150, 1e-150}, {1e300, 1}),
            orientExact({nullptr, {0, 0}}, {nullptr, {1e150, 1e-150}}, {nullptr, {1e300, 1}}));
}

TEST(CompareAndBetween, FollowTheExactCoordinates) {
  const Pose quarter = [] {
    Pose pose = Pose::Identity();
    pose.linear() << 0, -1, 1, 0;
    pose.translation() << 1e15, 1;
    return pose;
  }();
  const PosedPoint p{&quarter, Vec2(3, 0x1p-60)};  // at (1e15 - 2^-60, 4): rounds to (1e15, 4)
  EXPECT_EQ(compareExact(p, {nullptr, Vec2(1e15, 4)}, 0), -1);
  EXPECT_EQ(compareExact(p, {nullptr, Vec2(1e15, 4)}, 1), 0);
  EXPECT_EQ(compareExact({nullptr, Vec2(1e15, 5)}, p, 1), 1);
  const PosedPoint o{nullptr, Vec2(0, 0)}, e{nullptr, Vec2(2, 2)};
  EXPECT_TRUE(betweenExact({nullptr, Vec2(1, 1)}, o, e));
  EXPECT_TRUE(betweenExact(o, o, e));
  EXPECT_TRUE(betweenExact(e, o, e));
  EXPECT_TRUE(betweenExact(o, o, o));
  EXPECT_FALSE(betweenExact({nullptr, Vec2(2.5, 2.5)}, o, e));
  EXPECT_FALSE(betweenExact({nullptr, Vec2(-5e-324, -5e-324)}, o, e));
  EXPECT_FALSE(betweenExact({nullptr, Vec2(0, 3)}, o, {nullptr, Vec2(0, 2)}));
  EXPECT_FALSE(betweenExact({nullptr, Vec2(3, 0)}, o, {nullptr, Vec2(2, 0)}));
}

TEST(WithinExact, DecidesEqualityAndItsNeighbours) {
  const PosedPoint v{nullptr, Vec2(0, 0)}, w{nullptr, Vec2(8, 6)};
  const auto within = [&](Vec2 p, double length) { return withinExact({nullptr, p}, v, w, length); };
  for (const auto& [p, distance] :
       {std::pair<Vec2, double>{{4 - 3, 3 + 4}, 5}, {{-3, -4}, 5}, {{11, 10}, 5}, {{4, 3}, 0}}) {
    EXPECT_TRUE(within(p, distance));
    if (distance == 0) continue;
    EXPECT_FALSE(within(p, std::nextafter(distance, 0.0)));
    EXPECT_FALSE(within(p * (1 + 0x1p-40), distance) && within(p + 0x1p-40 * Vec2(-3, 4), distance));
  }
  EXPECT_TRUE(withinExact({nullptr, Vec2(3e-200, 4e-200)}, v, v, 5e-200 * (1 + 1e-15)));
  EXPECT_FALSE(withinExact({nullptr, Vec2(3e200, 4e200)}, v, v, 5e200 * (1 - 1e-15)));
}

/// Places where lines meet, over the whole range and on a lattice, where they are often exactly as far away, or at the
/// foot.
TEST(MeetingExact, AgreesWithRationals) {
  Random random(9);
  std::array<int, 3> feet{}, distances{};
  for (int i = 0; i < 6000; ++i) {
    const bool is_any = i % 8 == 0;
    const auto number = [&] { return is_any ? anyDouble(random) : static_cast<double>(random() % 13) - 6; };
    Pose pose = Pose::Identity();
    if (is_any) {
      for (const int k : {0, 1, 2, 3})
        pose.linear()(k / 2, k % 2) = std::ldexp(uniform(random, -1, 1), -static_cast<int>(random() % 1075));
      pose.translation() = Vec2(number(), number());
    }
    std::array<Vec2, 6> points;
    for (Vec2& p : points) p = Vec2(number(), number());
    const PosedSegment ray{&pose, &points[0]}, edge{nullptr, &points[2]}, other{&pose, &points[4]};
    const auto minus = [](const ExactPoint& p, const ExactPoint& q) { return ExactPoint{p.x - q.x, p.y - q.y}; };
    const auto dot = [](const ExactPoint& u, const ExactPoint& w) { return mpq_class(u.x * w.x + u.y * w.y); };
    const auto cross = [](const ExactPoint& u, const ExactPoint& w) { return mpq_class(u.x * w.y - u.y * w.x); };
    const ExactPoint from = posed(ray[0]), d = minus(posed(ray[1]), from), u = minus(posed(edge[1]), posed(edge[0]));
    const ExactPoint v = posed(other[0]), way = minus(posed(other[1]), v);
    if (cross(d, u) == 0 || dot(way, way) == 0) continue;
    const mpq_class s = cross(minus(posed(edge[0]), from), u) / cross(d, u);
    const int foot = sgn(mpq_class(dot(minus(v, from), d) / dot(d, d) - s));
    ASSERT_EQ(compareFootExact(other[0], ray, edge), foot) << i;
    ++feet[static_cast<std::size_t>(foot + 1)];
    const ExactPoint at{from.x + s * d.x - v.x, from.y + s * d.y - v.y};
    mpq_class along = dot(at, way) / dot(way, way);
    along = along < 0 ? mpq_class(0) : along > 1 ? mpq_class(1) : along;
    const ExactPoint apart{at.x - along * way.x, at.y - along * way.y};
    const double length = std::abs(number());
    const int order = sgn(mpq_class(dot(apart, apart) - mpq_class(length) * mpq_class(length)));
    ASSERT_EQ(meetingWithinExact(ray, edge, other, length), order < 0) << i;
    ++distances[static_cast<std::size_t>(order + 1)];
  }
  for (const int count : feet) EXPECT_GT(count, 10);
  for (const int count : distances) EXPECT_GT(count, 10);
}

TEST(OrientFilter, IsNeverWrongAndSeldomUncertain) {
  Random random(3);
  int uncertain_generic = 0, uncertain_near = 0, decided_near = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec2 p(uniform(random, -1, 1), uniform(random, -1, 1)), q(uniform(random, -1, 1), uniform(random, -1, 1));
    const bool near = i % 2 != 0;
    const Vec2 on_line = p + uniform(random, -1, 2) * (q - p);
    const double nudge = std::ldexp(uniform(random, -1, 1), -static_cast<int>(random() % 30) - 35);
    const Vec2 r = near ? Vec2(on_line + nudge * Vec2(1, -1)) : Vec2(uniform(random, -1, 1), uniform(random, -1, 1));
    const int sign = orientFilter({p.x(), p.y(), 0}, {q.x(), q.y(), 0}, {r.x(), r.y(), 0});
    if (sign == kUncertain) {
      ++(near ? uncertain_near : uncertain_generic);
      continue;
    }
    decided_near += near;
    ASSERT_EQ(sign, trueOrientation({nullptr, p}, {nullptr, q}, {nullptr, r}));
  }
  EXPECT_LE(uncertain_generic, 2);
  EXPECT_GT(uncertain_near, 1000);
  EXPECT_GT(decided_near, 3000);
}

/// Points moved by up to their stated errors keep the filter's sign, in whichever of the three roles the errors are.
TEST(OrientFilter, HoldsForEveryPointWithinTheErrors) {
  Random random(4);
  int decided = 0, uncertain = 0;
  for (int i = 0; i < 30000; ++i) {
    std::array<ApproxPoint, 3> approx;
    std::array<Vec2, 3> exact;
    for (std::size_t k = 0; k < 3; ++k) {
      const double error = (i >> k) % 2 != 0 ? std::ldexp(1.0, -static_cast<int>(random() % 12)) : 0;
      approx[k] = {uniform(random, -1, 1), uniform(random, -1, 1), error};
      // The corners of the error box are the worst.
      exact[k] = Vec2(approx[k].x + (random() % 2 ? error : -error), approx[k].y + (random() % 2 ? error : -error));
    }
    const int sign = orientFilter(approx[0], approx[1], approx[2]);
    if (sign == kUncertain) {
      ++uncertain;
      continue;
    }
    ++decided;
    ASSERT_EQ(sign, trueOrientation({nullptr, exact[0]}, {nullptr, exact[1]}, {nullptr, exact[2]}));
  }
  EXPECT_GT(decided, 3000);
  EXPECT_GT(uncertain, 3000);
}

TEST(OrientFilter, LeavesOverflowAndUnderflowToTheExactStage) {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(orientFilter({0, 0, 0}, {1e200, 0, 0}, {0, 1e200, 0}), kUncertain);
  EXPECT_EQ(orientFilter({0, 0, 0}, {1e-200, 0, 0}, {0, 1e-200, 0}), kUncertain);
  EXPECT_EQ(orientFilter({0, 0, 0}, {1, 0, inf}, {0, 1, 0}), kUncertain);
  EXPECT_EQ(orientFilter({0, 0, 0}, {1, 0, nan}, {0, 1, 0}), kUncertain);
  EXPECT_EQ(orientFilter({0, 0, 0}, {inf, 0, 0}, {0, 1, 0}), kUncertain);
  EXPECT_EQ(orientFilter({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 1);
  EXPECT_EQ(orientFilter({0, 0, 0}, {0, 1, 0}, {1, 0, 0}), -1);
}

TEST(PosedPair, MapsWithinItsStatedErrorWhichIsSmall) {
  Random random(5);
  for (int i = 0; i < 3000; ++i) {
    const auto kind = static_cast<PoseKind>(i % 3);
    const double offset = i % 5 == 0 ? 1e9 : 0, reach = i % 7 == 0 ? 1e12 : 3, size = i % 11 == 0 ? 1e-6 : 1;
    const Polygon a = randomPolygon(random, 1), b = randomPolygon(random, size, offset);
    const Pose pose_a = randomPose(random, reach, kind), pose_b = randomPose(random, reach, PoseKind::Double);
    const PosedPair pair(a.data(), pose_a, b.data(), pose_b);
    ASSERT_LT(pair.errorOfA(), 16 * kUnitRoundoff * (4 * offset + 4));
    ASSERT_LT(pair.errorOfB(), 16 * kUnitRoundoff * (4 * reach + 4 * offset + 4));
    const auto isWithin = [](const mpq_class& x, const mpq_class& y, const ApproxPoint& mapped) {
      return abs(mpq_class(x - mapped.x)) <= mapped.error && abs(mpq_class(y - mapped.y)) <= mapped.error;
    };
    const auto& m = pose_a.matrix();
    const mpq_class det = mpq_class(m(0, 0)) * m(1, 1) - mpq_class(m(0, 1)) * m(1, 0);
    ASSERT_EQ(detail::isMirrored(pose_a), sgn(det) < 0);
    for (const Vec2& p : a.data().path) {
      const ExactPoint world = posed({&pose_a, p});
      ASSERT_TRUE(isWithin(world.x - m(0, 2), world.y - m(1, 2), pair.fromA(p)));
    }
    for (const Vec2& p : b.data().path) {
      const ExactPoint world = posed({&pose_b, p});
      const mpq_class dx = world.x - m(0, 2), dy = world.y - m(1, 2);
      ASSERT_TRUE(isWithin(dx, dy, pair.fromB(p)));
      const mpq_class x = (m(1, 1) * dx - m(0, 1) * dy) / det, y = (m(0, 0) * dy - m(1, 0) * dx) / det;
      const ApproxPoint seen = detail::seenFromA(pair, p).approx;
      ASSERT_TRUE(isWithin(x, y, seen));
      ASSERT_LT(seen.error, 64 * kUnitRoundoff * (4 * reach + 4 * offset + 4));
    }
  }
}

/// Each end of either edge, alone, at exactly the margin: the exact stage decides.
TEST(EdgesWithin, HoldsEveryEndAtExactlyTheMargin) {
  const Polygon a({{{0, 0}, {8, 0}, {4, -9}}}), down({{{4, 30}, {4, 5}, {30, 30}}}), up({{{4, 5}, {4, 30}, {30, 30}}});
  const Pose identity = Pose::Identity();
  const auto within = [&](const Polygon& p, const Polygon& q, double reach) {
    const PosedPair pair(p.data(), identity, q.data(), identity);
    const std::uint64_t before = exactCalls();
    const bool result = edgesWithin(pair, 0, 0, reach, 0);
    EXPECT_GT(exactCalls(), before);
    return result;
  };
  for (const Polygon& b : {down, up}) {
    EXPECT_TRUE(within(a, b, 5));
    EXPECT_TRUE(within(b, a, 5));
    EXPECT_FALSE(within(a, b, std::nextafter(5.0, 0.0)));
    EXPECT_FALSE(within(b, a, std::nextafter(5.0, 0.0)));
  }
}

TEST(Stages, TheFilterAnswersWhatIsApartOrCrossingAndTheExactStageWhatTouches) {
  Random random(6);
  const Polygon square({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  int hits = 0;
  const std::uint64_t before = exactCalls();
  for (int i = 0; i < 4000; ++i) {
    const Pose pose_a = randomPose(random, 1, PoseKind::Double), pose_b = randomPose(random, 1, PoseKind::Mirrored);
    hits += collide(square, pose_a, square, pose_b);
  }
  EXPECT_LE(exactCalls() - before, 4u) << "random poses are not the exact stage's business";
  EXPECT_GT(hits, 1200);
  EXPECT_LT(hits, 3600);

  Pose right = Pose::Identity();
  right.translation().x() = 1;
  const std::uint64_t touching = exactCalls();
  EXPECT_TRUE(collide(square, Pose::Identity(), square, right));
  EXPECT_GT(exactCalls(), touching) << "a touch can't be a filter's answer";
  right.translation().x() = std::nextafter(1.0, 2.0);
  EXPECT_FALSE(collide(square, Pose::Identity(), square, right));
}

}  // namespace
}  // namespace tricover::detail
