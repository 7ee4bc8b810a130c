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
  const tricover::Polygon hall = racks(), robot({rectangle(-0.4, -0.3, 0.8, 0.6)});
  const tricover::Trajectory rest({{0, 1, tricover::Motion::still(tricover::Pose::Identity())}});
  std::mt19937 random(7);
  std::vector<tricover::Trajectory> plans;
  for (int i = 0; i < kRobots; ++i) plans.push_back(plan(random));

  int spans = 0, in_racks = 0;
  const double robots_apart = 2 * kMargin;
  double first = 1e9;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    in_racks += !tricover::conflicts(robot, plans[i], hall, rest, {kMargin, 1e-3}).empty();
    for (std::size_t j = 0; j < i; ++j)
      for (const tricover::Conflict& span :
           tricover::conflicts(robot, plans[j], robot, plans[i], {robots_apart, 1e-3, /*ignore_initial*/ true})) {
        if (spans++ < 5)
          std::cout << "robots " << j << " and " << i << ": " << std::fixed << std::setprecision(1) << span.impact.time
                    << " s to " << span.end << " s\n";
        first = std::min(first, span.impact.time);
      }
  }
  std::cout << spans << " conflicts of robots, " << in_racks << " robots too near to a rack\n";

  tricover::SvgDrawing drawing;
  drawing.polygon(hall, tricover::Pose::Identity(), "#d6d3d1");
  for (const tricover::Trajectory& each : plans) drawing.polygon(robot, each.at(first), "#93c5fd", "#333", kMargin);
  savePicture(drawing, arguments[0]);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return runExample(argc, argv, "usage: warehouse [PICTURE]\n", "warehouse.svg", 1, run);
}
