// SPDX-License-Identifier: BSD-3-Clause
#include "least_distance_laws.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "exact_reference.h"
#include "reproduction.h"
#include "tricover/distance.h"
#include "tricover/segment.h"
#include "tricover/time_of_impact.h"

namespace tricover::support {
namespace {

double lengthOf(const Polygon& polygon, const Motion& m) {
  const double reach = polygon.radius() + (polygon.origin() - m.pivot).stableNorm();
  return m.shift.stableNorm() + m.shift_2.stableNorm() + m.shift_3.stableNorm() + m.pivot.stableNorm() +
         (1 + std::abs(m.angle) + std::abs(m.angle_2) + std::abs(m.angle_3)) * reach;
}

/// Of the paths of b's vertices, seen from a.
void lower(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, const Vec2& by,
           mpq_class& least) {
  for (const Ring& ring : b.rings())
    for (const Vec2& vertex : ring) {
      const Vec2 at = pose_b * vertex;
      const mpq_class squared = exact::distanceSquared(a, pose_a, segment(at, at + by), Pose::Identity());
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
  if (!found.budget_ended && !(found.distance - found.lower_bound <= options.error + 2 * rounding))
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
  same.absent_outside = options.absent_outside;
  const auto impact = timeOfImpact(a, path_a, b, path_b, same);
  if (!impact && found.distance == 0) return "least: nothing, and no impact";
  if (impact && !impact->budget_ended && found.distance > rounding) return "least: an impact";
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

}  // namespace

double lengthOf(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b) {
  return (motion_a.start.translation() - motion_b.start.translation()).stableNorm() + lengthOf(a, motion_a) +
         lengthOf(b, motion_b);
}

mpq_class leastSquared(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b) {
  const Vec2 by = motion_b.shift - motion_a.shift;
  mpq_class least = -1;
  lower(a, motion_a.start, b, motion_b.start, by, least);
  lower(b, motion_b.start, a, motion_a.start, -by, least);
  return least;
}

std::string wrongLeastDistance(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b,
                               const LeastDistanceOptions& options, const LeastDistance& found, int samples) {
  const double far = motion_a.start.translation().stableNorm() + motion_b.start.translation().stableNorm();
  return wrongOn(a, motion_a, b, motion_b, 0, 1, lengthOf(a, motion_a, b, motion_b), far, options, found, samples);
}

std::string wrongLeastDistance(const Polygon& a, const Trajectory& trajectory_a, const Polygon& b,
                               const Trajectory& trajectory_b, const LeastDistanceOptions& options,
                               const LeastDistance& found, int samples) {
  const bool together = options.absent_outside;
  const auto begins = std::minmax({trajectory_a.begin(), trajectory_b.begin()}),
             ends = std::minmax({trajectory_a.end(), trajectory_b.end()});
  const auto [far_a, length_a] = sizesOf(a, trajectory_a);
  const auto [far_b, length_b] = sizesOf(b, trajectory_b);
  return wrongOn(a, trajectory_a, b, trajectory_b, together ? begins.second : begins.first,
                 together ? ends.first : ends.second, far_a + far_b + length_a + length_b, far_a + far_b, options,
                 found, samples);
}

}  // namespace tricover::support
