// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <utility>

#include "family_makers.h"
#include "shapes.h"

namespace tricover::support {
namespace {

Pose behind(const Pose& pose_a, const Vec2& own, double angle) {
  Pose result = pose_a * turnedAndMoved(angle, 0, 0);
  result.translation() = pose_a * own;
  return result;
}

std::vector<Ring> ringWithHole(Random& random, double hole_low, double hole_high) {
  return {star(random, random.integer(5, 9), 9, 12), reversed(star(random, random.integer(4, 9), hole_low, hole_high))};
}

/// Rings on a small grid: they overlap, touch, pinch, repeat vertices and cross themselves.
Ring gridRing(Random& random, int vertices, int cells) {
  Ring ring;
  for (int i = 0; i < vertices; ++i) ring.emplace_back(random.integer(0, cells), random.integer(0, cells));
  return ring;
}

Case overlappingRings(Random& random, FillRule fill) {
  std::vector<Ring> rings;
  for (int i = random.integer(2, 3); i > 0; --i) {
    const double x = random.integer(0, 5), y = random.integer(0, 5);
    rings.push_back(random.coin() ? gridRing(random, random.integer(3, 5), 8)
                                  : rectangle(x, y, x + random.integer(2, 4), y + random.integer(2, 4)));
  }
  const Polygon a(redirected(random, rings), fill);
  const Pose pose_a = anyPose(random);
  const Vec2 own(random.integer(0, 16) / 2.0, random.integer(0, 16) / 2.0);
  const Pose pose_b = behind(pose_a, random.coin() ? nudged(random, own, 2) : own, random.coin() ? 0 : random.unit());
  const Vec2 direction(random.real(-1, 1), random.real(-1, 1));
  return {a, pose_a, Polygon({wedge(random, direction, random.real(0.1, 0.4))}, fill), pose_b};
}

}  // namespace

Case insideHole(Random& random) {
  const Polygon a(ringWithHole(random, 4, 6));
  const double size = random.real(2.5, 5);
  const Pose pose_a = anyPose(random);
  const Vec2 own(random.real(-0.5, 0.5), random.real(-0.5, 0.5));
  return {a, pose_a, Polygon({star(random, random.integer(4, 9), 0.6 * size, size)}),
          behind(pose_a, own, random.real(0, 6.3))};
}

Case touchingHole(Random& random) {
  const Polygon a(ringWithHole(random, 4, 6));
  const Pose pose_a = anyPose(random);
  const Case c{a, pose_a, Polygon({anyRing(random)}), behind(pose_a, Vec2::Zero(), random.real(0, 6.3))};
  return atFirstContact(random, c, turnedAndMoved(random.real(0, 6.3), 0, 0).linear().col(0) * 6, 1);
}

Case containment(Random& random) {
  std::vector<Ring> outer = ringWithHole(random, 4, 6);
  const Pose pose_a = anyPose(random);
  const double radius = 13 * std::sqrt(random.unit()), angle = random.real(0, 6.3);
  const Vec2 own(radius * std::cos(angle), radius * std::sin(angle));
  std::vector<Ring> small = {star(random, 5, 0.1, 0.3)};
  if (random.oneIn(3)) small.push_back(star(random, 4, 0.1, 0.3, {random.real(-3, 3), random.real(-3, 3)}));
  if (random.oneIn(3)) outer.push_back(regular(4, 1));
  Case c{Polygon(redirected(random, outer)), pose_a, Polygon(redirected(random, small)),
         behind(pose_a, own, random.real(0, 6.3))};
  if (random.coin()) {
    std::swap(c.a, c.b);
    std::swap(c.pose_a, c.pose_b);
  }
  return c;
}

Case pinched(Random& random) {
  const Ring twice_at_one = {{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}};
  const Ring square = rectangle(0, 0, 2, 2), hole_on_edge = {{1, 0}, {1.5, 1}, {0.5, 1}};
  const Ring hole_on_vertex = {{0, 0}, {1, 0.5}, {0.5, 1}};
  std::vector<Ring> rings = {square, random.coin() ? hole_on_edge : hole_on_vertex};
  Vec2 point = rings[1][0], direction(random.real(-1, 1), random.real(-1, 1));
  if (random.coin()) {
    rings = {twice_at_one};
    point = {1, 1};
    direction = random.coin() ? Vec2(1, -1) : Vec2(-1, 1);
  } else if (random.coin()) {
    // Into the hole from where it meets the outer ring.
    direction = Vec2(0.5 * (rings[1][1] + rings[1][2]) - point);
  }
  const double size = random.coin() ? 1 : random.real(0.5, 3);
  for (Ring& ring : rings) ring = scaled(ring, size);
  const Pose pose_a = anyPose(random);
  const int nudge = random.integer(0, 3);
  const Pose pose_b = behind(pose_a, nudged(random, size * point + random.integer(0, 1) * 1e-15 * direction, nudge), 0);
  return {Polygon(redirected(random, rings)), pose_a, Polygon({scaled(wedge(random, direction, 0.1), 0.3)}), pose_b};
}

Case bowTie(Random& random) {
  const auto coordinate = [&] { return random.coin() ? random.integer(1, 8) : random.real(1, 8); };
  // Lobes left and right of a crossing that is seldom a double; the notches above and below are free.
  const Ring ties = {{-coordinate(), -coordinate()},
                     {coordinate(), coordinate()},
                     {coordinate(), -coordinate()},
                     {-coordinate(), coordinate()}};
  Ring pentagram;
  const Ring corners = regular(5, random.real(1, 4));
  for (std::size_t i = 0; i < 5; ++i) pentagram.push_back(corners[2 * i % 5]);
  const FillRule fill = random.coin() ? FillRule::EvenOdd : FillRule::NonZero;
  const Pose pose_a = anyPose(random);
  if (random.oneIn(3)) {
    const Vec2 own(random.real(-1, 1), random.real(-1, 1));
    return {Polygon({pentagram}, fill), pose_a, Polygon({star(random, 4, 0.1, 0.4)}),
            behind(pose_a, own, random.real(0, 6.3))};
  }
  const Ring arrow = {{0, 0}, {0.01, 0.5}, {-0.01, 0.5}};
  const Case c{Polygon({ties}, fill), pose_a, Polygon({arrow}), behind(pose_a, {random.real(-0.3, 0.3), 9}, 0)};
  return atFirstContact(random, c, pose_a.linear() * Vec2(0, -12), 1);
}

Case repeatedAndCollinear(Random& random) {
  Case c = random.coin() ? vertexOnEdge(random) : random.coin() ? collinearOverlap(random) : gapOfUlps(random);
  c.a = Polygon({withRepeatedAndMidpoints(random, c.a.rings()[0])});
  c.b = Polygon({withRepeatedAndMidpoints(random, c.b.rings()[0])});
  const Ring ring = c.b.rings()[0];
  // Regions without an inside: one segment, there and back, and one point.
  if (random.oneIn(4)) c.b = Polygon({{ring[0], ring[1], ring[0], ring[1]}});
  if (random.oneIn(8)) c.b = Polygon({{ring[0], ring[0], ring[0]}});
  return c;
}

/// Convex ones, apart or at their first contact, a vertex of b and a point of an edge of a facing each other.
Case straightVertices(Random& random) {
  const auto anyRing = [&] {
    const Ring ring = anyConvex(random, random.real(0.5, 2), 20);
    return eitherWay(random, random.oneIn(8) ? ring : withStraightVertices(random, ring));
  };
  Case c{Polygon({anyRing()}), anyPose(random), Polygon({anyRing()}), anyPose(random)};
  const EdgeIndex edge = anyEdge(random, c.a);
  const Vec2 on_a = c.a.edgeStart(edge) + random.integer(0, 8) / 8.0 * (c.a.edgeEnd(edge) - c.a.edgeStart(edge));
  const Vec2 motion = 6 * direction(random.real(0, 6.3));
  c.pose_b.translation() = c.pose_a * on_a - c.pose_b.linear() * c.b.edgeStart(anyEdge(random, c.b));
  if (random.coin()) return c;
  c.pose_b.translation() -= motion;
  return random.coin() ? c : atFirstContact(random, c, motion, random.integer(0, 1));
}

Case ringDirections(Random& random) {
  std::vector<Ring> rings = ringWithHole(random, 6, 8);
  rings.push_back(star(random, random.integer(3, 6), 2, 4));
  rings.push_back(star(random, 4, 1, 2, {20, 0}));
  const Polygon a(redirected(random, rings), random.oneIn(4) ? FillRule::NonZero : FillRule::EvenOdd);
  const int edge = random.integer(0, static_cast<int>(a.vertexCount()) - 1);
  return wedgeOnEdge(random, a, anyPose(random), edge, 0.1);
}

Case overlappingRingsEvenOdd(Random& random) { return overlappingRings(random, FillRule::EvenOdd); }
Case overlappingRingsNonZero(Random& random) { return overlappingRings(random, FillRule::NonZero); }

Case smallGrid(Random& random) {
  const auto polygon = [&] {
    std::vector<Ring> rings;
    for (int i = random.integer(1, 2); i > 0; --i) rings.push_back(gridRing(random, random.integer(3, 6), 3));
    return Polygon(rings, random.coin() ? FillRule::EvenOdd : FillRule::NonZero);
  };
  const auto gridPose = [&] {
    Pose result = turnedAndMoved(0, random.integer(-2, 2), random.integer(-2, 2));
    if (random.coin()) result.linear() << 0, -1, 1, 0;
    return random.coin() ? mirrored(result) : result;
  };
  return {polygon(), gridPose(), polygon(), gridPose()};
}

Case flatRings(Random& random) {
  const auto gridPoint = [&] { return Vec2(random.integer(-3, 3), random.integer(-3, 3)); };
  // A point, a segment there and back, or a bent way there and back, whose parts may lie on other rings' edges.
  const auto flatRing = [&]() -> Ring {
    const Vec2 p = gridPoint(), q = gridPoint(), r = gridPoint();
    switch (random.integer(0, 3)) {
      case 0:
        return {p, p, p};
      case 1:
        return {p, q, q};
      case 2:
        return {p, q, p};
      default:
        return {p, q, r, q};
    }
  };
  const auto polygon = [&](int most) {
    std::vector<Ring> rings;
    if (random.coin())
      rings.push_back(random.coin() ? rectangle(-3, -3, 3, 3) : Ring{gridPoint(), gridPoint(), gridPoint()});
    for (int i = random.integer(1, most); i > 0; --i) rings.push_back(flatRing());
    return Polygon(redirected(random, rings), random.coin() ? FillRule::EvenOdd : FillRule::NonZero);
  };
  const Pose pose_a = anyPose(random);
  Pose pose_b = pose_a;
  if (random.oneIn(3)) pose_b.translation() += pose_a.linear() * Vec2(random.integer(-5, 5), random.integer(-5, 5));
  const Polygon a = polygon(2);
  return {a, pose_a, polygon(3), pose_b};
}

Case anyPair(Random& random) {
  return {Polygon({anyRing(random)}), randomPose(random, 2), Polygon({anyRing(random)}), randomPose(random, 2)};
}

}  // namespace tricover::support
