// SPDX-License-Identifier: BSD-3-Clause
// A warehouse: robots drive from station to station among racks, each by times of its own, wait, and turn. Who is in
// conflict with whom or with a rack, from when to when? Core alone. Draws the hall at the first conflict.
#include <tricover/tricover.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "picture.h"

namespace {

constexpr double kMargin = 0.1;  // metres that robots keep around them
constexpr int kRobots = 50;

tricover::Ring rectangle(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

tricover::Pose at(double x, double y, double heading) {
  return Eigen::Translation2d(x, y) * Eigen::Rotation2Dd(heading);
}

/// Racks of 8 m x 1.5 m, with aisles of 2 m along x and crossings of 3 m along y.
tricover::Polygon racks() {
  std::vector<tricover::Ring> rings;
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 4; ++column) rings.push_back(rectangle(11 * column, 3.5 * row, 8, 1.5));
  return tricover::Polygon(rings);
}

/// Along an aisle, a wait, a turn on the spot at a crossing, and along that; seconds and metres.
tricover::Trajectory plan(std::mt19937& random) {
  const auto any = [&](int most) { return static_cast<double>(random() % static_cast<unsigned>(most)); };
  const double aisle = 3.5 * any(5) + 2.5, crossing = 11 * any(3) + 9.5, start = 11 * any(3) + 0.5 + any(7);
  const double to_crossing = std::abs(crossing - start), heading = crossing > start ? 0 : M_PI,
               goal = 3.5 * any(5) + 2.5;
  const double turned = heading + (goal < aisle) * (heading > 0 ? M_PI / 2 : -M_PI / 2) +
                        (goal >= aisle) * (heading > 0 ? -M_PI / 2 : M_PI / 2);
  double time = any(20);
  std::vector<tricover::TimedPose> poses = {{time, at(start, aisle, heading)}};
  poses.push_back({time += to_crossing, at(crossing, aisle, heading)});  // a metre a second
  poses.push_back({time += 1 + any(9), at(crossing, aisle, heading)});   // waits
  poses.push_back({time += 2, at(crossing, aisle, turned)});             // turns
  poses.push_back({time += 1 + std::abs(goal - aisle), at(crossing, goal, turned)});
  return tricover::Trajectory::through(poses);
}

int run(const std::vector<std::string>& arguments) {
  const tricover::Polygon robot({rectangle(-0.4, -0.3, 0.8, 0.6)});
  tricover::Scene scene;
  const auto hall = scene.add(racks(), tricover::Pose::Identity());
  tricover::BodyOptions options;
  options.margin = kMargin;
  std::mt19937 random(7);
  std::vector<tricover::BodyTrajectory> plans;
  for (int i = 0; i < kRobots; ++i) {
    const tricover::Trajectory each = plan(random);
    plans.push_back({scene.add(robot, each.at(0), options), each});
  }

  // Two that begin side by side have time to part.
  const auto conflicts = scene.conflicts(plans, {0, 1e-3, /*ignore_initial*/ true});
  int in_racks = 0, told = 0;
  for (const auto& [pair, span] : conflicts) {
    in_racks += pair.first == hall;
    if (told++ < 5)
      std::cout << "robots " << pair.first << " and " << pair.second << ": " << std::fixed << std::setprecision(1)
                << span.impact.time << " s to " << span.end << " s\n";
  }
  std::cout << conflicts.size() << " conflicts, " << in_racks << " of them with a rack\n";

  tricover::SvgDrawing drawing;
  const double first = conflicts.at(0).conflict.impact.time;
  for (const tricover::BodyTrajectory& plan : plans) scene.move(plan.body, plan.trajectory.at(first));
  drawing.scene(scene, "#93c5fd");
  drawing.polygon(scene.polygon(hall), scene.pose(hall), "#d6d3d1");
  savePicture(drawing, arguments[0]);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return runExample(argc, argv, "usage: warehouse [PICTURE]\n", "warehouse.svg", 1, run);
}
