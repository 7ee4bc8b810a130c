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
  EXPECT_TRUE(outside.isComplement());
  EXPECT_FALSE(lane().isComplement());
  EXPECT_EQ(outside.rings(), lane().rings());
  EXPECT_FALSE(outside.isConvex());
  EXPECT_TRUE(std::isinf(outside.area()));
  EXPECT_TRUE(std::isinf(outside.radius()));
  EXPECT_TRUE(std::isinf(outside.bounds().max().x()) && std::isinf(outside.bounds(at(1, 2)).min().y()));
  EXPECT_EQ(outside.centroid(), Vec2(10, 2));
  EXPECT_EQ(outside.origin(), lane().origin());
  EXPECT_TRUE(outside.translated({1, 0}).isComplement());
  EXPECT_TRUE(outside.transformed(at(1, 0)).isComplement());
  EXPECT_TRUE(outside.scaled(2).isComplement());
  EXPECT_TRUE(outside.simplified(0.1).isComplement());
  EXPECT_THROW(outside.simplified(0.1, Simplify::Outwards), std::invalid_argument);
  EXPECT_FALSE(outside.complement().isComplement());
  EXPECT_EQ(outside.complement().area(), 80);
  EXPECT_NE(outside.id(), lane().id());
  EXPECT_EQ(locate(outside, {10, 2}), Location::Outside);
  EXPECT_EQ(locate(outside, {20, 2}), Location::Boundary);
  for (const double far : {21.0, 1e15, 1e300}) EXPECT_EQ(locate(outside, {far, 2}), Location::Inside);
}

TEST(Complement, HasNoSeams) {
  // Two squares that share an edge, one of them with a vertex on it; and a slit that goes in and back.
  const Polygon seam = Polygon({rectangle(0, 0, 2, 2), {{2, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 1}}}).complement();
  const Polygon slit = Polygon({{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 1}, {2, 2}, {0, 2}}}).complement();
  for (const Polygon& outside : {seam, slit}) {
    EXPECT_EQ(locate(outside, {2, 1}), Location::Outside);
    EXPECT_EQ(locate(outside, {2, 1.5}), Location::Outside);
    EXPECT_EQ(locate(outside, {2, 2}), Location::Boundary);
    EXPECT_FALSE(collide(outside, kHere, box(2, 1), at(2, 1)));
    EXPECT_EQ(distance(outside, kHere, box(2, 1), at(2, 1)).distance, 0.5);
    EXPECT_TRUE(collide(outside, kHere, box(2, 2), at(2, 1)));
    EXPECT_FALSE(collide(outside, kHere, box(2, 2), at(2, 1), kOpen));
    EXPECT_EQ(outside.complement().area(), 8);
  }
  // A spike outwards is no border: it lies in the outside.
  const Polygon spiked = Polygon({{{0, 0}, {2, 0}, {5, 0}, {2, 0}, {2, 2}, {0, 2}}}).complement();
  EXPECT_EQ(locate(spiked, {4, 0}), Location::Inside);
  EXPECT_EQ(locate(spiked, {1, 1}), Location::Outside);
  // Thrice the same ring is once.
  const Ring square = rectangle(0, 0, 2, 2);
  EXPECT_EQ(Polygon({square, square, square}).complement().vertexCount(), 4u);
}

/// A ring of one point is no border, wherever it is.
TEST(Complement, HasNoPointRings) {
  const Ring square = rectangle(-1, -1, 1, 1), hole = rectangle(-0.5, -0.5, 0.5, 0.5);
  for (const FillRule rule : {FillRule::EvenOdd, FillRule::NonZero})
    for (const Vec2& p : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(3, 0)}) {
      const Polygon outside = Polygon({square, Ring(3, p)}, rule).complement();
      const bool is_beyond = p.x() > 1, is_within = p.x() < 1;
      EXPECT_EQ(locate(outside, p), is_within ? Location::Outside : is_beyond ? Location::Inside : Location::Boundary);
      EXPECT_EQ(collide(outside, kHere, point(p), kHere), !is_within);
      EXPECT_EQ(outside.rings().size(), 1u);
      EXPECT_EQ(distance(outside, kHere, point({0, 0}), kHere).distance, 1);
      EXPECT_EQ(outside.complement().area(), 4);
    }
  const Polygon frame = Polygon({square, hole, Ring(4, {0, 0}), Ring(3, {0.75, 0})}).complement();
  EXPECT_EQ(locate(frame, {0, 0}), Location::Inside);
  EXPECT_EQ(locate(frame, {0.75, 0}), Location::Outside);
  EXPECT_EQ(frame.vertexCount(), 8u);
  // Vertices that are repeated in a ring stay.
  const Ring repeated = {{0, 0}, {0, 0}, {2, 0}, {2, 2}, {2, 2}};
  EXPECT_EQ(Polygon({repeated}).complement().rings(), Polygon({repeated}).rings());
}

