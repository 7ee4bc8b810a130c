// SPDX-License-Identifier: BSD-3-Clause
// conflicts() against exact collisions at many times on the way, and of bodies that are only shifted against exact
// intervals; with negative margins against depths.
#include "tricover/conflicts.h"

#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "conflict_laws.h"
#include "law.h"
#include "pairs.h"
#include "reference.h"
#include "reproduction.h"
#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/polygon.h"
#include "tricover/trajectory.h"

namespace tricover::laws {
namespace {

using namespace support;

Trajectory whole(const Motion& motion) { return Trajectory({{0, 1, motion}}); }

Vec2 anyVec(Random& random, double most) { return {random.real(-most, most), random.real(-most, most)}; }

Polygon anyStar(Random& random, double size) { return Polygon({star(random, random.integer(3, 9), 0.3 * size, size)}); }

Trajectory still() { return whole(Motion::still(Pose::Identity())); }

Motion anySpline(Random& random, double reach, double turn) {
  Motion motion = Motion::spline({anyVec(random, reach), random.real(-3, 3), anyVec(random, 4 * reach), turn},
                                 {anyVec(random, reach), random.real(-turn, turn), anyVec(random, 4 * reach), -turn},
                                 anyVec(random, 0.5));
  return motion;
}

/// Through walls a few apart.
Flight throughWalls(Random& random) {
  std::vector<Ring> walls;
  double x = -6;
  while (x < 6) {
    const double next = x + random.real(0.1, 2);
    walls.push_back(rectangle(x, -20, next, 20));
    x = next + random.real(0.2, 4);
  }
  const Vec2 way(random.real(-30, 30), random.real(-9, 9));
  const Vec2 from = anyVec(random, 4) - way / 2;
  return {Polygon(walls), still(), anyStar(random, 1),
          whole(Motion::translation(turnedAndMoved(random.real(0, 6), from.x(), from.y()), way))};
}

/// A bar that turns beside posts.
Flight turns(Random& random) {
  std::vector<Ring> posts;
  for (int i = random.integer(1, 4); i > 0; --i) {
    const Vec2 at = anyVec(random, 6);
    posts.push_back(rectangle(at.x(), at.y(), at.x() + 0.5, at.y() + 0.5));
  }
  Motion motion = Motion::still(turnedAndMoved(random.real(0, 6), random.real(-1, 1), 0));
  motion.angle = random.real(-15, 15);
  motion.shift = anyVec(random, 1);
  return {Polygon(posts), still(), Polygon({rectangle(-1, -0.2, random.real(2, 6), 0.2)}), whole(motion)};
}

/// Both on cubics, there and back.
Flight splines(Random& random) {
  return {anyStar(random, 1), whole(anySpline(random, 2, 2)), anyStar(random, 1), whole(anySpline(random, 2, 4))};
}

/// In and out of a frame, in which there is room.
Flight frames(Random& random) {
  const double hole = random.real(1.5, 4);
  return {Polygon({rectangle(-5, -5, 5, 5), rectangle(-hole, -hole, hole, hole)}), still(),
          anyStar(random, random.real(0.3, 1.2)), whole(anySpline(random, 6, 3))};
}

/// Teeth past teeth.
Flight combs(Random& random) {
  const Ring teeth = comb(random.integer(2, 5), 4, 2, 2);
  const Vec2 from = anyVec(random, 3) - Vec2(12, random.real(0, 4));
  return {Polygon({teeth}), still(), Polygon({teeth}),
          whole(Motion::translation(turnedAndMoved(random.coin() ? M_PI : random.real(0, 6), from.x(), from.y()),
                                    Vec2(24, random.real(-4, 4))))};
}

/// What crosses itself, points and segments.
Flight crossingOrThin(Random& random) {
  const Ring ring = star(random, 7, -1, 2);
  const Polygon crossing({ring, rectangle(-1, -1, 1, 1)}, random.coin() ? FillRule::EvenOdd : FillRule::NonZero);
  const Vec2 p = anyVec(random, 1);
  return {crossing, whole(anySpline(random, 1, 2)),
          random.coin() ? Polygon::point(p) : Polygon::segment(p, anyVec(random, 1)), whole(anySpline(random, 3, 3))};
}

Flight withMargins(Random& random) {
  Flight f = random.coin() ? splines(random) : turns(random);
  f.margin = random.real(0.01, 0.8);
  return f;
}

/// Legs and waits by clocks of their own.
Flight trajectories(Random& random) {
  return {anyStar(random, 1), anyPlan(random), anyStar(random, 1), anyPlan(random)};
}

/// Along a wall, at exactly its height: they touch for a while, and closed regions meet.
Flight grazing(Random& random) {
  const double x = random.integer(-6, 6), width = random.integer(1, 4);
  return {Polygon({rectangle(x, -2, x + width, 0)}), still(), Polygon({rectangle(-1, 0, 1, 2)}),
          whole(Motion::translation(turnedAndMoved(0, -8, 0), {16, 0}))};
}

/// With less of a margin than nothing: how deep they may be in each other.
/// A crate on a floor with steps, along it: over gaps, into walls, off the end.
Flight floors(Random& random) {
  Ring floor{{-8, -2}, {8, -2}};
  double x = 8, y = 0;
  while (x > -8) {
    floor.emplace_back(x, y);
    x = std::max(-8.0, x - random.real(0.5, 6));
    floor.emplace_back(x, y);
    if (random.oneIn(3)) y += random.real(-0.5, 0.5);
  }
  const double allowed = std::pow(10, random.real(-6, -1)), from = random.real(-6, 6);
  const Motion slides = random.coin()
                            ? Motion::translation(tricover::poseAt(from, 0.5 + random.real(-0.9, 0.5) * allowed),
                                                  {random.real(-20, 20), 0})
                            : Motion::spline({{from, 0.5}, 0, {9, 0}, 0}, {{random.real(-6, 6), 0.5}, 0, {9, 0}, 0});
  return {Polygon(floor), still(), Polygon::box(1, 1), whole(slides), -allowed};
}

Flight deepTurns(Random& random) {
  Motion motion = Motion::still(support::turnedAndMoved(random.real(0, 6), random.real(-3, 3), random.real(-3, 3)));
  motion.angle = random.real(-6, 6);
  motion.shift = anyVec(random, 4);
  return {anyStar(random, 1), still(), Polygon({rectangle(-1, -0.2, random.real(1, 4), 0.2)}), whole(motion),
          -random.real(0.001, 0.05)};
}

Flight deepSplines(Random& random) {
  const auto any = [&] {
    return whole(Motion::spline({anyVec(random, 2), random.real(-3, 3), anyVec(random, 8), random.real(-3, 3)},
                                {anyVec(random, 2), random.real(-3, 3), anyVec(random, 8), random.real(-3, 3)}));
  };
  return {Polygon(anyConvex(random, 1, 8)), any(), Polygon(anyConvex(random, 1, 8)), any(), -random.real(0.001, 0.5)};
}

Flight deepCombs(Random& random) {
  const Ring teeth = comb(random.integer(2, 4), 4, 1.5, 2);
  const Vec2 from = anyVec(random, 3) - Vec2(12, random.real(0, 4));
  return {Polygon({teeth}), still(), Polygon({teeth}),
          whole(Motion::translation(support::turnedAndMoved(M_PI, from.x(), from.y()), Vec2(24, random.real(-4, 4)))),
          -random.real(0.001, 0.05)};
}

Flight deepTrajectories(Random& random) {
  return {Polygon(anyConvex(random, 1, 8)), anyPlan(random), anyStar(random, 1), anyPlan(random),
          -random.real(0.001, 0.05)};
}

/// A ring of walls about a body that isn't convex, with much of its width allowed.
Flight rings(Random& random) {
  const Polygon walls({rectangle(-2, -2, 2, 2), rectangle(-1, -1, 1, 1)}),
      body({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}});
  const Vec2 from = anyVec(random, 4);
  Motion motion = Motion::translation(tricover::poseAt(from.x(), from.y()), anyVec(random, 8));
  if (random.coin()) motion.angle = random.real(-2, 2);
  return {body, still(), walls, whole(motion), -random.real(0.01, 0.45)};
}

/// A car in a lot with a post, of which the outside is forbidden.
Flight lots(Random& random) {
  const Polygon lot({rectangle(-5, -4, 5, 4), rectangle(-0.5, -0.5, 0.5, 0.5)});
  Motion motion = Motion::still(support::turnedAndMoved(random.real(0, 6), random.real(-5, 5), random.real(-4, 4)));
  motion.shift = anyVec(random, 8);
  motion.angle = random.real(-1, 1);
  return {lot.complement(), still(), Polygon::box(2, 1), whole(motion), -random.real(0.001, 0.3)};
}

/// Segments through thick bodies.
Flight segments(Random& random) {
  Motion motion = Motion::still(support::turnedAndMoved(random.real(0, 6), random.real(-2, 2), random.real(-2, 2)));
  motion.shift = anyVec(random, 4);
  motion.angle = random.real(-2, 2);
  const Polygon thin = Polygon::segment(anyVec(random, 2), anyVec(random, 2));
  return {random.coin() ? anyStar(random, 1) : Polygon::box(4, 2), still(), thin, whole(motion),
          -random.real(0.001, 0.5)};
}

struct Kind {
  const char* name;
  Flight (*make)(Random& random);
};
constexpr Kind kKinds[] = {{"through walls", throughWalls},
                           {"turns", turns},
                           {"splines", splines},
                           {"frames", frames},
                           {"combs", combs},
                           {"thin", crossingOrThin},
                           {"margins", withMargins},
                           {"plans", trajectories},
                           {"grazing", grazing}};
constexpr Kind kDeepKinds[] = {{"floors", floors},   {"turns", deepTurns},        {"splines", deepSplines},
                               {"combs", deepCombs}, {"plans", deepTrajectories}, {"rings", rings},
                               {"lots", lots},       {"segments", segments}};

std::string wrongFlight(const Flight& flight, const std::string& kind, double error, Meet meet, Tally& tally) {
  ConflictCounts counts;
  const std::string wrong = wrongConflicts(flight, error, meet, counts);
  tally.count("none", counts.none > 0);
  tally.count("one", counts.one > 0);
  tally.count("more", counts.more > 0);
  tally.count("at begin", counts.at_begin > 0);
  tally.count("until end", counts.until_end > 0);
  tally.count(kind, counts.spans > 0);
  for (int i = 0; i < counts.spans; ++i) tally.count("too short for a sample", i < counts.unseen);
  if (wrong.empty()) return wrong;
  return kind + ", " + wrong + ", time error " + hex(error) + ", margin " + hex(flight.margin) + "\n" +
         reproduction(
             {flight.a, flight.way_a.at(flight.way_a.begin()), flight.b, flight.way_b.at(flight.way_b.begin())});
}

std::string wrongOfKinds(Random& random, Tally& tally) {
  const Kind& kind = kKinds[random.integer(0, static_cast<int>(std::size(kKinds)) - 1)];
  const double error = std::pow(10, -random.integer(2, 6));
  return wrongFlight(kind.make(random), kind.name, kind.make == grazing ? 1e-3 : error, meetExactly, tally);
}

std::string wrongOfDeepKinds(Random& random, Tally& tally) {
  const Kind& kind = kDeepKinds[random.integer(0, static_cast<int>(std::size(kDeepKinds)) - 1)];
  const Meet isDeep = [](const Case& c, double margin) { return collide(c.a, c.pose_a, c.b, c.pose_b, {margin, 0}); };
  const double error = std::pow(10, -random.integer(2, 5));
  return wrongFlight(kind.make(random), kind.name, error, isDeep, tally);
}

bool meetByReference(const Case& c, double margin) {
  const Reference reference(c);
  return margin > 0 ? reference.within(margin) : reference.collide();
}

std::string wrongOfAnyShapes(Random& random, Tally& tally) {
  Limits limits;
  limits.most_vertices = 16;
  const Polygon a = anyShape(random, limits), b = anyShape(random, limits);
  Flight flight{a, anyPlan(random), b, anyPlan(random)};
  if (random.oneIn(3)) flight.margin = random.real(0.01, 0.8);
  return wrongFlight(flight, "plans", std::pow(10, -random.integer(2, 5)), meetByReference, tally);
}

Shares sharesOf(double least, const Kind* begin, const Kind* end) {
  Shares shares;
  for (const char* trait : {"none", "one", "more", "at begin", "until end"}) shares.push_back({trait, least, 0.9});
  for (; begin != end; ++begin) shares.push_back({begin->name, 0.1, 1});
  shares.push_back({"too short for a sample", 0, 0.1});
  return shares;
}

Laws conflictsLaws() {
  return {{"flights", 1800, wrongOfKinds, sharesOf(0.05, std::begin(kKinds), std::end(kKinds))},
          {"deep_flights", 1600, wrongOfDeepKinds, sharesOf(0.033, std::begin(kDeepKinds), std::end(kDeepKinds))},
          {"any_shapes", 300, wrongOfAnyShapes, {{"none", 0.02, 0.98}}}};
}

const Register registered("conflicts", conflictsLaws);

}  // namespace
}  // namespace tricover::laws
