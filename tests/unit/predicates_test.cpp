// SPDX-License-Identifier: BSD-3-Clause
// Signs of exact points, and two polygons under their poses, stage by stage, through private headers: an exact fallback
// must not hide a broken filter.
#include "numbers/predicates.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "hierarchy/unit_map.h"
#include "numbers/dyadic.h"
#include "pair/posed_pair.h"
#include "pair/world_frame.h"
#include "random.h"
#include "shapes.h"
#include "test_scale.h"

namespace tricover::support {
namespace {

using namespace detail;

/// A double of any magnitude, now and then special.
double anyDouble(Random& random) {
  const int kind = random.integer(0, 11);
  if (kind == 0) return 0;
  if (kind == 1) return std::numeric_limits<double>::denorm_min() * random.integer(0, 7);
  if (kind == 2) return std::numeric_limits<double>::max() * (random.coin() ? 1 : -1);
  if (kind == 3) return random.integer(-4, 4);
  return std::ldexp(random.real(-1, 1), random.integer(-1072, 1023));
}

Vec2 anyPoint(Random& random, double reach) { return {random.real(-reach, reach), random.real(-reach, reach)}; }

Pose turnedByFloats(Pose pose) {
  pose.linear() = throughFloat(pose).linear();
  return pose;
}

struct Exact {
  mpq_class x, y;
};
Exact exactly(const Vec2& v) { return {v.x(), v.y()}; }
Exact operator-(const Exact& p, const Exact& q) { return {p.x - q.x, p.y - q.y}; }
mpq_class dot(const Exact& u, const Exact& w) { return u.x * w.x + u.y * w.y; }
mpq_class cross(const Exact& u, const Exact& w) { return u.x * w.y - u.y * w.x; }
mpq_class square(const Exact& u) { return dot(u, u); }

Exact turned(const Pose& pose, const Vec2& v) {
  const auto& m = pose.matrix();
  return {mpq_class(m(0, 0)) * v.x() + mpq_class(m(0, 1)) * v.y(),
          mpq_class(m(1, 0)) * v.x() + mpq_class(m(1, 1)) * v.y()};
}

Exact posed(const PosedPoint& p) {
  if (p.pose == nullptr) return exactly(p.local);
  const Exact v = turned(*p.pose, p.local);
  return {v.x + p.pose->translation().x(), v.y + p.pose->translation().y()};
}

/// Through the pose's exact inverse.
Exact turnedBack(const Pose& pose, const Exact& v) {
  const auto& m = pose.matrix();
  const mpq_class det = mpq_class(m(0, 0)) * m(1, 1) - mpq_class(m(0, 1)) * m(1, 0);
  return {(m(1, 1) * v.x - m(0, 1) * v.y) / det, (m(0, 0) * v.y - m(1, 0) * v.x) / det};
}

int trueOrientation(const PosedPoint& p, const PosedPoint& q, const PosedPoint& r) {
  return sgn(cross(posed(q) - posed(p), posed(r) - posed(p)));
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
    const Pose one = randomPose(random, scale), other = randomPose(random, scale);
    const Pose two = i % 2 != 0 ? mirrored(other) : turnedByFloats(other);
    const Vec2 v = anyPoint(random, scale);
    std::array<PosedPoint, 3> p{PosedPoint{&one, v}, PosedPoint{&two, Vec2(-v.y(), v.x())}, PosedPoint{nullptr, v}};
    if (i % 4 == 0) p[2] = p[0];                      // repeated: 0
    if (i % 4 == 1) p[2] = PosedPoint{&one, -2 * v};  // p[1] off the line, or
    if (i % 8 == 1) p[1] = PosedPoint{&one, 4 * v};   // exactly collinear under one pose
    const int sign = orientExact(p[0], p[1], p[2]);
    ASSERT_EQ(sign, trueOrientation(p[0], p[1], p[2])) << i;
    for (const std::size_t k : {0u, 1u, 2u}) {
      ASSERT_EQ(orientExact(p[k], p[(k + 1) % 3], p[(k + 2) % 3]), sign);
      ASSERT_EQ(orientExact(p[k], p[(k + 2) % 3], p[(k + 1) % 3]), -sign);
    }
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
    const int exponent = tiny ? -1000 : i % 4 == 0 ? random.integer(-800, 399) : 0;
    const double scale = std::ldexp(1, exponent), offset = i % 3 == 0 ? 1e6 * scale : 0;
    const Pose one = randomPose(random, i % 3 == 1 ? 1e6 * scale : scale);
    const auto local = [&] { return Vec2(Vec2(offset, offset) + anyPoint(random, scale)); };
    const PosedPoint p{&one, local()}, q{&one, local()};
    const Exact from = posed(p), way = posed(q) - from;
    const mpq_class part = random.real(-1, 2) * mpq_class(tiny ? 0x1p1000 : 1) * mpq_class(tiny ? 0x1p300 : 1);
    const double off = std::ldexp(random.real(-1, 1), -random.integer(40, 119));
    const mpq_class x = from.x + part * way.x + off * way.y, y = from.y + part * way.y - off * way.x;
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
  const Pose quarter = pose(0, -1, 1e15, 1, 0, 1);
  const PosedPoint p{&quarter, Vec2(3, 0x1p-60)};  // at (1e15 - 2^-60, 4): rounds to (1e15, 4)
  EXPECT_EQ(compareExact(p, {nullptr, Vec2(1e15, 4)}, 0), -1);
  EXPECT_EQ(compareExact(p, {nullptr, Vec2(1e15, 4)}, 1), 0);
  EXPECT_EQ(compareExact({nullptr, Vec2(1e15, 5)}, p, 1), 1);
  const auto between = [](const Vec2& at, const Vec2& end) {
    return betweenExact({nullptr, at}, {nullptr, Vec2(0, 0)}, {nullptr, end});
  };
  for (const Vec2& at : {Vec2(1, 1), Vec2(0, 0), Vec2(2, 2)}) EXPECT_TRUE(between(at, {2, 2}));
  EXPECT_TRUE(between({0, 0}, {0, 0}));
  for (const Vec2& at : {Vec2(2.5, 2.5), Vec2(-5e-324, -5e-324)}) EXPECT_FALSE(between(at, {2, 2}));
  EXPECT_FALSE(between({0, 3}, {0, 2}));
  EXPECT_FALSE(between({3, 0}, {2, 0}));
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
    const auto number = [&] { return is_any ? anyDouble(random) : double(random.integer(-6, 6)); };
    Pose pose = Pose::Identity();
    if (is_any) {
      for (const int k : {0, 1, 2, 3})
        pose.linear()(k / 2, k % 2) = std::ldexp(random.real(-1, 1), -random.integer(0, 1074));
      pose.translation() = Vec2(number(), number());
    }
    std::array<Vec2, 6> points;
    for (Vec2& p : points) p = Vec2(number(), number());
    const PosedSegment ray{&pose, &points[0]}, edge{nullptr, &points[2]}, other{&pose, &points[4]};
    const Exact from = posed(ray[0]), d = posed(ray[1]) - from, u = posed(edge[1]) - posed(edge[0]);
    const Exact v = posed(other[0]), way = posed(other[1]) - v;
    if (cross(d, u) == 0 || square(way) == 0) continue;
    const mpq_class s = cross(posed(edge[0]) - from, u) / cross(d, u);
    const int foot = sgn(mpq_class(dot(v - from, d) / dot(d, d) - s));
    ASSERT_EQ(compareFootExact(other[0], ray, edge), foot) << i;
    ++feet[static_cast<std::size_t>(foot + 1)];
    const Exact at = Exact{from.x + s * d.x, from.y + s * d.y} - v;
    mpq_class along = dot(at, way) / square(way);
    along = along < 0 ? mpq_class(0) : along > 1 ? mpq_class(1) : along;
    const Exact apart{at.x - along * way.x, at.y - along * way.y};
    const double length = std::abs(number());
    const int order = sgn(mpq_class(square(apart) - mpq_class(length) * mpq_class(length)));
    ASSERT_EQ(meetingWithinExact(ray, edge, other, length), order < 0) << i;
    ++distances[static_cast<std::size_t>(order + 1)];
  }
  for (const int count : feet) EXPECT_GT(count, 10);
  for (const int count : distances) EXPECT_GT(count, 10);
}

/// Points moved by up to their stated errors keep the filter's sign, in whichever of the three roles the errors are.
TEST(OrientFilter, IsNeverWrongAndSeldomUncertain) {
  Random random(3);
  int decided[3] = {}, uncertain[3] = {};  // of points anywhere, near a line, with errors
  for (int i = 0; i < 50000; ++i) {
    const int kind = std::min(i % 5, 2);
    std::array<ApproxPoint, 3> approx;
    std::array<Vec2, 3> exact;
    for (std::size_t k = 0; k < 3; ++k) {
      Vec2 p = anyPoint(random, 1);
      const double nudge = std::ldexp(random.real(-1, 1), -random.integer(35, 64)), part = random.real(-1, 2);
      if (kind == 1 && k == 2) p = exact[0] + part * (exact[1] - exact[0]) + nudge * Vec2(1, -1);
      const double error = kind == 2 && random.coin() ? std::ldexp(1.0, -random.integer(0, 11)) : 0;
      approx[k] = {p.x(), p.y(), error};
      // The corners of the error box are the worst.
      exact[k] = p + error * Vec2(random.coin() ? 1 : -1, random.coin() ? 1 : -1);
    }
    const int sign = orientFilter(approx[0], approx[1], approx[2]);
    ++(sign == kUncertain ? uncertain : decided)[kind];
    if (sign == kUncertain) continue;
    ASSERT_EQ(sign, trueOrientation({nullptr, exact[0]}, {nullptr, exact[1]}, {nullptr, exact[2]}));
  }
  EXPECT_LE(uncertain[0], 2);
  EXPECT_GT(uncertain[1], 1000);
  EXPECT_GT(decided[1], 3000);
  EXPECT_GT(uncertain[2], 3000);
  EXPECT_GT(decided[2], 3000);
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

static_assert(std::is_constructible_v<PosedPair, const detail::PolygonData&, Pose&, const detail::PolygonData&, Pose&>);
static_assert(!std::is_constructible_v<PosedPair, const detail::PolygonData&, Pose, const detail::PolygonData&, Pose&>);
static_assert(!std::is_constructible_v<PosedPair, const detail::PolygonData&, Pose&, const detail::PolygonData&, Pose>);

TEST(PosedPair, MapsWithinItsStatedErrorWhichIsSmall) {
  Random random(5);
  for (int i = 0; i < 3000; ++i) {
    const double offset = i % 5 == 0 ? 1e9 : 0, reach = i % 7 == 0 ? 1e12 : 3, size = i % 11 == 0 ? 1e-6 : 1;
    const Polygon a({star(random, random.integer(3, 12), 0, 1)});
    const Polygon b({star(random, random.integer(3, 12), 0, size, {offset, offset})});
    const Pose rigid = randomPose(random, reach), pose_b = randomPose(random, reach);
    const Pose pose_a = i % 3 == 0 ? rigid : i % 3 == 1 ? turnedByFloats(rigid) : mirrored(rigid);
    const PosedPair pair(detail::dataOf(a), pose_a, detail::dataOf(b), pose_b);
    ASSERT_LT(pair.errorOfA(), 16 * kUnitRoundoff * (4 * offset + 4));
    ASSERT_LT(pair.errorOfB(), 16 * kUnitRoundoff * (4 * reach + 4 * offset + 4));
    ASSERT_EQ(isMirrored(pose_a), i % 3 == 2);
    const auto isWithin = [](const Exact& p, const ApproxPoint& mapped) {
      return abs(mpq_class(p.x - mapped.x)) <= mapped.error && abs(mpq_class(p.y - mapped.y)) <= mapped.error;
    };
    const Exact here = exactly(pose_a.translation());
    for (const Vec2& p : detail::dataOf(a).path) ASSERT_TRUE(isWithin(posed({&pose_a, p}) - here, pair.fromA(p)));
    for (const Vec2& p : detail::dataOf(b).path) {
      const Exact world = posed({&pose_b, p}) - here;
      ASSERT_TRUE(isWithin(world, pair.fromB(p)));
      const ApproxPoint seen = seenFromA(pair, p).approx;
      ASSERT_TRUE(isWithin(turnedBack(pose_a, world), seen));
      ASSERT_LT(seen.error, 64 * kUnitRoundoff * (4 * reach + 4 * offset + 4));
    }
  }
}

/// Also where poses are rigid only as far as is allowed, and where the origins are far from the polygons.
TEST(UnitMap, MapsWithinItsErrorAndItsDefect) {
  Random random(13);
  int large = 0, larger_than_rounding = 0;
  const int asked = scaledCount(300);
  for (int i = 0; i < asked; ++i) {
    const double far = i % 2 ? std::ldexp(1.0, random.integer(0, 30)) : 1;
    const auto placed = [&](double size) {
      const Vec2 center(random.real(-far, far), random.real(-far, far));
      return Polygon({shifted(rectangle(-size, -size / 2, size, size / 3), center)});
    };
    const Polygon polygon_a = placed(2), polygon_b = placed(i % 5 ? 1.5 : 1e-3);
    const auto &a = detail::dataOf(polygon_a), &b = detail::dataOf(polygon_b);
    const auto wrong = [&](Pose pose) { return i % 3 ? distorted(random, std::move(pose)) : pose; };
    const Pose turned_a = wrong(randomPose(random, 2)), pose_b = wrong(mirrored(randomPose(random, 2)));
    Pose pose_a = turned_a;
    pose_a.translation() += pose_b * b.origin - turned_a * a.origin;
    const PosedPair pair(a, pose_a, b, pose_b);
    const bool is_inverse = i % 7 < 3;
    const double defect = defectOf(pose_a, pose_b);
    const UnitMap map = is_inverse ? pair.inUnits() : pair.inUnits(defect);
    const Exact origin = posed({&pose_a, a.origin});
    const mpq_class unit(a.unit), error(map.error), scale(map.scale);
    for (const Vec2& v : b.path) {
      const Exact world = posed({&pose_b, v});
      const Exact truth = turnedBack(pose_a, world - origin);
      const mpq_class x = scale * (mpq_class(v.x()) - b.origin.x()) / b.unit;
      const mpq_class y = scale * (mpq_class(v.y()) - b.origin.y()) / b.unit;
      const Exact off{truth.x / unit - (map.r00 * x + map.r01 * y + map.tx),
                      truth.y / unit - (map.r10 * x + map.r11 * y + map.ty)};
      ASSERT_TRUE(square(off) <= error * error) << i;
      large += 1000 * 1000 * square(off) > error * error;
    }
    const Vec2 v(random.real(-1, 1), random.real(-1, 1));
    const mpq_class length = square(exactly(v));
    const Exact mapped{map.r00 * mpq_class(v.x()) + map.r01 * mpq_class(v.y()),
                       map.r10 * mpq_class(v.x()) + map.r11 * mpq_class(v.y())};
    const mpq_class low = 1 - mpq_class(defect), high = 1 + mpq_class(defect);
    for (const mpq_class& square : {square(mapped), square(turnedBack(pose_a, turned(pose_b, v)))})
      ASSERT_TRUE(low * low * length <= square && square <= high * high * length) << i;
    const mpq_class in_world = square(turned(pose_a, v)), least = 1 - mpq_class(map.scale_defect),
                    most = 1 + mpq_class(map.scale_defect);
    ASSERT_TRUE(least * least * length <= in_world && in_world <= most * most * length) << i;
    larger_than_rounding += map.scale_defect > 1e-8;
  }
  EXPECT_GE(large, asked) << "of four vertices each: the bound is worth something";
  EXPECT_GE(larger_than_rounding, asked / 2);
  EXPECT_LE(larger_than_rounding, 0.9 * asked);
}

/// What is authored far from its origin and posed back near the world's: all of a pose but some bits cancels.
TEST(WorldFrame, MapsWithinItsErrorWhereOriginsCancel) {
  Random random(12);
  int cancelled = 0;
  const int asked = scaledCount(500);
  for (int i = 0; i < asked; ++i) {
    const double far = std::ldexp(1.0, random.integer(0, 40));
    const Vec2 center_a(random.real(-far, far), random.real(-far, far)), center_b = Vec2(random.real(-1, 1), 0.5);
    const Polygon a({shifted(rectangle(-1, -1, 1, 1), center_a)}), b({shifted(rectangle(-2, -1, 2, 1), center_b)});
    Pose pose_a = randomPose(random, 1);
    pose_a.translation() -= pose_a.linear() * center_a;
    const Pose pose_b = randomPose(random, 1);
    const PosedPair pair(detail::dataOf(a), pose_a, detail::dataOf(b), pose_b);
    const WorldFrame frame(pair);
    const Exact origin = posed({&pose_b, pair.b.origin});
    for (const Vec2& v : pair.a.path) {
      const Exact truth = posed({&pose_a, v});
      const Vec2 mapped = frame.fromA(v);
      const mpq_class unit(frame.unit());
      const Exact wrong{(truth.x - origin.x) / unit - mapped.x(), (truth.y - origin.y) / unit - mapped.y()};
      ASSERT_LE(square(wrong), mpq_class(frame.error()) * frame.error()) << i;
    }
    cancelled += frame.error() * frame.unit() < 1e-2 * far * 0x1p-52;
  }
  EXPECT_GE(cancelled, 0.5 * asked) << "of doubles, an ulp of where they cancel would be lost";
}

TEST(WorldFrame, IsInfiniteOnlyBeyondTheLargestDouble) {
  const Polygon a({rectangle(-1e307, -1e307, 1e307, 1e307)}), b({rectangle(4e307, -1e307, 1.4e308, 1e307)});
  const Pose here = Pose::Identity(), right = turnedAndMoved(0, 1.1e308, 0);
  const PosedPair pair(detail::dataOf(a), here, detail::dataOf(b), right);
  const WorldFrame frame(pair);
  const Vec2 left = frame.toWorld(frame.fromB({4e307, 1e307}));  // b's S is at 2e308
  EXPECT_NEAR(left.x(), 1.5e308, 1e295);
  EXPECT_NEAR(left.y(), 1e307, 1e295);
  EXPECT_EQ(frame.toWorld(frame.fromB({1.4e308, 1e307})).x(), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace tricover::support
