// SPDX-License-Identifier: BSD-3-Clause
// Complements as regions: in every query they keep to exact rationals and to the laws of all queries; the complement of
// a complement, and where points are in either.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "collide_laws.h"
#include "distance_laws.h"
#include "exact_reference.h"
#include "families.h"
#include "law.h"
#include "laws.h"
#include "limited_distance.h"
#include "pairs.h"
#include "ray_laws.h"
#include "reproduction.h"
#include "shapes.h"
#include "touching_families.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/locate.h"
#include "tricover/ray.h"
#include "tricover/time_of_impact.h"

namespace tricover::laws {
namespace {

using namespace support;

/// False for what has no area, and where a crossing under the non-zero rule can't be said in doubles.
bool complemented(Polygon& polygon) {
  try {
    polygon = polygon.complement();
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

/// On a lattice, with holes, pinched, or rings that cross.
Polygon anyArea(Random& random) {
  std::vector<Ring> rings;
  for (int more = random.integer(0, 3); more >= 0; --more) {
    const Vec2 at(random.integer(-2, 2), random.integer(-2, 2));
    switch (random.integer(0, 2)) {
      case 0:
        rings.push_back(shifted(rectangle(0, 0, random.integer(1, 4), random.integer(1, 4)), at));
        break;
      case 1:
        rings.push_back(shifted(comb(random.integer(1, 4), 2, 1, random.integer(1, 3)), at));
        break;
      default:
        rings.push_back(star(random, random.integer(3, 12), 1, 4, at));
        for (Vec2& v : rings.back())
          if (random.coin()) v = Vec2(std::round(v.x()), std::round(v.y()));
    }
    if (random.oneIn(4)) rings.back() = withRepeatedAndMidpoints(random, rings.back());
    if (random.oneIn(8)) rings.emplace_back(3, at + Vec2(1, random.integer(0, 4) / 2.0));
  }
  return Polygon(redirected(random, rings), random.oneIn(4) ? FillRule::NonZero : FillRule::EvenOdd);
}

/// a: what is outside of a polygon. b: that polygon, one of its rings, a piece of it, or a little larger or smaller,
/// where the hole is or beside that; everything moved far away, or as small as can be, here and there.
Case plugs(Random& random) {
  for (;;) {
    const Polygon hole = anyArea(random);
    Polygon outside = hole, plug = hole;
    if (!complemented(outside)) continue;
    if (random.coin()) {
      const auto ring = static_cast<std::size_t>(random.integer(0, static_cast<int>(outside.rings().size()) - 1));
      plug = Polygon({outside.rings()[ring]});
    }
    if (random.oneIn(3)) plug = Polygon({rectangle(0, 0, random.integer(1, 2) / 2.0, random.integer(1, 2) / 2.0)});
    if (random.coin()) plug = plug.scaled(random.coin() ? 0.25 : 1 + random.integer(-1, 1) * 0x1p-52);
    for (int tries = random.coin() ? 20 : 0; tries > 0; --tries) {  // small, around a point inside
      const Vec2 p(random.integer(-24, 24) / 4.0, random.integer(-24, 24) / 4.0);
      if (exact::locate(hole, p) != Location::Inside) continue;
      plug = plug.translated(-plug.coveringOrigin()).scaled(0x1p-5).translated(p);
      break;
    }
    if (random.oneIn(16)) complemented(plug);
    const double scale = random.oneIn(4) ? std::ldexp(1.0, random.integer(-900, 900)) : 1;
    if (scale != 1) outside = outside.scaled(scale), plug = plug.scaled(scale);
    Pose here = Pose::Identity();
    if (random.oneIn(3)) here = turnedAndMoved(random.real(0, 6.3), 0, 0);
    if (random.oneIn(3)) here.translation() = scale * std::ldexp(1.0, random.integer(0, 60)) * Vec2(1, -3);
    Pose there = here;
    if (random.coin())
      there = here * turnedAndMoved(0, scale * random.integer(-4, 4) / 2.0, scale * random.integer(-4, 4) / 2.0);
    if (random.oneIn(8)) there = there * turnedAndMoved(random.real(-1, 1) * 1e-3, 0, 0);
    return random.coin() ? Case{outside, here, plug, there} : Case{plug, there, outside, here};
  }
}

/// With one complement, or seldom two; b is as often as not moved to where a was.
Case withComplement(Random& random, const Case& made) {
  Case c = made;
  if (random.coin())
    c.pose_b.translation() +=
        0.5 * random.integer(0, 2) * (c.pose_a * c.a.coveringOrigin() - c.pose_b * c.b.coveringOrigin());
  if (!c.pose_b.translation().allFinite()) c.pose_b = made.pose_b;
  if (random.coin()) c.b = c.b.scaled(0x1p-3);
  const bool of_a = random.oneIn(4);
  if (!complemented(of_a ? c.a : c.b)) complemented(of_a ? c.b : c.a);
  if (random.oneIn(16)) complemented(c.a.isComplement() ? c.b : c.a);
  return c;
}

std::string wrongLocation(Random& random, const Polygon& polygon) {
  for (int i = 0; i < 8; ++i) {
    const EdgeIndex edge = anyEdge(random, polygon);
    const Vec2 v = polygon.edgeStart(edge), w = polygon.edgeEnd(edge), s = polygon.coveringOrigin();
    const double share = random.integer(0, 8) / 4.0;
    const Vec2 p =
        random.coin() ? Vec2(v + share * (w - v)) : Vec2(s + share * std::pow(10, random.integer(0, 20)) * (v - s));
    if (p.allFinite() && locate(polygon, p) != exact::locate(polygon, p)) return "locate\n" + reproduction(polygon, p);
  }
  return {};
}

std::string wrongRay(Random& random, const Polygon& polygon, const Pose& pose) {
  for (int i = 0; i < 4; ++i) {
    const Ray ray = anyRay(random, polygon, pose);
    if (!ray.from.allFinite() || !ray.to.allFinite()) continue;
    const std::string wrong_intervals = wrongIntervals(polygon, pose, ray, castRayAll(polygon, pose, ray.from, ray.to),
                                                       exact::castRayAll(polygon, pose, ray.from, ray.to));
    if (!wrong_intervals.empty()) return "all of a ray: " + wrong_intervals;
    const auto truth = exact::castRay(polygon, pose, ray.from, ray.to);
    const auto hit = castRay(polygon, pose, ray.from, ray.to);
    if (hit.has_value() != truth.has_value()) return "whether a ray hits";
    if (!hit) continue;
    const std::string wrong = truth->edge < 0 ? (hit->edge >= 0 || hit->fraction != 0 ? "start" : "")
                                              : wrongHit(polygon, pose, ray, *hit, *truth);
    if (!wrong.empty()) return "a ray's " + wrong;
  }
  return {};
}

std::string wrongWith(Random& random, Tally& tally, const Case& c) {
  const double margin = anyMargin(random, c);
  const Touching touching = random.oneIn(3) ? Touching::Allowed : Touching::Collides;
  const bool truth = areWithin(c, margin, touching);
  const Overlap overlap = overlapOf(c);
  tally.count("hits", truth);
  tally.count("touches", truth && !overlap.overlap);
  StrategyCaches old = cachesOfOthers(random);
  std::string wrong = wrongTouching(c, overlap, old, random);
  if (wrong.empty()) wrong = wrongTouchingInScene(c, overlap);
  if (wrong.empty()) {
    LimitedOptions options;
    if (random.coin()) options.margin = margin;
    if (random.coin()) options.relative_error = 0.1;
    PairCache cache;
    const bool is_plain = std::max(c.a.coveringOrigin().stableNorm(), c.b.coveringOrigin().stableNorm()) < 1e300;
    if (is_plain && !isOneTwice(c))
      wrong = wrongDistances(c, options, exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b), cache);
  }
  for (const auto& [polygon, pose] : {std::pair(c.a, c.pose_a), std::pair(c.b, c.pose_b)}) {
    if (wrong.empty()) wrong = wrongLocation(random, polygon);
    if (wrong.empty()) wrong = wrongRay(random, polygon, pose);
  }
  return wrong.empty() ? brokenLaw(c, margin, touching, truth, random, old.of_pair) : wrong;
}

std::string wrong(Random& random, Tally& tally, Case& c) {
  c = withComplement(random, c);
  const bool has_one = c.a.isComplement() || c.b.isComplement();
  tally.count("complements", has_one);
  return has_one ? wrongWith(random, tally, c) : "";
}

std::string wrongPlugs(Random& random, Tally& tally, Case& c) { return wrongWith(random, tally, c); }

/// A body in a hole moves and rotates: never is it outside before the impact, and it touches there.
std::string wrongMotion(Random& random, Tally& tally) {
  std::vector<Ring> rings = {random.coin() ? star(random, random.integer(4, 40), 3, 9) : rectangle(-9, -4, 9, 4)};
  if (random.coin()) rings.push_back(star(random, random.integer(3, 9), 0.3, 1, {random.real(-2, 2), 2}));
  const Polygon outside = Polygon(rings).complement();
  const Polygon body({random.coin() ? star(random, random.integer(3, 20), 0.3, 1) : rectangle(-1, -0.5, 1, 0.5)});
  Motion motion = Motion::still(turnedAndMoved(random.real(0, 6.3), random.real(-1, 1), random.real(-1, 1)));
  motion.shift = random.coin() ? Vec2(random.real(-9, 9), random.real(-9, 9)) : Vec2(random.real(-1, 1), 0);
  if (random.coin()) motion.angle = random.real(-6, 6);
  if (random.oneIn(3)) motion.shift_2 = Vec2(random.real(-3, 3), random.real(-3, 3));
  const Motion other =
      random.coin() ? Motion::still(Pose::Identity()) : Motion::translation(Pose::Identity(), {random.real(-1, 1), 0});
  const double margin = random.oneIn(3) ? random.real(0, 0.3) : 0, time_error = random.coin() ? 1e-3 : 1e-9;
  const auto distanceAt = [&](double time) {
    return distance(outside, other.at(time), body, motion.at(time)).distance;
  };

  const auto impact = timeOfImpact(outside, other, body, motion, {margin, time_error});
  const double until = impact ? impact->time : 1;
  tally.count("at once", until == 0);
  tally.count("later", until > 0 && impact);
  tally.count("never", !impact);
  const std::string text = ", margin " + hex(margin) + ", time error " + hex(time_error) + "\n" +
                           reproduction(MovingCase{outside, other, body, motion});
  for (int k = 0; k < 40; ++k) {
    const double time = until * k / 40;
    if (time < until && !(distanceAt(time) > margin - 1e-12)) return "outside before, at " + hex(time) + text;
  }
  if (!impact) return {};
  const double speed =
      motion.shift.norm() + 2 * motion.shift_2.norm() + other.shift.norm() + 2 * std::abs(motion.angle);
  if (impact->budget_ended) return "a budget ended" + text;
  return distanceAt(until) <= margin + 1e-11 + speed * time_error ? "" : "it doesn't touch" + text;
}

/// A body that reaches out of a lane on one side: the contacts' points are on both, and the deepest contact tells how
/// far it must go back.
std::string wrongLane(Random& random, Tally& tally) {
  const double turn = random.oneIn(3) ? 0 : random.real(0, 6.3), x = random.real(-20, 20);
  const Pose frame = turnedAndMoved(turn, random.real(-9, 9), 0);
  const Polygon outside = Polygon({rectangle(-30, -2, 30, 2)}).complement();
  const Polygon body({random.coin() ? star(random, random.integer(3, 30), 0.3, 1) : rectangle(-1, -0.5, 1, 0.5)});
  const Pose in_lane = turnedAndMoved(random.real(0, 6.3), x, random.real(0.5, 2));
  double excess = -2;
  for (const Vec2& v : body.rings()[0]) excess = std::max(excess, (in_lane * v).y() - 2);
  const std::vector<Contact> found =
      contacts(outside, frame, body, frame * in_lane, {0, 99, ContactDetail::LocalDepth});

  if (std::abs(excess) < 1e-12) return {};
  const std::string text = "\n" + reproduction({outside, frame, body, frame * in_lane});
  tally.count("hits", !found.empty());
  if (found.empty() != (excess < 0)) return "whether it reaches out" + text;
  if (found.empty()) return {};
  tally.count("several", found.size() > 1);
  if (!(std::abs(found[0].depth - excess) <= 1e-11)) return "depth" + text;
  for (const Contact& contact : found) {
    const Polygon point({Ring(3, contact.point)});
    const Pose here = Pose::Identity();
    if (!((contact.normal - frame.linear() * Vec2(0, -1)).norm() <= 1e-9)) return "normal" + text;
    if (!(distance(outside, frame, point, here).distance < 1e-12)) return "a point inside" + text;
    if (!(distance(body, frame * in_lane, point, here).distance < 1e-12)) return "a point beside the body" + text;
  }
  return {};
}

/// A point of the complement is one where points outside are as near as you like: in a small square around it.
std::string wrongPoint(Random& random, const Polygon& polygon, const Polygon& outside, const Polygon& inside) {
  const EdgeIndex edge = anyEdge(random, polygon);
  const Vec2 v = polygon.edgeStart(edge), w = polygon.edgeEnd(edge);
  Vec2 p = random.coin() ? Vec2(v + random.integer(0, 4) / 4.0 * (w - v))
                         : Vec2(random.integer(-24, 24) / 4.0, random.integer(-24, 24) / 4.0);
  if ((p - w).norm() < 0x1p-40) p = w;  // not on the edge beside a vertex, within the square
  const Location location = exact::locate(polygon, p);
  const Polygon square({rectangle(p.x() - 0x1p-30, p.y() - 0x1p-30, p.x() + 0x1p-30, p.y() + 0x1p-30)});
  const Pose here = Pose::Identity();
  const bool is_boundary = location == Location::Boundary;
  const bool has_outside =
      is_boundary ? exact::interiorsMeet(outside, here, square, here) : location == Location::Outside;
  const bool has_inside =
      is_boundary ? exact::interiorsMeet(polygon, here, square, here) : location == Location::Inside;
  const auto expected = [](bool own, bool other) {
    return own && other ? Location::Boundary : own ? Location::Inside : Location::Outside;
  };
  // Of what has no inside around it the complement of the complement has nothing.
  return locate(outside, p) == expected(has_outside, has_inside) &&
                 locate(inside, p) == expected(has_inside, has_outside)
             ? ""
             : "locate\n" + reproduction(polygon, p);
}

std::string wrongClosure(Random& random, Tally& tally) {
  const Polygon polygon = anyArea(random);
  Polygon outside = polygon;
  const bool refused = !complemented(outside);
  tally.count("refused", refused);
  if (refused) return {};
  tally.count("left out", outside.vertexCount() < polygon.vertexCount());
  const Polygon inside = outside.complement();
  std::string wrong;
  if (!outside.isComplement() || inside.isComplement() || inside.rings() != outside.rings())
    wrong = "not every edge is a border\n" + reproduction(polygon, Vec2::Zero());
  for (int k = 0; k < 60 && wrong.empty(); ++k) wrong = wrongPoint(random, polygon, outside, inside);
  return wrong;
}

Laws complementLaws() {
  Laws laws = {{"motions", 600, wrongMotion, {{"at once", 0.02, 0.8}, {"later", 0.1, 0.9}, {"never", 0.1, 0.9}}},
               {"lanes", 1000, wrongLane, {{"hits", 0.125, 0.9}, {"several", 0.06, 0.9}}},
               {"closure", 400, wrongClosure, {{"left out", 0.0625, 0.9}, {"refused", 0, 0.25}}}};
  add(laws, {family("plugs", plugs)}, 400, wrongPlugs, {{"hits", 0.25, 0.9}, {"touches", 0.0625, 0.9}});
  add(laws, joined(familiesOfAllSizes(), touchingFamilies()), 15, wrong, {{"complements", 0.5, 1}});
  return laws;
}

const Register registered("complement", complementLaws);

}  // namespace
}  // namespace tricover::laws
