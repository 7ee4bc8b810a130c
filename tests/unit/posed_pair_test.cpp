// SPDX-License-Identifier: BSD-3-Clause
// Two polygons under their poses as filters and answers see them, against exact rationals.
#include "pair/posed_pair.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "hierarchy/unit_map.h"
#include "pair/world_frame.h"
#include "random.h"
#include "shapes.h"
#include "test_scale.h"

namespace tricover::support {
namespace {

using detail::PosedPair;
using detail::WorldFrame;

static_assert(std::is_constructible_v<PosedPair, const detail::PolygonData&, Pose&, const detail::PolygonData&, Pose&>);
static_assert(!std::is_constructible_v<PosedPair, const detail::PolygonData&, Pose, const detail::PolygonData&, Pose&>);
static_assert(!std::is_constructible_v<PosedPair, const detail::PolygonData&, Pose&, const detail::PolygonData&, Pose>);

struct ExactVector {
  mpq_class x, y;
  mpq_class square() const { return x * x + y * y; }
};

ExactVector turned(const Pose& pose, const Vec2& v) {
  const auto& m = pose.matrix();
  return {mpq_class(m(0, 0)) * v.x() + mpq_class(m(0, 1)) * v.y(),
          mpq_class(m(1, 0)) * v.x() + mpq_class(m(1, 1)) * v.y()};
}

ExactVector posed(const Pose& pose, const Vec2& p) {
  const ExactVector v = turned(pose, p);
  return {v.x + pose.translation().x(), v.y + pose.translation().y()};
}

/// Through the pose's exact inverse.
ExactVector turnedBack(const Pose& pose, const ExactVector& v) {
  const auto& m = pose.matrix();
  const mpq_class det = mpq_class(m(0, 0)) * m(1, 1) - mpq_class(m(0, 1)) * m(1, 0);
  return {(m(1, 1) * v.x - m(0, 1) * v.y) / det, (m(0, 0) * v.y - m(1, 0) * v.x) / det};
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
    const auto &a = polygon_a.data(), &b = polygon_b.data();
    const auto wrong = [&](Pose pose) { return i % 3 ? distorted(random, std::move(pose)) : pose; };
    const Pose turned_a = wrong(randomPose(random, 2)), pose_b = wrong(mirrored(randomPose(random, 2)));
    Pose pose_a = turned_a;
    pose_a.translation() += pose_b * b.origin - turned_a * a.origin;
    const PosedPair pair(a, pose_a, b, pose_b);
    const bool is_inverse = i % 7 < 3;
    const double defect = detail::defectOf(pose_a, pose_b);
    const detail::UnitMap map = is_inverse ? pair.inUnits() : pair.inUnits(defect);
    const ExactVector origin = posed(pose_a, a.origin);
    const mpq_class unit(a.unit), error(map.error), scale(map.scale);
    for (const Vec2& v : b.path) {
      const ExactVector world = posed(pose_b, v);
      const ExactVector truth = turnedBack(pose_a, {world.x - origin.x, world.y - origin.y});
      const mpq_class x = scale * (mpq_class(v.x()) - b.origin.x()) / b.unit;
      const mpq_class y = scale * (mpq_class(v.y()) - b.origin.y()) / b.unit;
      const ExactVector off{truth.x / unit - (map.r00 * x + map.r01 * y + map.tx),
                            truth.y / unit - (map.r10 * x + map.r11 * y + map.ty)};
      ASSERT_TRUE(off.square() <= error * error) << i;
      large += 1000 * 1000 * off.square() > error * error;
    }
    const Vec2 v(random.real(-1, 1), random.real(-1, 1));
    const mpq_class length = mpq_class(v.x()) * v.x() + mpq_class(v.y()) * v.y();
    const ExactVector mapped{map.r00 * mpq_class(v.x()) + map.r01 * mpq_class(v.y()),
                             map.r10 * mpq_class(v.x()) + map.r11 * mpq_class(v.y())};
    const mpq_class low = 1 - mpq_class(defect), high = 1 + mpq_class(defect);
    for (const mpq_class& square : {mapped.square(), turnedBack(pose_a, turned(pose_b, v)).square()})
      ASSERT_TRUE(low * low * length <= square && square <= high * high * length) << i;
    const mpq_class in_world = turned(pose_a, v).square(), least = 1 - mpq_class(map.scale_defect),
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
    const PosedPair pair(a.data(), pose_a, b.data(), pose_b);
    const WorldFrame frame(pair);
    const ExactVector origin = posed(pose_b, pair.b.origin);
    for (const Vec2& v : pair.a.path) {
      const ExactVector truth = posed(pose_a, v);
      const Vec2 mapped = frame.fromA(v);
      const mpq_class unit(frame.unit());
      const ExactVector wrong{(truth.x - origin.x) / unit - mapped.x(), (truth.y - origin.y) / unit - mapped.y()};
      ASSERT_LE(wrong.square(), mpq_class(frame.error()) * frame.error()) << i;
    }
    cancelled += frame.error() * frame.unit() < 1e-2 * far * 0x1p-52;
  }
  EXPECT_GE(cancelled, 0.5 * asked) << "of doubles, an ulp of where they cancel would be lost";
}

TEST(WorldFrame, IsInfiniteOnlyBeyondTheLargestDouble) {
  const Polygon a({rectangle(-1e307, -1e307, 1e307, 1e307)}), b({rectangle(4e307, -1e307, 1.4e308, 1e307)});
  const Pose here = Pose::Identity(), right = turnedAndMoved(0, 1.1e308, 0);
  const PosedPair pair(a.data(), here, b.data(), right);
  const WorldFrame frame(pair);
  const Vec2 left = frame.toWorld(frame.fromB({4e307, 1e307}));  // b's S is at 2e308
  EXPECT_NEAR(left.x(), 1.5e308, 1e295);
  EXPECT_NEAR(left.y(), 1e307, 1e295);
  EXPECT_EQ(frame.toWorld(frame.fromB({1.4e308, 1e307})).x(), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace tricover::support