TEST(Complement, LeavesOutWhatTheNonZeroRuleHasInside) {
  const Polygon nested =
      Polygon({rectangle(0, 0, 4, 4), rectangle(1, 1, 2, 2), reversed(rectangle(2, 2, 3, 3))}, FillRule::NonZero)
          .complement();
  EXPECT_EQ(locate(nested, {1, 1.5}), Location::Outside);
  EXPECT_EQ(locate(nested, {2.5, 2.5}), Location::Inside);
  EXPECT_EQ(nested.vertexCount(), 8u);
  // A union of two that cross at vertices.
  const Ring low = {{0, 0}, {3, 0}, {3, 1}, {3, 2}, {2, 2}, {0, 2}},
             high = {{2, 1}, {3, 1}, {5, 1}, {5, 4}, {2, 4}, {2, 2}};
  const Polygon both = Polygon({low, high}, FillRule::NonZero).complement();
  EXPECT_EQ(locate(both, {2.5, 2}), Location::Outside);
  EXPECT_EQ(locate(both, {3, 1.5}), Location::Outside);
  EXPECT_EQ(locate(both, {3, 1}), Location::Boundary);
  EXPECT_EQ(both.complement().area(), 6 + 9 - 1);
  // The same where the crossings are no vertices: the second one is named.
  const Ring plain = {{0.1, 0.1}, {3.3, 0.2}, {3.1, 2.3}, {0.2, 2.1}}, other = {{2, 1}, {5, 1.5}, {5, 4}, {1.5, 4}};
  expectRefused("ring 0, vertex 1", [&] { Polygon({plain, other}, FillRule::NonZero).complement(); });
  EXPECT_NO_THROW(Polygon({plain, other}).complement());
}

TEST(Complement, RefusesWhatHasNoArea) {
  EXPECT_THROW(point({1, 2}).complement(), std::invalid_argument);
  EXPECT_THROW(segment({1, 2}, {3, 4}).complement(), std::invalid_argument);
  EXPECT_THROW(Polygon({{{0, 0}, {1, 0}, {2, 0}, {3, 0}}}).complement(), std::invalid_argument);
  const Ring square = rectangle(0, 0, 2, 2);
  EXPECT_THROW(Polygon({square, square}).complement(), std::invalid_argument);
}

