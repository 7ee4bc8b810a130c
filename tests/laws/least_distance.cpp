// SPDX-License-Identifier: BSD-3-Clause
// leastDistance() of motions that are only shifted against exact rationals, of others beside distances at many times.
#include <algorithm>
#include <cmath>
#include <string>

#include "conflict_laws.h"
#include "exact_reference.h"
#include "lasting_contact_laws.h"
#include "law.h"
#include "least_distance_laws.h"
#include "pairs.h"
#include "reproduction.h"
#include "shapes.h"
#include "tricover/segment.h"

namespace tricover::laws {
namespace {

using namespace support;

LeastDistanceOptions anyOptions(Random& random) {
  LeastDistanceOptions options;
  options.error = std::pow(10, -random.integer(2, 11));
  if (random.oneIn(3)) options.margin = 0.25 * random.integer(1, 12);
  return options;
}

/// Vertices, starts and shifts on a grid: sums are exact.
MovingCase onGrid(Random& random) {
  const auto polygon = [&] {
    if (random.oneIn(6)) return point({0, 0});
    Ring ring = star(random, random.integer(3, 8), 1, 4);
    for (Vec2& v : ring) v = v.array().round();
    return random.coin() ? Polygon({rectangle(-random.integer(1, 3), -random.integer(1, 3), 2, 1)}) : Polygon({ring});
  };
  const auto anywhere = [&](int most) {
    return Vec2(0.25 * random.integer(-4 * most, 4 * most), 0.25 * random.integer(-4 * most, 4 * most));
  };
  const Vec2 from = anywhere(12);
  Vec2 by = anywhere(16) - 1.5 * from;
  if (random.oneIn(3)) by[random.integer(0, 1)] = 0;
  const Vec2 of_a = random.coin() ? Vec2(Vec2::Zero()) : anywhere(4);
  return {polygon(), Motion::translation(Pose::Identity(), of_a), polygon(),
          Motion::translation(tricover::pose(from.x(), from.y()), by + of_a)};
}

std::string told(const LeastDistance& found, const LeastDistanceOptions& options) {
  return ", found " + hex(found.distance) + ", error " + hex(options.error) + ", margin " + hex(options.margin) + "\n";
}

void count(Tally& tally, const LeastDistance& found) {
  tally.count("meet", found.distance == 0);
  tally.count("budget ended", found.budget_ended);
}

std::string wrongOfMotions(const MovingCase& m, const LeastDistanceOptions& options, const LeastDistance& found,
                           int samples) {
  const std::string wrong = wrongLeastDistance(m.a, m.motion_a, m.b, m.motion_b, options, found, samples);
  return wrong.empty() ? wrong : wrong + told(found, options) + reproduction(m);
}

std::string wrongShifts(Random& random, Tally& tally) {
  const MovingCase m = onGrid(random);
  const LeastDistanceOptions options = anyOptions(random);
  const LeastDistance found = leastDistance(m.a, m.motion_a, m.b, m.motion_b, options);
  const double truth = exact::distanceBelow(leastSquared(m.a, m.motion_a, m.b, m.motion_b)) - options.margin;
  const double rounding = 1e-13 * (lengthOf(m.a, m.motion_a, m.b, m.motion_b) + options.margin);
  count(tally, found);
  const bool is_at_end = truth > 0 && (found.time == 0 || found.time == 1);
  tally.count("nearest at an end", is_at_end);
  tally.count("nearest between", truth > 0 && !is_at_end);
  if (!(found.distance >= truth - rounding && found.distance <= std::max(truth, 0.0) + options.error + rounding))
    return "not the exact one, " + hex(truth) + told(found, options) + reproduction(m);
  return wrongOfMotions(m, options, found, 20);
}

std::string wrongMotions(Random& random, Tally& tally) {
  const auto polygon = [&] {
    if (random.oneIn(8)) return random.coin() ? point({0, 0}) : segment({-1, 0}, {1, 0.5});
    return random.coin() ? Polygon({anyConvex(random, 1, 20)}) : Polygon({star(random, random.integer(4, 20), 0.3, 1)});
  };
  const Polygon a = polygon(), b = polygon();
  const MovingCase m{a, random.coin() ? Motion::still(randomPose(random, 1)) : randomMotion(random, a, 1), b,
                     randomMotion(random, b, 1.5)};
  const LeastDistanceOptions options = anyOptions(random);
  const LeastDistance found = leastDistance(m.a, m.motion_a, m.b, m.motion_b, options);
  count(tally, found);
  return wrongOfMotions(m, options, found, 300);
}

/// Bodies that may come later, leave sooner, or never be there together.
std::string wrongPlans(Random& random, Tally& tally) {
  const auto polygon = [&] {
    return random.oneIn(8) ? segment({-1, 0}, {1, 0.5}) : Polygon({star(random, random.integer(3, 20), 0.1, 0.4)});
  };
  const Polygon a = polygon(), b = polygon();
  const Trajectory of_a = anyPlan(random), of_b = anyPlan(random);
  LeastDistanceOptions options = anyOptions(random);
  if (options.margin > 0) options.margin = 0.1;
  options.absent_outside = std::max(of_a.begin(), of_b.begin()) <= std::min(of_a.end(), of_b.end()) && random.oneIn(3);
  const LeastDistance found = leastDistance(a, of_a, b, of_b, options);
  count(tally, found);
  tally.count("absent", options.absent_outside);
  const std::string wrong = wrongLeastDistance(a, of_a, b, of_b, options, found, 500);
  return wrong.empty() ? wrong
                       : wrong + told(found, options) + "absent outside " + std::to_string(options.absent_outside) +
                             "\n" + reproduction({a, of_a.at(of_a.begin()), b, of_b.at(of_b.begin())});
}

std::string wrongOfAny(Random& random, Tally& tally) {
  Limits limits;
  limits.most_exponent = 90;
  limits.most_vertices = 24;
  const Case c = anyCase(random, limits);
  const MovingCase m = anyFlight(random, c);
  LeastDistanceOptions options;
  options.error = smallerRadius(c) * std::pow(10, -random.real(1, 9));
  if (random.oneIn(3)) options.margin = smallerRadius(c) * random.unit();
  if (!(smallerRadius(c) > 1e-100 && lengthOf(m) < 1e100)) return {};
  const LeastDistance found = leastDistance(m.a, m.motion_a, m.b, m.motion_b, options);
  count(tally, found);
  return wrongOfMotions(m, options, found, 12);
}

Laws leastDistanceLaws() {
  return {
      {"shifts",
       1500,
       wrongShifts,
       {{"meet", 0.1, 0.75}, {"nearest at an end", 0.05, 0.7}, {"nearest between", 0.2, 0.85}, {"budget ended", 0, 0}}},
      {"motions", 1500, wrongMotions, {{"meet", 0.1, 0.9}, {"budget ended", 0, 0.01}}},
      {"plans", 600, wrongPlans, {{"meet", 0.1, 0.9}, {"absent", 0.1, 0.9}, {"budget ended", 0, 0.01}}},
      {"any_shapes", 500, wrongOfAny, {{"meet", 0.02, 0.98}}}};
}

const Register registered("least_distance", leastDistanceLaws);

}  // namespace
}  // namespace tricover::laws
