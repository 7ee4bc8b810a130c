// SPDX-License-Identifier: BSD-3-Clause
// Complements in all queries that take them, against exact rationals: in the families of all other oracles, and of
// bodies in holes that they fit exactly or nearly.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "distance_laws.h"
#include "exact_reference.h"
#include "families.h"
#include "laws.h"
#include "random.h"
#include "ray_laws.h"
#include "reproduction.h"
#include "scene_walk.h"
#include "shapes.h"
#include "test_scale.h"
#include "touching_families.h"
#include "touching_laws.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/locate.h"
#include "tricover/ray.h"
#include "tricover/time_of_impact.h"

namespace tricover::support {
namespace {

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
Case plugs(std::uint64_t seed) {
  Random random(seed);
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
      plug = plug.translated(-plug.origin()).scaled(0x1p-5).translated(p);
      break;
    }
    if (random.oneIn(8)) complemented(plug);
    const double scale = random.oneIn(4) ? std::ldexp(1.0, random.integer(-900, 900)) : 1;
    if (scale != 1) outside = outside.scaled(scale), plug = plug.scaled(scale);
    Pose here = Pose::Identity();
    if (random.oneIn(3)) here = pose(random.real(0, 6.3), 0, 0);
    if (random.oneIn(3)) here.translation() = scale * std::ldexp(1.0, random.integer(0, 60)) * Vec2(1, -3);
    Pose there = here;
    if (random.coin()) there = here * pose(0, scale * random.integer(-4, 4) / 2.0, scale * random.integer(-4, 4) / 2.0);
    if (random.oneIn(4)) there = there * pose(random.real(-1, 1) * 1e-3, 0, 0);
    return random.coin() ? Case{outside, here, plug, there} : Case{plug, there, outside, here};
  }
}

std::vector<Family> allFamilies() {
  std::vector<Family> all = familiesOfAllSizes();
  all.insert(all.end(), touchingFamilies().begin(), touchingFamilies().end());
  all.push_back({"plugs", plugs});
  return all;
}

/// With one complement, or seldom two; b is as often as not moved to where a was.
Case withComplement(const Family& family, std::uint64_t seed) {
  const Case made = family.make(seed);
  if (family.make == plugs) return made;
  Random random(~seed);
  Case c = made;
  if (random.coin())
    c.pose_b.translation() += 0.5 * random.integer(0, 2) * (c.pose_a * c.a.origin() - c.pose_b * c.b.origin());
  if (!c.pose_b.translation().allFinite()) c.pose_b = made.pose_b;
  if (random.coin()) c.b = c.b.scaled(0x1p-3);
  const bool of_a = random.oneIn(4);
  if (!complemented(of_a ? c.a : c.b)) complemented(of_a ? c.b : c.a);
  if (random.oneIn(16)) complemented(c.a.isComplement() ? c.b : c.a);
  return c;
}

double anyMargin(Random& random, const Case& c) {
  const double size = std::min(c.a.radius(), c.b.radius());
  if (random.coin() || !(size > 1e-140 && size < 1e140)) return 0;
  const double apart = exact::distanceBelow(exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b));
  const double margin = random.coin() ? nudged(apart, random.integer(0, 1)) : size * random.unit();
  return margin < 1e150 ? margin : 0;
}

std::string wrongLocation(Random& random, const Polygon& polygon) {
  for (int i = 0; i < 8; ++i) {
    const EdgeIndex edge = anyEdge(random, polygon);
    const Vec2 v = polygon.edgeStart(edge), w = polygon.edgeEnd(edge), s = polygon.origin();
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

class Complements : public testing::TestWithParam<Family> {};

TEST_P(Complements, KeepToExactRationalsAndTheLawsOfAllQueries) {
  const bool is_own = GetParam().make == plugs;
  const int cases = scaledCount(is_own ? 400 : 15);
  int hits = 0, broken = 0, asked = 0, overlaps = 0;
  PairCache old;
  StrategyCaches old_strategies;
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Case c = withComplement(GetParam(), static_cast<std::uint64_t>(i) + 60000);
    if (!c.a.isComplement() && !c.b.isComplement()) continue;
    ++asked;
    const double margin = anyMargin(random, c);
    const Touching touching = i % 3 == 0 ? Touching::Allowed : Touching::Collides;
    const bool truth = areWithin(c, margin, touching);
    hits += truth;
    std::string wrong;
    try {
      const Overlap overlap = overlapOf(c);
      overlaps += overlap.overlap;
      wrong = wrongTouching(c, overlap, old_strategies, random);
      if (wrong.empty()) wrong = wrongTouchingInScene(c, overlap);
      if (wrong.empty()) {
        LimitedOptions options;
        if (random.coin()) options.margin = margin;
        if (random.coin()) options.relative_error = 0.1;
        PairCache cache;
        const bool is_plain = std::max(c.a.origin().stableNorm(), c.b.origin().stableNorm()) < 1e300;
        if (is_plain && !isOneTwice(c))
          wrong = wrongDistances(c, options, exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b), cache);
      }
      for (const auto& [polygon, pose] : {std::pair(c.a, c.pose_a), std::pair(c.b, c.pose_b)}) {
        if (wrong.empty()) wrong = wrongLocation(random, polygon);
        if (wrong.empty()) wrong = wrongRay(random, polygon, pose);
      }
      if (wrong.empty()) wrong = brokenLaw(c, margin, touching, truth, random, old);
    } catch (const std::exception& error) {
      wrong = error.what();
    }
    if (!wrong.empty() && ++broken <= 3)
      ADD_FAILURE() << GetParam().name << " seed " << i << ": " << wrong << "\n" << reproduction(c);
  }
  std::printf("%-22s %4d cases %4d hits %4d overlaps %4d broken\n", GetParam().name, asked, hits, overlaps, broken);
  EXPECT_EQ(broken, 0);
  EXPECT_GE(2 * asked, cases);
  if (!is_own || cases < 100) return;
  EXPECT_GE(hits, cases / 4);
  EXPECT_GE(hits - overlaps, cases / 16) << "touches";
  EXPECT_LT(hits, 9 * cases / 10);
}

