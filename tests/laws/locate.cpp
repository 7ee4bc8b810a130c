// SPDX-License-Identifier: BSD-3-Clause
// locate() against the exact truth: points where signs vanish, of a few edges and of so many that there is a field.
#include "tricover/locate.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "exact_reference.h"
#include "families.h"
#include "law.h"
#include "pairs.h"
#include "reference.h"
#include "reproduction.h"
#include "shapes.h"

namespace tricover::laws {
namespace {

using namespace support;

constexpr double kLargest = std::numeric_limits<double>::max();

/// Where signs vanish, or beside that by hardly anything; anywhere, or far away.
Vec2 anyPoint(Random& random, const Polygon& polygon) {
  constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
  const EdgeIndex edge = anyEdge(random, polygon);
  const Vec2 v = polygon.edgeStart(edge), w = polygon.edgeEnd(edge), s = polygon.coveringOrigin();
  const int ulps = random.integer(0, 2);
  switch (random.integer(0, 11)) {
    case 0:
      return v;
    case 1:
      return nudged(random, v, ulps);
    case 2:
      return nudged(random, v + random.integer(1, 7) / 8.0 * (w - v), ulps);
    case 3:
      return s;
    case 4:
      return nudged(random, s + random.integer(1, 7) / 4.0 * (v - s), ulps);
    case 5:
      return {v.x(), w.y()};
    case 6:
      return {random.coin() ? s.x() : v.x(), random.coin() ? s.y() : w.y()};
    case 7:
      return s + random.unit() * (v - s) + random.unit() * (w - s);
    case 8:
      return v + random.unit() * (w - v) + std::pow(10, random.real(-17, 0)) * random.unit() * (s - v);
    case 9:
      return s + polygon.radius() * Vec2(random.real(-1, 1), random.real(-1, 1));
    case 10:  // so near S that the edges along a ray are asked, too, which goes from elsewhere then
      return s + std::pow(10, random.integer(-18, -2)) * Vec2(random.integer(-1, 1), random.real(-1, 1));
    default: {
      const double odd[] = {0, -0.0, kSmallest, -kSmallest, kLargest, -kLargest, 1e300, 1e-300, v.x(), v.y()};
      return {odd[random.integer(0, 9)], odd[random.integer(0, 9)]};
    }
  }
}

std::string wrongAt(const Polygon& polygon, const Vec2& point, Tally& tally) {
  // The fast reference knows of no complements.
  const Location truth = polygon.isComplement() ? exact::locate(polygon, point) : Reference::locate(polygon, point);
  tally.count("outside", truth == Location::Outside);
  tally.count("boundary", truth == Location::Boundary);
  tally.count("inside", truth == Location::Inside);
  return locate(polygon, point) == truth ? "" : "location of " + reproduction(polygon, point);
}

/// Points anywhere, or a little farther on the way there.
std::string wrongAlong(Random& random, Tally& tally, const Polygon& polygon, int points) {
  Vec2 point = anyPoint(random, polygon);
  std::string wrong;
  for (int i = 0; i < points && wrong.empty(); ++i) {
    const Vec2 there = anyPoint(random, polygon);
    point = random.oneIn(3) ? Vec2(point + std::pow(10, random.real(-17, 0)) * random.unit() * (there - point)) : there;
    if (point.allFinite())
      wrong = wrongAt(polygon, point, tally);
    else
      point = polygon.coveringOrigin();
  }
  return wrong;
}

std::string wrong(Random& random, Tally& tally, Case& c) {
  std::string problem = wrongAlong(random, tally, c.a, 24);
  return problem.empty() ? wrongAlong(random, tally, c.b, 24) : problem;
}

/// Squares in rows, with S among them and as large as doubles go, so many that rays are led past them.
std::string wrongInRows(Random& random, Tally& tally) {
  const int columns = random.integer(4, 20), rows = random.integer(1, 3), slope = random.integer(-1, 1);
  const double side = random.coin() ? 2 : random.real(0.5, 1.5);
  std::vector<Ring> rings;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double x = 2 * column - columns, y = 2 * row + slope * x;
      rings.push_back(rectangle(x, y, x + side, y + side));
    }
  const double size = random.oneIn(3) ? kLargest / (2 * columns + 32) : random.oneIn(4) ? 1e-300 : 1;
  const double shift = random.coin() && size > 1 ? kLargest - (slope == 0 ? 8 : columns + 8) * size : 0;
  for (Ring& ring : rings) ring = shifted(scaled(std::move(ring), size), {0, shift});
  const Polygon polygon(redirected(random, rings), random.coin() ? FillRule::EvenOdd : FillRule::NonZero);