TEST(Complement, TellsWhetherABodyIsInside) {
  const Polygon outside = lane().complement(), car = box(4, 2);
  EXPECT_FALSE(collide(outside, kHere, car, at(10, 2)));
  EXPECT_TRUE(collide(outside, kHere, car, at(10, 3)));  // it touches the border
  EXPECT_FALSE(collide(outside, kHere, car, at(10, 3), kOpen));
  EXPECT_TRUE(collide(outside, kHere, car, at(10, std::nextafter(3.0, 4)), kOpen));
  EXPECT_TRUE(collide(outside, kHere, car, at(10, 2), {1}));
  EXPECT_FALSE(collide(outside, kHere, car, at(10, 2), {std::nextafter(1.0, 0)}));
  EXPECT_FALSE(collide(outside, kHere, car, at(10, 2), {1, 0, Touching::Allowed}));
  for (const double far : {30.0, 1e15, 1e300}) {
    EXPECT_TRUE(collide(outside, kHere, car, at(far, 2)));
    EXPECT_TRUE(collide(outside, kHere, point({far, 2}), kHere));
    EXPECT_TRUE(collide(outside, kHere, segment({-far, 2}, {-2 * far / 2, 3}), kHere));
    EXPECT_EQ(distance(outside, kHere, car, at(-far, 2)).distance, 0);
  }
  EXPECT_TRUE(collide(outside, kHere, box(40, 40), at(10, 2))) << "it holds the whole hole";
  EXPECT_FALSE(collide(outside, kHere, point({10, 2}), kHere));
  EXPECT_FALSE(collide(outside, kHere, segment({1, 1}, {19, 3}), kHere));
  EXPECT_TRUE(collide(outside, kHere, lane(), kHere));
  EXPECT_FALSE(collide(outside, kHere, lane(), kHere, kOpen));
  const Pose away = at(1e15, -1e15);
  EXPECT_FALSE(collide(outside, away, lane(), away, kOpen));
  EXPECT_FALSE(collide(outside, away, car, away * at(10, 2)));
  const Polygon tiny = lane().scaled(1e-299), tiny_outside = tiny.complement();
  EXPECT_FALSE(collide(tiny_outside, kHere, tiny, kHere, kOpen));
  EXPECT_FALSE(collide(tiny_outside, kHere, tiny.scaled(0.5), at(1e-299, 1e-299)));
  EXPECT_TRUE(collide(tiny_outside, kHere, tiny, at(1e-299, 0), kOpen));
}

TEST(Complement, MeetsEveryOther) {
  const Polygon outside = lane().complement(), other = box(1, 1).complement();
  for (const Pose& there : {kHere, at(10, 2), at(1e15, 0), at(1e300, 0)})
    for (const CollideOptions& options : {CollideOptions{}, kOpen}) {
      PairCache cache;
      EXPECT_TRUE(collide(outside, kHere, other, there, options));
      EXPECT_TRUE(collide(other, there, outside, kHere, cache, options));
      EXPECT_TRUE(collide(outside, kHere, outside, there, cache, options));
    }
  EXPECT_EQ(distance(outside, kHere, other, at(100, 0)).distance, 0);
  EXPECT_FALSE(contacts(outside, kHere, other, at(100, 0), {0, 1, ContactDetail::LocalDepth}).empty());
}

TEST(Complement, HasDistancesAndLocalDepths) {
  const Polygon outside = lane().complement(), car = box(4, 2);
  const DistanceResult apart = distance(outside, kHere, car, at(10, 2.5));
  EXPECT_EQ(apart.distance, 0.5);
  EXPECT_EQ(apart.point_a.y(), 4);
  EXPECT_EQ(apart.edge_a, 2);
  EXPECT_EQ(signedDistance(outside, kHere, car, at(10, 2.5)).distance, 0.5);
  EXPECT_EQ(distance(outside, kHere, point({3, 2.5}), kHere).distance, 1.5);
  const std::vector<Contact> found = contacts(outside, kHere, car, at(10, 3.25), {0, 9, ContactDetail::LocalDepth});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].depth, 0.25);
  EXPECT_EQ(found[0].normal, Vec2(0, -1)) << "back into the lane";
  EXPECT_EQ(found[0].count, 2u);
  EXPECT_EQ(contacts(outside, kHere, car, at(0.5, 3.25), {0, 9, ContactDetail::Points}).size(), 1u);
  EXPECT_TRUE(contacts(outside, kHere, car, at(10, 2.5), {0, 9, ContactDetail::LocalDepth}).empty());
  EXPECT_EQ(contacts(outside, kHere, car, at(10, 2.5), {1, 9, ContactDetail::LocalDepth})[0].depth, 0.5);
  const std::vector<Contact> far = contacts(outside, kHere, car, at(100, 2), {0, 9, ContactDetail::LocalDepth});
  ASSERT_EQ(far.size(), 1u);
  EXPECT_EQ(far[0].normal, Vec2(-1, 0));
  EXPECT_EQ(far[0].depth, 82);
  EXPECT_EQ(crossings(outside, kHere, car, at(10, 3.25)).size(), 2u);
}