INSTANTIATE_TEST_SUITE_P(Families, Complements, testing::ValuesIn(allFamilies()),
                         [](const auto& family) { return family.param.name; });

/// Zones and what is outside of them as bodies among others, against loops over the functions of pairs.
TEST(Complement, IsABodyAsAnyOther) {
  int asked = 0, hits = 0, began = 0, free = 0, impacts = 0, rays = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Random random(seed);
    const auto place = [&](double far) {
      return pose(random.real(0, 6.28), random.real(-far, far), random.real(-far, far));
    };
    std::vector<Case> cases;
    for (int i = 0; i < 4; ++i) {
      const Polygon zone({star(random, 20 + 40 * i, 8, 9), scaled(star(random, 5, 0.5, 1), 0.5)});
      const Polygon car({random.coin() ? star(random, 9, 0.2, 0.8) : regular(4 + i, 0.5)});
      cases.push_back({i < 2 ? zone.complement() : car, place(i < 2 ? 0.5 : 3), i == 1 ? zone : car, place(3)});
    }
    SceneWalk walk(cases, seed, seed == 0 ? 40 : 10);
    for (int frame = 0; frame < scaledCount(60) && walk.wrong.empty(); ++frame) walk.frame();
    EXPECT_EQ(walk.wrong, "") << "scene " << seed;
    asked += walk.asked, hits += walk.hits, began += walk.began, free += walk.free;
    impacts += walk.impacts_found, rays += walk.rays;
  }
  std::printf("%d answers %d collisions %d began %d free %d impacts %d rays\n", asked, hits, began, free, impacts,
              rays);
  if (isScaledDown()) return;
  for (const int count : {hits, began, free, impacts, rays}) EXPECT_GE(count, 10);
}

/// A body in a hole moves and rotates: never is it outside before the impact, and it touches there.
TEST(Complement, IsReachedByMotionsNoSoonerAndNoLater) {
  int impacts = 0, starts = 0, none = 0;
  const int cases = scaledCount(600);
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i) + 5000);
    std::vector<Ring> rings = {random.coin() ? star(random, random.integer(4, 40), 3, 9) : rectangle(-9, -4, 9, 4)};
    if (random.coin()) rings.push_back(star(random, random.integer(3, 9), 0.3, 1, {random.real(-2, 2), 2}));
    const Polygon outside = Polygon(rings).complement();
    const Polygon body({random.coin() ? star(random, random.integer(3, 20), 0.3, 1) : rectangle(-1, -0.5, 1, 0.5)});
    Motion motion = Motion::still(pose(random.real(0, 6.3), random.real(-1, 1), random.real(-1, 1)));
    motion.shift = random.coin() ? Vec2(random.real(-9, 9), random.real(-9, 9)) : Vec2(random.real(-1, 1), 0);
    if (random.coin()) motion.angle = random.real(-6, 6);
    if (random.oneIn(3)) motion.shift_2 = Vec2(random.real(-3, 3), random.real(-3, 3));
    const Motion other = random.coin() ? Motion::still(Pose::Identity())
                                       : Motion::translation(Pose::Identity(), {random.real(-1, 1), 0});
    const double margin = random.oneIn(3) ? random.real(0, 0.3) : 0, time_error = random.coin() ? 1e-3 : 1e-9;
    const auto distanceAt = [&](double time) {
      return distance(outside, other.at(time), body, motion.at(time)).distance;
    };
    const auto impact = timeOfImpact(outside, other, body, motion, {margin, time_error});
    const double until = impact ? impact->time : 1;
    starts += until == 0;
    impacts += until > 0 && impact.has_value();
    none += !impact;
    for (int k = 0; k < 40; ++k) {
      const double time = until * k / 40;
      ASSERT_TRUE(time < until ? distanceAt(time) > margin - 1e-12 : true)
          << i << " at " << time << " before " << until;
    }
    if (!impact) continue;
    ASSERT_FALSE(impact->budget_ended) << i;
    const double speed =
        motion.shift.norm() + 2 * motion.shift_2.norm() + other.shift.norm() + 2 * std::abs(motion.angle);
    ASSERT_LE(distanceAt(until), margin + 1e-11 + speed * time_error) << i;
  }
  std::printf("%d impacts, %d at the start, %d none\n", impacts, starts, none);
  if (isScaledDown()) return;
  EXPECT_GE(std::min({impacts, 5 * starts, none}), cases / 10);
}

