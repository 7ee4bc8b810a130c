// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

#include "placed.h"
#include "random.h"
#include "rivals/boost.h"
#include "scene_studies.h"
#include "tricover/recording.h"
#include "tricover/scene.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

using support::Random;

/// Robots of about a metre, each on one cubic spline of some 20 m, as fleet planners schedule them.
struct Fleet {
  Polygon robot;
  std::vector<Motion> motions;
  Placement obstacles;
};

Fleet makeFleet(std::size_t robots, std::size_t obstacles) {
  Fleet fleet{Polygon({{{-0.6, -0.3}, {0.5, -0.3}, {0.6, -0.2}, {0.6, 0.2}, {0.5, 0.3}, {-0.6, 0.3}}}), {}, {}};
  Random random(31);
  const double side = 8 * std::sqrt(static_cast<double>(robots));
  const auto anywhere = [&] { return Vec2(random.real(0, side), random.real(0, side)); };
  const auto shift = [&](double most) { return Vec2(random.real(-most, most), random.real(-most, most)); };
  for (std::size_t i = 0; i < robots; ++i) {
    const Vec2 from = anywhere(), to = from + shift(15);
    const double turn = random.real(-3.15, 3.15);
    fleet.motions.push_back(Motion::spline({from, turn, shift(20), random.real(-3, 3)},
                                           {to, turn + random.real(-1.5, 1.5), shift(20), random.real(-3, 3)}));
  }
  for (std::size_t i = 0; i < obstacles; ++i) {
    const Polygon outline = workloads::makePolygon(workloads::Kind::Contour, 32, i % 20 + 1).scaled(0.02);
    fleet.obstacles.push_back({outline, poseAt(anywhere(), random.real(0, 6))});
  }
  return fleet;
}

/// The least and the largest of t s + t^2 s_2 + t^3 s_3 over t from 0 to 1.
std::pair<double, double> rangeOf(double s, double s2, double s3) {
  double low = std::min(0.0, s + s2 + s3), high = std::max(0.0, s + s2 + s3);
  const double root = std::sqrt(std::max(4 * s2 * s2 - 12 * s3 * s, 0.0));
  for (const double t : {(-2 * s2 + root) / (6 * s3), (-2 * s2 - root) / (6 * s3)}) {
    if (!(t > 0 && t < 1)) continue;
    const double value = t * (s + t * (s2 + t * s3));
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return {low, high};
}

/// Around the whole motion: the pivot's, which is the origin's, grown by the radius.
Eigen::AlignedBox2d sweptBox(const Motion& motion, double radius) {
  const auto [left, right] = rangeOf(motion.shift.x(), motion.shift_2.x(), motion.shift_3.x());
  const auto [down, up] = rangeOf(motion.shift.y(), motion.shift_2.y(), motion.shift_3.y());
  const Vec2 at = motion.start.translation();
  const double reach = (1 + 1e-9) * radius;
  return {at + Vec2(left - reach, down - reach), at + Vec2(right + reach, up + reach)};
}

std::vector<PairImpact> bySweptBoxes(const Fleet& fleet) {
  double radius = 0;
  for (const Vec2& v : fleet.robot.rings().front()) radius = std::max(radius, v.norm());
  std::vector<Eigen::AlignedBox2d> boxes;
  for (const Motion& motion : fleet.motions) boxes.push_back(sweptBox(motion, radius));
  for (const Placed& obstacle : fleet.obstacles) boxes.push_back(boundsOf(obstacle.polygon, obstacle.pose));
  std::vector<PairImpact> impacts;
  const std::size_t robots = fleet.motions.size();
  for (const auto& [i, j] : meetingBoxes(boxes, robots)) {
    const auto impact = j < robots ? timeOfImpact(fleet.robot, fleet.motions[i], fleet.robot, fleet.motions[j])
                                   : timeOfImpact(fleet.robot, fleet.motions[i], fleet.obstacles[j - robots].polygon,
                                                  Motion::still(fleet.obstacles[j - robots].pose));
    if (impact) impacts.push_back({{i, j}, *impact});
  }
  return impacts;
}

double longestDifference(const std::vector<PairImpact>& a, const std::vector<PairImpact>& b) {
  std::map<BodyPair, double> times;
  for (const PairImpact& impact : a) times[impact.pair] = impact.impact.time;
  double longest = a.size() == b.size() ? 0 : std::numeric_limits<double>::infinity();
  for (const PairImpact& impact : b) {
    const auto found = times.find(impact.pair);
    if (found == times.end()) return std::numeric_limits<double>::infinity();
    longest = std::max(longest, std::abs(found->second - impact.impact.time));
  }
  return longest;
}

/// Writes fleet.html: the robots that are timed, on their ways, and their conflicts.
void record(const std::string& directory, const Scene& scene, const std::vector<BodyMotion>& motions,
            const std::vector<PairImpact>& impacts) {
  std::vector<BodyTrajectory> ways;
  for (const BodyMotion& each : motions) ways.push_back({each.body, Trajectory({{0, 1, each.motion}})});
  SceneRecording recording("A fleet on splines");
  recording.trajectories(scene, ways);
  recording.impacts(impacts);
  recording.save(directory + "/fleet.html");
}

}  // namespace

std::vector<Result> measureFleet(const std::string& directory, bool full) {
  const std::size_t robots = full ? 1000 : 300, obstacles = robots / 5;
  const Fleet fleet = makeFleet(robots, obstacles);
  Scene scene;
  std::vector<BodyMotion> motions;
  for (const Motion& motion : fleet.motions) motions.push_back({scene.add(fleet.robot, motion.start), motion});
  for (const Placed& obstacle : fleet.obstacles) scene.add(obstacle.polygon, obstacle.pose);
  std::vector<PairImpact> ours, swept;
  Result result = measureInTurn({"fleet", std::to_string(robots) + " robots", "conflicts", 6, 32},
                                {{"scene", Role::Ours, [&] { ours = scene.impacts(motions); }},
                                 {"swept boxes", Role::Rival, [&] { swept = bySweptBoxes(fleet); }}},
                                5);
  // Both times may be early by the time_error.
  if (longestDifference(ours, swept) > 1e-6) throw std::logic_error("fleet: the two methods give different conflicts");
  result.collisions = swept.size();
  record(directory, scene, motions, ours);
  return {result};
}

}  // namespace tricover::bench