TEST(Complement, IsRefusedWhereOneDepthIsWanted) {
  const Polygon outside = lane().complement(), car = box(4, 2);
  expectRefused("a: a complement", [&] { penetration(outside, kHere, car, at(10, 2)); });
  expectRefused("b: a complement", [&] { penetration(car, at(10, 2), outside, kHere); });
  expectRefused("ContactDetail::LocalDepth", [&] { contacts(outside, kHere, car, at(10, 2)); });
  EXPECT_EQ(signedDistance(car, at(10, 3.25), outside, kHere).distance, -0.25);
}

TEST(Complement, IsLeftByMotions) {
  const Polygon outside = lane().complement(), car = box(4, 2);
  const auto impactOf = [&](const Motion& motion, const ImpactOptions& options = {}) {
    return timeOfImpact(outside, Motion::still(kHere), car, motion, options);
  };
  const auto leaves = impactOf(Motion::translation(at(10, 2), {0, 4}));
  ASSERT_TRUE(leaves);
  EXPECT_NEAR(leaves->time, 0.25, 1e-12);
  EXPECT_EQ(leaves->edge_a, 2);
  EXPECT_NEAR(leaves->normal.y(), -1, 1e-12);
  EXPECT_FALSE(impactOf(Motion::translation(at(3, 2), {14, 0.5})));
  EXPECT_NEAR(impactOf(Motion::translation(at(3, 2), {140, 0}))->time, 0.1 * 15 / 14, 1e-12) << "no matter how far";
  EXPECT_NEAR(impactOf(Motion::translation(at(10, 2), {0, 4}), {0.5})->time, 0.125, 1e-12);
  EXPECT_EQ(impactOf(Motion::translation(at(100, 2), {0, 4}))->time, 0);
  // Around its middle its corners reach out of a lane that is not wide enough.
  Motion turns = Motion::still(at(10, 2));
  turns.angle = 1;
  const auto turned = impactOf(turns);
  ASSERT_TRUE(turned);
  EXPECT_NEAR(turned->time, std::asin(2 / std::sqrt(5.0)) - std::atan(0.5), 1e-9);
  // It slides along the border, which it touches, or leaves the border for good.
  EXPECT_FALSE(impactOf(Motion::translation(at(10, 3), {4, 0}), {0, 1e-6, true}));
  EXPECT_FALSE(impactOf(Motion::translation(at(10, 3), {4, -1}), {0, 1e-6, true}));
  EXPECT_EQ(conflicts(outside, Motion::still(kHere), car, Motion::translation(at(10, 2), {0, 4})).size(), 1u);
  const LeastDistance least =
      leastDistance(outside, Motion::still(kHere), car, Motion::translation(at(10, 1.5), {0, 1}));
  EXPECT_NEAR(least.distance, 0.5, 1e-9);
  // The lane may move, too.
  EXPECT_NEAR(timeOfImpact(car, Motion::still(at(10, 2)), outside, Motion::translation(kHere, {0, 4}))->time, 0.25,
              1e-12);
}

TEST(Complement, StopsRays) {
  const Polygon outside = lane().complement();
  const auto hit = castRay(outside, kHere, {10, 2}, {1e9, 2});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->point.x(), 20);
  EXPECT_EQ(hit->edge, 1);
  EXPECT_EQ(hit->normal, Vec2(-1, 0));
  EXPECT_FALSE(castRay(outside, kHere, {10, 2}, {12, 3}));
  EXPECT_EQ(castRay(outside, kHere, {1e9, 2}, {1e9, 3})->fraction, 0) << "far from every edge";
  EXPECT_EQ(castRay(outside, kHere, {30, 2}, {10, 2})->edge, -1);
  EXPECT_NEAR(castRay(outside, kHere, {10, 2}, {30, 2}, {1})->fraction, 0.45, 1e-12);
  const std::vector<RayInterval> both = castRayAll(outside, kHere, {-10, 2}, {30, 2});
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].end.fraction, 0.25);
  EXPECT_EQ(both[1].begin.edge, 1);
  EXPECT_EQ(both[1].end.fraction, 1);
  EXPECT_EQ(castRayAll(outside, kHere, {1e9, 2}, {1e9, 3}).size(), 1u);
  EXPECT_EQ(castRayAll(outside, kHere, {-10, 2}, {30, 2}, {1}).size(), 2u);
}