/// A body that reaches out of a lane on one side: the contacts' points are on both, and the deepest contact tells how
/// far it must go back.
TEST(Complement, HasLocalDepthsThatLeadBack) {
  int out = 0, several = 0;
  const int cases = scaledCount(1000);
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i) + 9000);
    const double turn = random.oneIn(3) ? 0 : random.real(0, 6.3), x = random.real(-20, 20);
    const Pose frame = pose(turn, random.real(-9, 9), 0);
    const Polygon outside = Polygon({rectangle(-30, -2, 30, 2)}).complement();
    const Polygon body({random.coin() ? star(random, random.integer(3, 30), 0.3, 1) : rectangle(-1, -0.5, 1, 0.5)});
    const Pose in_lane = pose(random.real(0, 6.3), x, random.real(0.5, 2));
    double excess = -2;
    for (const Vec2& v : body.rings()[0]) excess = std::max(excess, (in_lane * v).y() - 2);
    const std::vector<Contact> found =
        contacts(outside, frame, body, frame * in_lane, {0, 99, ContactDetail::LocalDepth});
    if (std::abs(excess) < 1e-12) continue;
    ASSERT_EQ(found.empty(), excess < 0) << i;
    if (found.empty()) continue;
    ++out;
    several += found.size() > 1;
    ASSERT_NEAR(found[0].depth, excess, 1e-11) << i;
    for (const Contact& contact : found) {
      ASSERT_NEAR((contact.normal - frame.linear() * Vec2(0, -1)).norm(), 0, 1e-9) << i;
      const Polygon point({Ring(3, contact.point)});
      const Pose here = Pose::Identity();
      ASSERT_LT(distance(outside, frame, point, here).distance, 1e-12) << i;
      ASSERT_LT(distance(body, frame * in_lane, point, here).distance, 1e-12) << i;
    }
  }
  std::printf("%d reach out, %d at several places\n", out, several);
  if (isScaledDown()) return;
  EXPECT_GE(std::min(out, 4 * several), cases / 8);
}

/// Points of a lattice of quarters around the polygons: a point of the complement is one where points outside are as
/// near as you like.
TEST(Complement, IsTheClosureOfTheOutside) {
  int left_out = 0, refused = 0;
  const int cases = scaledCount(400);
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Polygon polygon = anyArea(random);
    Polygon outside = polygon;
    if (!complemented(outside)) {
      ++refused;
      continue;
    }
    left_out += outside.vertexCount() < polygon.vertexCount();
    ASSERT_TRUE(outside.isComplement());
    const Polygon inside = outside.complement();
    ASSERT_FALSE(inside.isComplement());
    ASSERT_EQ(inside.rings(), outside.rings()) << "every edge is a border";
    for (int k = 0; k < 60; ++k) {
      const EdgeIndex edge = anyEdge(random, polygon);
      const Vec2 v = polygon.edgeStart(edge), w = polygon.edgeEnd(edge);
      Vec2 p = random.coin() ? Vec2(v + random.integer(0, 4) / 4.0 * (w - v))
                             : Vec2(random.integer(-24, 24) / 4.0, random.integer(-24, 24) / 4.0);
      if ((p - w).norm() < 0x1p-40) p = w;  // not on the edge beside a vertex, within the probe below
      const Location location = exact::locate(polygon, p);
      if (location != Location::Boundary) {
        const bool is_inside = location == Location::Inside;
        ASSERT_EQ(locate(outside, p), is_inside ? Location::Outside : Location::Inside) << reproduction(polygon, p);
        ASSERT_EQ(locate(inside, p), location) << reproduction(polygon, p);
        continue;
      }
      // Whether a small square around it has a corner of the region's other side: of borders exactly.
      const Polygon probe({rectangle(p.x() - 0x1p-30, p.y() - 0x1p-30, p.x() + 0x1p-30, p.y() + 0x1p-30)});
      const Pose here = Pose::Identity();
      const bool has_outside = exact::interiorsMeet(outside, here, probe, here);
      const bool has_inside = exact::interiorsMeet(polygon, here, probe, here);
      ASSERT_EQ(locate(outside, p) != Location::Outside, has_outside) << reproduction(polygon, p);
      ASSERT_EQ(locate(outside, p) == Location::Boundary, has_outside && has_inside) << reproduction(polygon, p);
      ASSERT_EQ(locate(inside, p) == Location::Boundary, has_outside && has_inside) << reproduction(polygon, p);
    }
  }
  std::printf("%d cases, %d refused, %d without some edges\n", cases, refused, left_out);
  if (isScaledDown()) return;
  EXPECT_GE(left_out, cases / 16);
  EXPECT_LT(refused, cases / 4);
}

}  // namespace
}  // namespace tricover::support
