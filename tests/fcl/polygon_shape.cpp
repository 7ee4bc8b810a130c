// SPDX-License-Identifier: BSD-3-Clause
// The boxes that the broadphase decides by: whatever the pose, they must overlap where the polygons meet.
#include "tricover_fcl/polygon_shape.h"

#include <cmath>
#include <thread>
#include <utility>
#include <vector>

#include "exact_reference.h"
#include "scene.h"
#include "tricover_fcl/polygon_object.h"

namespace tricover_fcl::test {
namespace {

template <typename S>
fcl::AABB<S> boxOf(const Shape<S>& shape, const Pose& pose) {
  return fcl::CollisionObject<S>(shape, lifted<S>(pose)).getAABB();
}

TEST(PolygonShape, isTheGeometryThatItSays) {
  const Polygon polygon({rectangle(1, 2, 4, 6)});
  const PolygonShaped shape(polygon);
  EXPECT_EQ(shape.polygon().id(), polygon.id());
  EXPECT_EQ(shape.getObjectType(), fcl::OT_GEOM);
  EXPECT_EQ(shape.getNodeType(), fcl::GEOM_TRIANGLE);
  EXPECT_TRUE(shape.isOccupied());
}

TEST(PolygonShape, boxIsTightAndPadded) {
  const PolygonShaped shape(Polygon({rectangle(-3, -1, 4, 2)}));
  const double reach = std::hypot(4, 2);
  for (int axis = 0; axis < 2; ++axis) {
    const double low = axis == 0 ? -3 : -1, high = axis == 0 ? 4 : 2;
    EXPECT_LE(shape.aabb_local.min_[axis], low - 1e-12 * reach);
    EXPECT_GE(shape.aabb_local.min_[axis], low - 1e-11 * reach);
    EXPECT_GE(shape.aabb_local.max_[axis], high + 1e-12 * reach);
    EXPECT_LE(shape.aabb_local.max_[axis], high + 1e-11 * reach);
  }
  EXPECT_LT(shape.aabb_local.min_.z(), 0);
  EXPECT_GT(shape.aabb_local.max_.z(), 0);
  EXPECT_LT(shape.aabb_local.depth(), 1e-10);
  EXPECT_EQ(shape.aabb_center, Vec3::Zero());
  EXPECT_GE(shape.aabb_radius, reach);
  EXPECT_LE(shape.aabb_radius, reach * (1 + 3 * tricover::kRigidTolerance));
}

TEST(PolygonShape, computingTheBoxAgainChangesNothing) {
  Random random(1);
  PolygonShapef shape(randomPolygon(random, 3));
  const fcl::AABB<float> before = shape.aabb_local;
  const float radius = shape.aabb_radius;
  shape.computeLocalAABB();
  EXPECT_EQ(shape.aabb_local.min_, before.min_);
  EXPECT_EQ(shape.aabb_local.max_, before.max_);
  EXPECT_EQ(shape.aabb_radius, radius);
}

TEST(PolygonShape, rotationThatFclTakesForTheIdentityStaysInTheBox) {
  // A bar whose tip a rotation just below FCL's threshold lifts by 0.9e-12 x 1e6; one that lies off its origin, too.
  const Pose tiny = turnedAndMoved(0.9e-12, 0, 0);
  for (const double x : {0.0, 1e6}) {
    const Shape<double> bar = rectangular(x, 0, 1e6 + 1, 1);
    ASSERT_TRUE(lifted(tiny).linear().isIdentity());
    const Vec2 tip = tiny * Vec2(1e6 + 1, 1);
    EXPECT_GT(tip.y(), 1 + 5e-7);
    EXPECT_GT(boxOf(bar, tiny).max_.y(), tip.y());
  }
}

TEST(PolygonShape, farOffTheBoxesStillTouch) {
  // Two objects whose sizes are of the size of an ulp of their place, where each box is rounded to a multiple of it.
  Random random(5);
  int hits = 0;
  constexpr int kCases = 2000;
  for (int i = 0; i < kCases; ++i) {
    const double place = 1e15, ulp = 0.125;
    const Vec2 off(random.real(-2, 2) * ulp, random.real(-2, 2) * ulp);
    const Polygon a({star(random, 5, 0.5 * ulp, ulp)});
    const Polygon b({star(random, 5, 0.5 * ulp, ulp, off)});
    const Pose pose_a = turnedAndMoved(random.coin() ? 0 : random.real(0, 6), place, place);
    const Pose pose_b =
        turnedAndMoved(random.coin() ? 0 : random.real(0, 6), place + random.integer(-1, 1) * ulp, place);
    const bool hit = tricover::exact::collide(a, pose_a, b, pose_b);
    EXPECT_TRUE(!hit || boxOf(shapeOf(a), pose_a).overlap(boxOf(shapeOf(b), pose_b)));
    EXPECT_TRUE(!hit || shapeOf(a)->boxAt(lifted(pose_a)).overlap(shapeOf(b)->boxAt(lifted(pose_b))));
    hits += hit;
  }
  EXPECT_GT(hits, kCases * 3 / 10);
  EXPECT_LT(hits, kCases * 7 / 10);
}

template <typename S>
void expectUsable(const fcl::AABB<S>& box, double half_width) {
  EXPECT_FALSE(box.min_.hasNaN() || box.max_.hasNaN());
  EXPECT_TRUE(box.contain(fcl::Vector3<S>(1, 2, 0)));
  EXPECT_LE(static_cast<double>(box.max_.x() / 2 - box.min_.x() / 2), half_width);
}

TEST(PolygonShape, extremeSizesGiveUsableBoxes) {
  for (const double size : {5e-324, 1e-300, 1e300, 1e308}) {
    const Polygon polygon({rectangle(-size, -size, size, size)});
    for (const double angle : {0.0, 0.5, 1.0}) {
      expectUsable(boxOf(shapeOf(polygon), turnedAndMoved(angle, 1, 2)), 2 * size + 5e-16);
      expectUsable(boxOf(shapeOf<float>(polygon), turnedAndMoved(angle, 1, 2)), kInfinity);
      expectUsable(PolygonObjectd(shapeOf(polygon), lifted(angle, 1, 2)).getAABB(), 1.5 * size + 1e-14);
    }
  }
}

/// Moving copies.
TEST(PolygonShape, isAsItWasWhenMovedFrom) {
  PolygonShaped shape(Polygon({rectangle(1, 2, 4, 6)}), tricover_fcl::PolygonOptions());
  const PolygonShaped moved(std::move(shape));
  EXPECT_EQ(shape.polygon().id(), moved.polygon().id());  // NOLINT
  EXPECT_TRUE(shape.boxAt(kHere).equal(moved.boxAt(kHere)));
}

/// Whoever asks first finds the hull: copies share it, or find their own; what is assigned over has the other's.
TEST(PolygonShape, tightBoxesOfCopiesAreAlike) {
  Random random(4);
  const Polygon polygon = randomPolygon(random, 1), other = randomPolygon(random, 3);
  const Transform pose = lifted(1, 2, 3);
  const fcl::AABB<double> box = PolygonShaped(polygon).boxAt(pose), other_box = PolygonShaped(other).boxAt(pose);
  ASSERT_FALSE(box.equal(other_box));
  for (const bool asked : {false, true}) {
    PolygonShaped over(other);
    EXPECT_TRUE(!asked || over.boxAt(pose).equal(other_box));
    {
      const PolygonShaped shape(polygon), before = shape;
      EXPECT_TRUE(!asked || shape.boxAt(pose).equal(box));
      const PolygonShaped after = shape;
      EXPECT_TRUE(before.boxAt(pose).equal(box));
      EXPECT_TRUE(after.boxAt(pose).equal(box));
      over = after;
      const PolygonShaped& same = over;
      over = same;
    }
    EXPECT_TRUE(over.boxAt(pose).equal(box));
    over = PolygonShaped(other);
    EXPECT_TRUE(over.boxAt(pose).equal(other_box));
  }
}

TEST(PolygonShape, threadsFindTheTightBoxAtOnce) {
  Random random(5);
  for (int time = 0; time < 50; ++time) {
    const PolygonShaped shape(randomPolygon(random, 1));
    const Transform pose = lifted(time, 2, 3);
    std::vector<fcl::AABB<double>> boxes(6);
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      threads.emplace_back([&, i] { boxes[i] = i % 2 == 0 ? shape.boxAt(pose) : PolygonShaped(shape).boxAt(pose); });
    for (std::thread& thread : threads) thread.join();
    for (const fcl::AABB<double>& box : boxes) EXPECT_TRUE(box.equal(PolygonShaped(shape.polygon()).boxAt(pose)));
  }
}

}  // namespace
}  // namespace tricover_fcl::test
