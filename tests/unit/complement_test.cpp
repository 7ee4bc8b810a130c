// SPDX-License-Identifier: BSD-3-Clause
// What is outside of a polygon as a region of its own, in every query, where the answer is known.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "refusal.h"
#include "shapes.h"
#include "tricover/tricover.h"

namespace tricover::support {
namespace {

const Pose kHere = Pose::Identity();
const CollideOptions kOpen{0, 0, Touching::Allowed};

Polygon lane() { return Polygon({rectangle(0, 0, 20, 4)}); }
Pose at(double x, double y) { return turnedAndMoved(0, x, y); }

template <typename Call>
void expectRefused(const char* text, const Call& call) {
  const std::string said = refusal(call);
  EXPECT_NE(said.find(text), std::string::npos) << said;
}

TEST(Complement, IsUnboundedAndStaysAComplement) {
  const Polygon outside = lane().complement();
  for (const Polygon& one :
       {outside, outside.translated({1, 0}), outside.transformed(at(1, 0)), outside.scaled(2), outside.simplified(0.1)})
    EXPECT_TRUE(one.isComplement());
  EXPECT_FALSE(lane().isComplement());
  EXPECT_FALSE(outside.complement().isComplement());
  EXPECT_EQ(outside.complement().area(), 80);
  EXPECT_EQ(outside.rings(), lane().rings());
  EXPECT_FALSE(outside.isConvex());
  EXPECT_TRUE(std::isinf(outside.area()) && std::isinf(outside.radius()));
  EXPECT_TRUE(std::isinf(outside.bounds().max().x()) && std::isinf(outside.bounds(at(1, 2)).min().y()));
  EXPECT_EQ(outside.centroid(), Vec2(10, 2));
  EXPECT_EQ(outside.coveringOrigin(), lane().coveringOrigin());
  EXPECT_NE(outside.id(), lane().id());
  EXPECT_THROW(outside.simplified(0.1, Simplify::Outwards), std::invalid_argument);
  for (const double far : {21.0, 1e15, 1e300}) EXPECT_EQ(locate(outside, {far, 2}), Location::Inside);
}

/// What has the outside on both sides or on none is left out: seams, slits, spikes, points, and a ring that is said
/// thrice. Vertices that are repeated in a ring stay.
TEST(Complement, HasBordersAlone) {
  const Ring square = rectangle(0, 0, 2, 2), repeated = {{0, 0}, {0, 0}, {2, 0}, {2, 2}, {2, 2}};
  EXPECT_EQ(Polygon({square, square, square}).complement().vertexCount(), 4u);
  EXPECT_EQ(Polygon({square, Ring(3, {2, 0}), Ring(4, {1, 1})}).complement().rings(), std::vector<Ring>{square});
  EXPECT_EQ(Polygon({repeated}).complement().rings(), Polygon({repeated}).rings());
}

TEST(Complement, LeavesOutWhatTheNonZeroRuleHasInside) {
  EXPECT_EQ(Polygon({rectangle(0, 0, 4, 4), rectangle(1, 1, 2, 2), reversed(rectangle(2, 2, 3, 3))}, FillRule::NonZero)
                .complement()
                .vertexCount(),
            8u);
  // A union of two that cross at vertices.
  const Ring low = {{0, 0}, {3, 0}, {3, 1}, {3, 2}, {2, 2}, {0, 2}},
             high = {{2, 1}, {3, 1}, {5, 1}, {5, 4}, {2, 4}, {2, 2}};
  EXPECT_EQ(Polygon({low, high}, FillRule::NonZero).complement().complement().area(), 6 + 9 - 1);
  // The same where the crossings are no vertices: the second one is named.
  const Ring plain = {{0.1, 0.1}, {3.3, 0.2}, {3.1, 2.3}, {0.2, 2.1}}, other = {{2, 1}, {5, 1.5}, {5, 4}, {1.5, 4}};
  expectRefused("ring 0, vertex 1", [&] { Polygon({plain, other}, FillRule::NonZero).complement(); });
  EXPECT_NO_THROW(Polygon({plain, other}).complement());
}

TEST(Complement, RefusesWhatHasNoArea) {
  EXPECT_THROW(Polygon::point({1, 2}).complement(), std::invalid_argument);
  EXPECT_THROW(Polygon::segment({1, 2}, {3, 4}).complement(), std::invalid_argument);
  EXPECT_THROW(Polygon({{{0, 0}, {1, 0}, {2, 0}, {3, 0}}}).complement(), std::invalid_argument);
  const Ring square = rectangle(0, 0, 2, 2);
  EXPECT_THROW(Polygon({square, square}).complement(), std::invalid_argument);
}

TEST(Complement, TellsWhetherABodyIsInside) {
  const Polygon outside = lane().complement(), car = Polygon::box(4, 2);
  EXPECT_FALSE(collide(outside, kHere, car, at(10, 2)));
  EXPECT_TRUE(collide(outside, kHere, car, at(10, 3)));  // it touches the border
  EXPECT_FALSE(collide(outside, kHere, car, at(10, 3), kOpen));
  EXPECT_TRUE(collide(outside, kHere, car, at(10, 2), {1}));
  EXPECT_FALSE(collide(outside, kHere, car, at(10, 2), {1, 0, Touching::Allowed}));
  for (const double far : {30.0, 1e15, 1e300}) {
    EXPECT_TRUE(collide(outside, kHere, car, at(far, 2)));
    EXPECT_TRUE(collide(outside, kHere, Polygon::segment({-far, 2}, {-2 * far / 2, 3}), kHere));
    EXPECT_EQ(distance(outside, kHere, car, at(-far, 2)).distance, 0);
    EXPECT_TRUE(collide(outside, kHere, Polygon::box(1, 1).complement(), at(far, 0), kOpen))
        << "two of them always meet";
  }
}

TEST(Complement, HasDistancesAndLocalDepths) {
  const Polygon outside = lane().complement(), car = Polygon::box(4, 2);
  const DistanceResult apart = distance(outside, kHere, car, at(10, 2.5));
  EXPECT_EQ(apart.distance, 0.5);
  EXPECT_EQ(apart.edge_a, 2);
  EXPECT_EQ(signedDistance(outside, kHere, car, at(10, 2.5)).distance, 0.5);
  const ContactOptions local{0, 9, ContactDetail::LocalDepth}, wide{1, 9, ContactDetail::LocalDepth};
  EXPECT_EQ(contacts(outside, kHere, car, at(0.5, 3.25), {0, 9, ContactDetail::Points}).size(), 1u);
  EXPECT_EQ(contacts(outside, kHere, car, at(10, 2.5), wide)[0].depth, 0.5);
  const std::vector<Contact> far = contacts(outside, kHere, car, at(100, 2), local);
  ASSERT_EQ(far.size(), 1u);
  EXPECT_EQ(far[0].normal, Vec2(-1, 0));
  EXPECT_EQ(far[0].depth, 82);
}

TEST(Complement, IsRefusedWhereOneDepthIsWanted) {
  const Polygon outside = lane().complement(), car = Polygon::box(4, 2);
  expectRefused("a: a complement", [&] { penetration(outside, kHere, car, at(10, 2)); });
  expectRefused("b: a complement", [&] { penetration(car, at(10, 2), outside, kHere); });
  expectRefused("ContactDetail::LocalDepth", [&] {
    contacts(outside, kHere, car, at(10, 2), {0, 9, ContactDetail::GlobalDepth});
  });
  EXPECT_EQ(signedDistance(car, at(10, 3.25), outside, kHere).distance, -0.25);
}

TEST(Complement, IsLeftByMotions) {
  const Polygon outside = lane().complement(), car = Polygon::box(4, 2);
  const Motion still = Motion::still(kHere), up = Motion::translation(at(10, 2), {0, 4});
  const auto leaves = timeOfImpact(outside, still, car, up);
  ASSERT_TRUE(leaves);
  EXPECT_NEAR(leaves->time, 0.25, 1e-12);
  EXPECT_EQ(leaves->edge_a, 2);
  EXPECT_NEAR(leaves->normal.y(), -1, 1e-12);
  // It slides along the border, which it touches, or leaves the border for good.
  for (const Vec2& way : {Vec2(4, 0), Vec2(4, -1)})
    EXPECT_FALSE(timeOfImpact(outside, still, car, Motion::translation(at(10, 3), way), {0, 1e-6, true}));
  EXPECT_EQ(conflicts(outside, still, car, up).size(), 1u);
  EXPECT_NEAR(leastDistance(outside, still, car, Motion::translation(at(10, 1.5), {0, 1})).distance, 0.5, 1e-9);
}

TEST(Complement, StopsRays) {
  const Polygon outside = lane().complement();
  const auto hit = castRay(outside, kHere, {10, 2}, {1e9, 2});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->point.x(), 20);
  EXPECT_EQ(hit->normal, Vec2(-1, 0));
  EXPECT_EQ(castRay(outside, kHere, {1e9, 2}, {1e9, 3})->fraction, 0) << "far from every edge";
  EXPECT_EQ(castRayAll(outside, kHere, {1e9, 2}, {1e9, 3}).size(), 1u);
  EXPECT_EQ(castRayAll(outside, kHere, {-10, 2}, {30, 2}, {1}).size(), 2u);
}

TEST(Complement, IsABodyOfAScene) {
  Scene scene;
  const auto zone = scene.add(lane().complement(), kHere);
  const auto car = scene.add(Polygon::box(4, 2), at(10, 2));
  const auto stranger = scene.add(Polygon::box(1, 1), at(1e6, 0));
  EXPECT_EQ(scene.collisions(), (std::vector<BodyPair>{{zone, stranger}}));
  scene.move(car, at(10, 3));
  EXPECT_EQ(scene.collisions().size(), 2u);
  EXPECT_EQ(scene.colliding(Polygon::box(1, 1), at(1e6, 0)), (std::vector<BodyHandle>{zone, stranger}));
  EXPECT_EQ(scene.castRay({-1e308, 2}, {1e308, 2})->body, zone);
  // As the query's polygon.
  EXPECT_EQ(scene.colliding(Polygon::box(100, 100).complement(), kHere), (std::vector<BodyHandle>{zone, stranger}));
}

TEST(Complement, IsDrawnUpToAFrame) {
  SvgDrawing drawing;
  drawing.polygon(lane().complement(), kHere, "gray", "black", 0.5);
  drawing.boxes(lane().complement(), kHere, 0, "red");
  const std::string text = drawing.str();
  EXPECT_NE(text.find("evenodd"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
  EXPECT_EQ(text.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace tricover::support