TEST(Complement, IsABodyOfAScene) {
  Scene scene;
  const auto zone = scene.add(lane().complement(), kHere);
  const auto car = scene.add(box(4, 2), at(10, 2));
  const auto stranger = scene.add(box(1, 1), at(1e6, 0));
  const std::vector<BodyPair> outside_only = {{zone, stranger}};
  EXPECT_EQ(scene.collisions(), outside_only);
  for (int i = 0; i < 50; ++i) {
    scene.move(car, at(10, 2 + 0.05 * i));
    EXPECT_EQ(scene.collisions().size(), i < 20 ? 1u : 2u) << i;
  }
  scene.move(car, at(10, 2));
  scene.move(zone, at(0, 1));
  EXPECT_EQ(scene.collisions().size(), 2u);
  scene.move(zone, kHere);
  EXPECT_EQ(scene.collisions(), outside_only);
  const BodyFilter others = BodyFilter::allBut(car);
  EXPECT_FALSE(scene.collides(box(1, 1), at(5, 1), {}, others));
  EXPECT_TRUE(scene.collides(box(1, 1), at(5, 0), {}, others));
  EXPECT_EQ(scene.collides(box(1, 1), {at(5, 1), at(50, 1), at(5, 2)}, {}, others),
            (std::vector<bool>{false, true, false}));
  EXPECT_EQ(scene.colliding(box(1, 1), at(1e6, 0)), (std::vector<BodyHandle>{zone, stranger}));
  EXPECT_EQ(scene.anyColliding(box(1, 1), at(-1e9, 0)), zone);
  EXPECT_EQ(scene.nearest(box(1, 1), at(5, 1.5), {}, others)->result.distance, 1);
  EXPECT_EQ(scene.nearest(box(1, 1), at(5, 1e9))->result.distance, 0);
  EXPECT_EQ(scene.castRay({5, 2}, {5, 1e308})->hit.point.y(), 4);
  EXPECT_EQ(scene.castRay({-1e308, 2}, {1e308, 2})->body, zone);
  EXPECT_NEAR(scene.firstImpact(box(1, 1), Motion::translation(at(5, 2), {0, -3}), {}, others)->impact.time, 0.5,
              1e-12);
  EXPECT_EQ(scene.impacts({{car, Motion::translation(at(10, 2), {0, 4})}}).size(), 1u);
  // As the query's polygon.
  EXPECT_EQ(scene.colliding(box(100, 100).complement(), kHere), (std::vector<BodyHandle>{zone, stranger}));
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

TEST(Complement, OfAMapIsWhereARobotMayGo) {
  // Rooms with pillars; what is occupied is the region, so that its complement's complement is the free space.
  OccupancyGrid grid;
  grid.width = 40, grid.height = 30;
  grid.cells.assign(grid.width * grid.height, 0);
  for (std::size_t x = 2; x < 38; ++x)
    for (std::size_t y = 2; y < 28; ++y) grid.cells[y * grid.width + x] = (x % 6 != 0 || y % 6 != 0) && x != 20 ? 1 : 0;
  for (const std::size_t y : {9u, 10u}) grid.cells[y * grid.width + 20] = 1;  // a door
  const Polygon free = *outline(grid), occupied = free.complement();
  EXPECT_GT(free.rings().size(), 20u);
  const Polygon robot({regular(8, 0.5)}), cell({rectangle(0, 0, 1, 1)});
  int inside = 0;
  for (int i = 0; i < 400; ++i) {
    const double x = 0.1 * i, y = 10 + 0.01 * (i % 7);
    PairCache cache;
    const bool is_free = !collide(occupied, kHere, robot, at(x, y), cache);
    bool all_free = true;  // by the cells around it
    for (std::size_t k = 0; k < grid.cells.size(); ++k) {
      const Vec2 corner(static_cast<double>(k % grid.width), static_cast<double>(k / grid.width));
      if (grid.cells[k] == 0) all_free &= !collide(cell, at(corner.x(), corner.y()), robot, at(x, y));
    }
    EXPECT_EQ(is_free, all_free) << x;
    inside += is_free;
  }
  EXPECT_GT(inside, 200);
  EXPECT_LT(inside, 390);
}

}  // namespace
}  // namespace tricover::support
