// SPDX-License-Identifier: BSD-3-Clause
// collide() in every way to ask it, with margins and tolerances, against the exact truth.
#include "tricover/collide.h"

#include <cmath>

#include "collide_laws.h"
#include "law.h"
#include "pairs.h"
#include "reference.h"
#include "shapes.h"

namespace tricover::laws {
namespace {

std::string wrong(Random& random, Tally& tally, Case& c) {
  const support::Reference reference(c);
  CollideOptions options;
  if (random.oneIn(4)) options.margin = anyMargin(random, c);
  const bool truth = options.margin == 0 ? reference.collide() : reference.within(options.margin);
  tally.count("hits", truth);
  support::StrategyCaches old = cachesOfOthers(random);
  const std::string problem = support::wrongCollide(c, options, {truth, truth}, old, random);
  if (!problem.empty() || !random.oneIn(8)) return problem;
  options.tolerance = smallerRadius(c) * random.real(0, 2);
  return support::wrongCollide(c, options, {truth, reference.within(options.margin + options.tolerance)}, old, random);
}

/// A million million away from its own frame's origin, a polygon's place is known to a ten-thousandth: a ring that is
/// contained, or touched, by less than that. The block's flat sides are those of the box around it.
Case farFromItsOrigin(Random& random) {
  const Vec2 far(5e11, -7e11);
  const Ring dot = support::shifted(support::rectangle(-2e-4, -2e-4, 2e-4, 2e-4), far);
  const Pose frame = support::turnedAndMoved(random.real(0, 6.28), 0, 0);
  const double away = random.real(1.5e-4, 4e-4), side = random.coin() ? 1 : -1;
  const auto placed = [&](const Vec2& point) {
    Pose result = support::turnedAndMoved(random.real(0, 6.28), 0, 0);
    result.translation() = frame * point - result * far;
    return result;
  };
  if (random.coin())
    return {Polygon({{{-1.1, 0}, {-0.9, -0.5}, {0.9, -0.5}, {1.1, 0}, {0.9, 0.5}, {-0.9, 0.5}}}), frame, Polygon({dot}),
            placed({random.real(-0.8, 0.8), 0.5 + side * away})};
  return {Polygon({dot, support::shifted(support::rectangle(-20, 30, 20, 40), far)}), placed({1 - away, 0}),
          Polygon({support::regular(60, 1)}), frame};
}

/// Tips that touch on the line of centres, seen from far away, or under poses as large as these may be.
Case tips(Random& random) {
  const bool is_far = random.coin();
  const Vec2 far = is_far ? Vec2(5e11, -7e11) : Vec2(0, 0);
  const double angle = random.real(0, 6.28), grown = is_far ? 1 : 1 + 4.9e-7;
  Pose frame = support::turnedAndMoved(angle, 0, 0);
  Pose there = support::turnedAndMoved(angle + 0.5 * M_PI * random.integer(0, 3), 0, 0);
  there.linear() *= grown;
  there.translation() = frame * Vec2(2 + (is_far ? random.real(-3e-4, 3e-4) : 9e-7), 0) - there * far;
  frame.linear() *= grown;
  return {Polygon({support::regular(4, 1)}), frame, Polygon({support::shifted(support::regular(4, 1), far)}), there};
}

std::string wrongAmongRings(Random& random, Tally& tally, Case& c) {
  const support::Reference reference(c);
  tally.count("contained", reference.collide() && reference.meetingEdges().empty());
  return wrong(random, tally, c);
}

Laws collideLaws() {
  Laws laws;
  add(laws, {family("far_from_its_origin", farFromItsOrigin), family("tips", tips)}, 5000, wrong,
      {{"hits", 0.2, 0.95}});
  add(laws, {family("among_many_rings", smallAmongManyRings)}, 1500, wrongAmongRings,
      {{"hits", 0.2, 0.8}, {"contained", 0.02, 0.5}});
  add(laws, support::families(), 5000, wrong, {{"hits", 0.15, 0.85}});
  add(laws, anyPairs(), 3000, wrong);
  return laws;
}

const Register registered("collide", collideLaws);

}  // namespace
}  // namespace tricover::laws