  // After the first few the hierarchy is there.
  return wrongAlong(random, tally, polygon, 72);
}

/// In the world: the point is rounded there, so that few are on an edge but where poses are quarter turns.
std::string wrongInTheWorld(Random& random, Tally& tally) {
  Ring ring = star(random, random.integer(3, 24), 1, 4);
  const bool on_grid = random.coin();
  if (on_grid)
    for (Vec2& p : ring) p = p.array().round();
  const Polygon polygon({ring});
  const double far = random.oneIn(3) ? std::pow(10, random.real(0, 15)) : 4;
  const Pose pose = on_grid ? poseAt(random.integer(-9, 9), random.integer(-9, 9), random.integer(-4, 4) * M_PI / 2)
                            : randomPose(random, far);
  const Vec2 point = pose * (on_grid ? Vec2(random.integer(-4, 4), random.integer(-4, 4)) : anyPoint(random, polygon));
  if (!point.allFinite()) return {};
  const Polygon there = Polygon::point(point);
  const Pose world = Pose::Identity();
  bool on_edge = false;
  for (EdgeIndex edge = 0; edge < polygon.edgeCount() && !on_edge; ++edge)
    on_edge = exact::collide(Polygon::segment(polygon.edgeStart(edge), polygon.edgeEnd(edge)), pose, there, world);
  const Location truth = on_edge                                                  ? Location::Boundary
                         : Reference(Case{polygon, pose, there, world}).collide() ? Location::Inside
                                                                                  : Location::Outside;
  tally.count("outside", truth == Location::Outside);
  tally.count("boundary", truth == Location::Boundary);
  tally.count("inside", truth == Location::Inside);
  return locate(polygon, pose, point) == truth ? "" : "location of " + reproduction({polygon, pose, there, world});
}

/// Of so many edges that there is a field, once all is derived or enough points have been asked.
std::string wrongOfMany(Random& random, Tally& tally) {
  std::vector<Ring> rings = {star(random, random.integer(64, 300), 2, 4)};
  if (random.coin()) rings.push_back(star(random, random.integer(3, 90), 0.5, 1.5));
  const bool crosses = random.coin();  // then there is no complement
  if (crosses) rings.push_back(rectangle(-3, -1, 0, 2));
  if (crosses && random.coin()) rings.push_back(regular(random.integer(3, 9), random.coin() ? 0.001 : 0.4));
  const Polygon polygon(redirected(random, rings), random.coin() ? FillRule::EvenOdd : FillRule::NonZero);
  return wrongAlong(random, tally, !crosses && random.coin() ? polygon.complement() : polygon, 72);
}

/// Speckles on a grid, rings in rings either way round, rings over each other, slivers and rings without an area; moved
/// by a whole number of their size, perhaps so far that doubles know nothing between those numbers.
std::string wrongOfSpeckles(Random& random, Tally& tally) {
  const double size = random.coin() ? 1 : std::ldexp(1, random.integer(-900, 900));
  const Vec2 shift = random.oneIn(4) ? Vec2(0x1p52, 0x1p52) : Vec2(random.coin() ? 1000 : 0, 0);
  std::vector<Ring> rings;
  for (int n = random.integer(16, 60); n > 0; --n) {
    const Vec2 at(random.integer(0, 12), random.integer(0, 12));
    const double x = 6 - at.x(), y = 7 + at.x();
    const Ring kinds[] = {rectangle(at.x(), at.y(), at.x() + 1, at.y() + 1),
                          rectangle(x, x, y, y),
                          star(random, random.integer(3, random.coin() ? 8 : 40), 0.5, 4, at),
                          {at, at + Vec2(random.integer(1, 5), 0), at + Vec2(random.integer(0, 5), 1e-9)},
                          {at, at + Vec2(random.integer(0, 4), random.integer(0, 4)), at}};
    rings.push_back(scaled(shifted(kinds[random.integer(0, 4)], shift), size));
  }
  const Polygon polygon(redirected(random, rings), random.coin() ? FillRule::EvenOdd : FillRule::NonZero);
  return wrongAlong(random, tally, polygon, 72);
}

/// The same edges, and yet another answer: the middle of a pentagram under either fill rule.
std::string wrongOfAnotherRule(Random&, Tally&) {
  Ring ring;
  for (int i = 0; i < 5; ++i) ring.push_back(Vec2(std::cos(0.8 * M_PI * i), std::sin(0.8 * M_PI * i)));
  const Polygon even_odd({ring}, FillRule::EvenOdd), non_zero({ring}, FillRule::NonZero);
  const bool is_right =
      locate(even_odd, Vec2::Zero()) == Location::Outside && locate(non_zero, Vec2::Zero()) == Location::Inside;
  return is_right ? "" : "the middle of a pentagram";
}

Shares sharesOf(double boundary) {
  return {{"outside", 0.05, 0.9}, {"boundary", boundary, 0.9}, {"inside", 0.05, 0.9}};
}

Laws locateLaws() {
  Laws laws = {{"rows", 120, wrongInRows, sharesOf(0.05)},
               {"in_the_world", 3000, wrongInTheWorld, sharesOf(0.02)},
               {"many", 200, wrongOfMany, sharesOf(0.05)},
               {"speckles", 300, wrongOfSpeckles, sharesOf(0.05)},
               {"fill_rules", 1, wrongOfAnotherRule, {}}};
  add(laws, familiesOfAllSizes(), 150, wrong, sharesOf(0.05));
  add(laws, anyPairs(), 100, wrong, {{"outside", 0.02, 0.98}});
  return laws;
}

const Register registered("locate", locateLaws);

}  // namespace
}  // namespace tricover::laws
