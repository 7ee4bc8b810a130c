// SPDX-License-Identifier: BSD-3-Clause
// Boxes that are tight however the shape is turned: they hold it, exactly, and nothing to speak of beside it.
#include "tricover_fcl/polygon_object.h"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "managers.h"

namespace tricover_fcl::test {
namespace {

/// Where the polygon's vertices reach along a world axis, exactly, without its margin.
template <typename S>
std::pair<mpq_class, mpq_class> reach(const PolygonShape<S>& shape, const fcl::Transform3<S>& pose, int axis) {
  const auto at = [&](int column) { return mpq_class(static_cast<double>(pose.matrix()(axis, column))); };
  std::pair<mpq_class, mpq_class> range;
  bool first = true;
  for (const Ring& ring : shape.polygon().rings()) {
    for (const Vec2& vertex : ring) {
      for (const double z : {shape.options().z_low, shape.options().z_high}) {
        const mpq_class place = at(0) * vertex.x() + at(1) * vertex.y() + at(2) * z + at(3);
        range.first = first ? place : std::min(range.first, place);
        range.second = first ? place : std::max(range.second, place);
        first = false;
      }
    }
  }
  return range;
}

/// The box is outside of `reach` by the margin, and by no more than rounding.
template <typename S>
void expectTight(const PolygonShape<S>& shape, const fcl::Transform3<S>& pose, const fcl::AABB<S>& box, double slack) {
  for (int axis = 0; axis < 3; ++axis) {
    const double margin =
        shape.options().margin * pose.linear().row(axis).template head<2>().template cast<double>().norm();
    const auto [low, high] = reach(shape, pose, axis);
    const mpq_class below = low - mpq_class(static_cast<double>(box.min_[axis])) - margin;
    const mpq_class above = mpq_class(static_cast<double>(box.max_[axis])) - high - margin;
    EXPECT_GE(below, 0) << axis;
    EXPECT_GE(above, 0) << axis;
    EXPECT_LE(below.get_d(), slack) << axis;
    EXPECT_LE(above.get_d(), slack) << axis;
  }
}

template <typename S>
void expectTightBoxes(double precision) {
  Random random(41);
  for (int i = 0; i < scaledCount(400); ++i) {
    const double size = std::ldexp(1, random.integer(-20, 20));
    const Vec2 off = random.coin() ? Vec2(0, 0) : Vec2(random.real(-50, 50) * size, random.real(-50, 50) * size);
    const Polygon polygon({star(random, random.integer(3, 40), 0.3 * size, size, off)});
    PolygonOptions options;
    if (random.coin()) options.z_low = random.real(-2, 0) * size, options.z_high = random.real(0, 3) * size;
    if (random.coin()) options.margin = random.real(0, 1) * size;
    const auto shape = shapeOf<S>(polygon, options);

    // In the plane, upside down or mirrored; and now and then anyhow.
    fcl::Transform3<S> pose = lifted<S>(randomPose(random, 100 * size), random.real(-9, 9) * size);
    if (random.coin()) pose.linear() = pose.linear() * fcl::Vector3<S>(1, -1, -1).asDiagonal();
    if (random.oneIn(4)) {
      pose.linear() = Eigen::AngleAxis<S>(static_cast<S>(random.real(0, 3)),
                                          fcl::Vector3<S>(1, static_cast<S>(random.real(-1, 1)), 0).normalized())
                          .toRotationMatrix();
    }
    PolygonObject<S> object(shape, pose);
    // A pose may stretch the margin by a rounding.
    expectTight(*shape, pose, object.getAABB(), precision * 200 * size + 4e-6 * options.margin);

    object.setTranslation(fcl::Vector3<S>(7, 8, 9));
    object.computeAABB();
    expectTight(*shape, object.getTransform(), object.getAABB(), precision * (200 * size + 9) + 4e-6 * options.margin);
  }
}

TEST(PolygonObject, boxesHoldTheShapeAndLittleElse) { expectTightBoxes<double>(1e-13); }

TEST(PolygonObject, floatBoxesHoldTheShapeAndLittleElse) { expectTightBoxes<float>(3e-7); }

TEST(PolygonObject, atAllHeightsTheBoxIsAsHighAsWide) {
  const auto shape = shapeOf(Polygon({rectangle(0, 0, 4, 3)}), PolygonOptions::atAllHeights(1));
  const PolygonObjectd object(shape, lifted(0, 1, 2, 7));
  const fcl::AABB<double>& box = object.getAABB();
  EXPECT_NEAR(box.min_.z(), 7 - 6, 12 * tricover::kRigidTolerance);  // the farthest vertex and the margin
  EXPECT_NEAR(box.max_.z(), 7 + 6, 12 * tricover::kRigidTolerance);
  EXPECT_NEAR(box.max_.x(), 6, 1e-5);
}

TEST(PolygonObject, aTiltThatPairsLeaveOutIsInTheBoxBothWays) {
  // Within the tolerance: two polygons meet as if there were none, and other geometries meet the tilted one.
  Transform pose = kHere;
  pose.linear()(0, 2) = 9e-7;
  pose.linear()(2, 0) = -9e-7;
  const auto shape = shapeOf(Polygon({rectangle(1, 0, 2, 1)}), {0, 1000, 2000});
  const PolygonObjectd object(shape, pose);
  const fcl::AABB<double>& box = object.getAABB();
  EXPECT_LE(box.min_.x(), 1);
  EXPECT_GE(box.max_.x(), 2 + 1800e-6);
  EXPECT_LE(box.min_.z(), 1000 - 1.8e-6);
  EXPECT_GE(box.max_.z(), 2000);
}

TEST(PolygonObject, fclsOwnBoxIsRightToo) {
  Random random(42);
  PolygonObjectd object(shapeOf(randomPolygon(random, 2)), lifted(0.7, 3, 4));
  const fcl::AABB<double> tight = object.getAABB();
  fcl::CollisionObjectd& plain = object;
  plain.computeAABB();
  EXPECT_TRUE(plain.getAABB().contain(tight));
  EXPECT_GT(plain.getAABB().volume(), tight.volume());
  object.computeAABB();
  EXPECT_TRUE(object.getAABB().equal(tight));
}

TEST(PolygonObject, needsAShape) {
  expectRefused({"shape"}, [] { PolygonObjectd object(nullptr); });
}

/// What a manager asks, and finds by their numbers, of a layout of outlines that were authored off their origin.
struct Asked {
  std::size_t pairs;
  std::set<std::pair<std::size_t, std::size_t>> hits;
};

template <typename Object>
Asked askedOf(double off) {
  Random random(43);
  std::vector<std::shared_ptr<Object>> objects;
  std::map<const void*, std::size_t> numbers;
  fcl::DynamicAABBTreeCollisionManagerd manager;
  for (std::size_t i = 0; i < 300; ++i) {
    const Vec2 place(random.real(-30, 30), random.real(-30, 30)), origin(off, off);
    const Polygon polygon({star(random, 12, 0.5, 2, origin)});
    Pose there = turnedAndMoved(random.real(0, 6), 0, 0);
    there.translation() = place - there.linear() * origin;
    objects.push_back(std::make_shared<Object>(shapeOf(polygon), lifted(there)));
    numbers[objects.back().get()] = i;
    manager.registerObject(objects.back().get());
  }
  manager.setup();
  Seen<double> seen;
  manager.collide(&seen, see<double>);
  Asked asked{seen.calls, {}};
  for (const auto& [p, q] : seen.hits) asked.hits.insert(std::minmax(numbers.at(p), numbers.at(q)));
  return asked;
}

TEST(PolygonObject, managersAskAboutFewerPairsAndFindTheSame) {
  for (const double off : {0.0, 5.0}) {
    const Asked wide = askedOf<fcl::CollisionObjectd>(off), tight = askedOf<PolygonObjectd>(off);
    EXPECT_EQ(tight.hits, wide.hits);
    EXPECT_GT(tight.hits.size(), 100u);
    EXPECT_LT(tight.pairs * (off > 0 ? 8 : 1), wide.pairs * 3 / 4) << off;
    RecordProperty(off > 0 ? "off_the_origin" : "around_it",
                   std::to_string(wide.pairs) + " " + std::to_string(tight.pairs));
  }
}

}  // namespace
}  // namespace tricover_fcl::test
