// SPDX-License-Identifier: BSD-3-Clause
#include "maps.h"

#include <cmath>

#include "random.h"
#include "tricover/polygon.h"

namespace tricover::bench {
namespace {

using support::Random;

constexpr double kTurn = 2 * static_cast<double>(EIGEN_PI);

Pose anyPose(const Eigen::AlignedBox2d& bounds, Random& random) {
  const double x = random.real(bounds.min().x(), bounds.max().x());
  const double y = random.real(bounds.min().y(), bounds.max().y());
  return poseAt({x, y}, random.real(0, kTurn));
}

/// Pose after pose at random until one is free.
class FreePoses {
 public:
  FreePoses(const Placement& map, const Polygon& robot, std::uint64_t seed)
      : scan_(map), bounds_(boundsOf(map)), robot_(robot), random_(seed) {}

  Pose next() {
    for (;;) {
      const Pose pose = anyPose(bounds_, random_);
      if (isFree(pose)) return pose;
    }
  }
  bool isFree(const Pose& pose) const { return !scan_.collides(robot_, pose); }
  Random& random() { return random_; }

 private:
  CoreScan scan_;
  Eigen::AlignedBox2d bounds_;
  const Polygon& robot_;
  Random random_;
};

}  // namespace

Placement countriesMap(const Countries& countries, std::size_t obstacles) {
  constexpr double kPitch = 100;
  Random random(21);
  const auto row = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(obstacles))));
  std::vector<Polygon> outlines;
  for (const auto& country : countries) {
    const Polygon centred = country.polygon.translated(-country.polygon.coveringOrigin());
    outlines.push_back(centred.scaled(random.real(20, 65) / centred.radius()));
  }
  Placement map;
  for (std::size_t i = 0; i < obstacles; ++i) {
    const Vec2 at(kPitch * static_cast<double>(i % row), kPitch * static_cast<double>(i / row));
    map.push_back({outlines[i % outlines.size()], poseAt(at, random.real(0, kTurn))});
  }
  return map;
}

Placement warehouseMap(std::size_t racks) {
  constexpr double kLength = 100, kDepth = 12, kAisle = 30;
  const Polygon rack = Polygon::box(kLength, kDepth);
  Random random(22);
  // Blocks are about as wide as they are high.
  const auto row = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(racks) / 4)));
  Placement map;
  for (std::size_t i = 0; i < racks; ++i) {
    const std::size_t column = i % row, line = i / row;
    // A cross aisle after every ten racks, an aisle after every second line.
    const double x = (kLength + 1) * static_cast<double>(column) + kAisle * static_cast<double>(column / 10);
    const double y = (kDepth + 1) * static_cast<double>(line) + kAisle * static_cast<double>(line / 2);
    map.push_back(
        {rack, poseAt(Vec2(x + random.real(-0.2, 0.2), y + random.real(-0.2, 0.2)), random.real(-2e-3, 2e-3))});
  }
  return map;
}

std::vector<NamedMap> allMaps(const Countries& countries) {
  constexpr std::size_t kObstacles = 10000;
  return {{"countries", countriesMap(countries, kObstacles)}, {"warehouse", warehouseMap(kObstacles)}};
}

Polygon forkLift() {
  Ring ring = {{-10, -5}, {-8, -6}, {2, -6}, {2, -4}, {14, -4}, {14, -2}};
  ring.insert(ring.end(), {{2, -2}, {2, 2}, {14, 2}, {14, 4}, {2, 6}, {-10, 5}});
  return Polygon({ring});
}

std::vector<Pose> randomPoses(const Placement& map, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  const auto bounds = boundsOf(map);
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < count; ++i) poses.push_back(anyPose(bounds, random));
  return poses;
}

std::vector<Pose> plannerPath(const Placement& map, const Polygon& robot, std::size_t count, std::uint64_t seed) {
  constexpr int kSteps = 100;
  FreePoses free(map, robot, seed);
  std::vector<Pose> poses;
  while (poses.size() < count) {
    const Pose from = free.next();
    const double heading = free.random().real(0, kTurn), turn = free.random().real(-1.5, 1.5);
    const Vec2 way = free.random().real(1, 3) * robot.radius() * Vec2(std::cos(heading), std::sin(heading));
    for (int step = 1; step <= kSteps && poses.size() < count; ++step) {
      const double part = static_cast<double>(step) / kSteps;
      Pose pose = from;
      pose.linear() = Eigen::Rotation2Dd(part * turn).toRotationMatrix() * from.linear();
      pose.translation() += part * way;
      poses.push_back(pose);
      if (!free.isFree(pose)) break;
    }
  }
  return poses;
}

std::vector<Ray> raysAround(const Placement& map, const Polygon& robot, std::size_t places, double length,
                            std::uint64_t seed) {
  FreePoses free(map, robot, seed);
  std::vector<Ray> rays;
  for (std::size_t place = 0; place < places; ++place) {
    const Pose pose = free.next();
    const Vec2 from = pose * robot.coveringOrigin();
    for (std::size_t i = 0; i < kRaysPerTurn; ++i) {
      const double angle = kTurn * static_cast<double>(i) / static_cast<double>(kRaysPerTurn);
      const Vec2 direction = pose.linear() * Vec2(std::cos(angle), std::sin(angle));
      rays.emplace_back(from, from + length * direction);
    }
  }
  return rays;
}

}  // namespace tricover::bench
