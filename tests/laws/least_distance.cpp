// SPDX-License-Identifier: BSD-3-Clause
// leastDistance() of motions that are only shifted against exact rationals, of others beside distances at many times.
#include "tricover/least_distance.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "conflict_laws.h"
#include "exact_reference.h"
#include "law.h"
#include "pairs.h"
#include "reproduction.h"
#include "shapes.h"
#include "tricover/distance.h"
#include "tricover/polygon.h"
#include "tricover/time_of_impact.h"

namespace tricover::laws {
namespace {

using namespace support;

/// Of the paths of b's vertices, seen from a.
void lower(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, const Vec2& by,
           mpq_class& least) {
  for (const Ring& ring : b.rings())
    for (const Vec2& vertex : ring) {
      const Vec2 at = pose_b * vertex;
      const mpq_class squared = exact::distanceSquared(a, pose_a, Polygon::segment(at, at + by), Pose::Identity());
      if (sgn(least) < 0 || squared < least) least = squared;
    }
}

/// `length` is L without the margin; times are from `begin` to `end`.
template <typename Path>
std::string wrongOn(const Polygon& a, const Path& path_a, const Polygon& b, const Path& path_b, double begin,
                    double end, double length, double far, const LeastDistanceOptions& options,
                    const LeastDistance& found, int samples) {
  const auto at = [&](double time) { return distance(a, path_a.at(time), b, path_b.at(time)); };
  const double rounding = 1.1e-13 * (length + options.margin) + 1e-15 * far;
  if (!(begin <= found.time && found.time <= end)) return "least: time";
  if (!(0 <= found.lower_bound && found.lower_bound <= found.distance)) return "least: bounds";
  if (!found.budget_ended && !(found.distance - found.lower_bound <= options.absolute_error + 2 * rounding))
    return "least: farther apart than the error allows";
  const DistanceResult there = at(found.time);
  const double left = there.distance - options.margin;
  if (found.distance == 0 ? !(left <= rounding) : found.distance != left) return "least: not the distance there";
  if (found.point_a != there.point_a || found.point_b != there.point_b || found.edge_a != there.edge_a ||
      found.edge_b != there.edge_b)
    return "least: not the points there";
  // Where it says least, too, more closely.
  for (int i = -32; i <= samples; ++i) {
    const double aside = (end - begin) * std::pow(10, -0.5 * ((i + 32) / 2)) * (i % 2 == 0 ? 1 : -1);
    const double time = i < 0          ? std::clamp(found.time + aside, begin, end)
                        : i == samples ? end
                                       : begin + (end - begin) * i / samples;
    const double sample = std::max(at(time).distance - options.margin, 0.0);
    if (sample < found.lower_bound - rounding) return "least: nearer at " + hex(time);
  }
  ImpactOptions same;
  same.margin = options.margin;
  same.time_error = 0;
  const auto impact = timeOfImpact(a, path_a, b, path_b, same);
  // Poses are rounded, motions aren't.
  same.margin += rounding;
  if (!impact && found.distance == 0 && !timeOfImpact(a, path_a, b, path_b, same))
    return "least: nothing, and no impact";
  if (impact && !impact->budget_ended && found.distance != 0) return "least: an impact";
  return {};
}

/// The farthest that a leg begins from the origin, and the most of its L.
std::pair<double, double> sizesOf(const Polygon& polygon, const Trajectory& trajectory) {
  double far = 0, length = 0;
  for (const Leg& leg : trajectory.legs()) {
    far = std::max(far, leg.motion.start.translation().stableNorm());
    length = std::max(length, lengthOf(polygon, leg.motion));
  }
  return {far, length};
}

/// The square of the least distance of polygons that are only shifted: a vertex's path is a segment, and the distance
/// is least where a vertex of one is nearest to the other. Exact where sums of poses, vertices and shifts are.
mpq_class leastSquared(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b) {
  const Vec2 by = motion_b.shift - motion_a.shift;
  mpq_class least = -1;
  lower(a, motion_a.start, b, motion_b.start, by, least);
  lower(b, motion_b.start, a, motion_a.start, -by, least);
  return least;
}

/// What is wrong with the result beside so many samples and the time of impact.
std::string wrongLeastDistance(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b,
                               const LeastDistanceOptions& options, const LeastDistance& found, int samples) {
  const double far = motion_a.start.translation().stableNorm() + motion_b.start.translation().stableNorm();
  return wrongOn(a, motion_a, b, motion_b, 0, 1, lengthOf({a, motion_a, b, motion_b}), far, options, found, samples);
}

std::string wrongLeastDistance(const Polygon& a, const Trajectory& trajectory_a, const Polygon& b,
                               const Trajectory& trajectory_b, const LeastDistanceOptions& options,
                               const LeastDistance& found, int samples) {
  const bool together = trajectory_a.vanishes();
  const auto begins = std::minmax({trajectory_a.begin(), trajectory_b.begin()}),
             ends = std::minmax({trajectory_a.end(), trajectory_b.end()});
  const auto [far_a, length_a] = sizesOf(a, trajectory_a);
  const auto [far_b, length_b] = sizesOf(b, trajectory_b);
  return wrongOn(a, trajectory_a, b, trajectory_b, together ? begins.second : begins.first,
                 together ? ends.first : ends.second, far_a + far_b + length_a + length_b, far_a + far_b, options,
                 found, samples);
}

LeastDistanceOptions anyOptions(Random& random) {
  LeastDistanceOptions options;
  options.absolute_error = std::pow(10, -random.integer(2, 11));
  if (random.oneIn(3)) options.margin = 0.25 * random.integer(1, 12);
  return options;
}

/// Vertices, starts and shifts on a grid: sums are exact.
MovingCase onGrid(Random& random) {
  const auto polygon = [&] {
    if (random.oneIn(6)) return Polygon::point({0, 0});
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
          Motion::translation(tricover::poseAt(from.x(), from.y()), by + of_a)};
}

std::string told(const LeastDistance& found, const LeastDistanceOptions& options) {
  return ", found " + hex(found.distance) + ", error " + hex(options.absolute_error) + ", margin " +
         hex(options.margin) + "\n";
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
  const double rounding = 1e-13 * (lengthOf(m) + options.margin);
  count(tally, found);
  const bool is_at_end = truth > 0 && (found.time == 0 || found.time == 1);
  tally.count("nearest at an end", is_at_end);
  tally.count("nearest between", truth > 0 && !is_at_end);
  if (!(found.distance >= truth - rounding &&
        found.distance <= std::max(truth, 0.0) + options.absolute_error + rounding))
    return "not the exact one, " + hex(truth) + told(found, options) + reproduction(m);
  return wrongOfMotions(m, options, found, 20);
}

std::string wrongMotions(Random& random, Tally& tally) {
  const auto polygon = [&] {
    if (random.oneIn(8)) return random.coin() ? Polygon::point({0, 0}) : Polygon::segment({-1, 0}, {1, 0.5});
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
    return random.oneIn(8) ? Polygon::segment({-1, 0}, {1, 0.5})
                           : Polygon({star(random, random.integer(3, 20), 0.1, 0.4)});
  };
  const Polygon a = polygon(), b = polygon();
  Trajectory of_a = anyPlan(random), of_b = anyPlan(random);
  LeastDistanceOptions options = anyOptions(random);
  if (options.margin > 0) options.margin = 0.1;
  const bool absent = std::max(of_a.begin(), of_b.begin()) <= std::min(of_a.end(), of_b.end()) && random.oneIn(3);
  if (absent) of_a = of_a.appearing().vanishing(), of_b = of_b.appearing().vanishing();
  const LeastDistance found = leastDistance(a, of_a, b, of_b, options);
  count(tally, found);
  tally.count("absent", absent);
  const std::string wrong = wrongLeastDistance(a, of_a, b, of_b, options, found, 500);
  return wrong.empty() ? wrong
                       : wrong + told(found, options) + "absent outside " + std::to_string(absent) + "\n" +
                             reproduction({a, of_a.at(of_a.begin()), b, of_b.at(of_b.begin())});
}

std::string wrongOfAny(Random& random, Tally& tally) {
  Limits limits;
  limits.most_exponent = 90;
  limits.most_vertices = 24;
  const Case c = anyCase(random, limits);
  const MovingCase m = anyFlight(random, c);
  LeastDistanceOptions options;
  options.absolute_error = smallerRadius(c) * std::pow(10, -random.real(1, 9));
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
