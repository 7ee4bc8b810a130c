// SPDX-License-Identifier: BSD-3-Clause
#include "crowd.h"

#include <cmath>
#include <utility>

namespace tricover::bench {
namespace {

constexpr std::size_t kShapes = 50;
constexpr double kOrbit = 480;

/// Irrational steps spread phases and speeds without a random generator.
double spread(std::size_t i, double step) { return std::fmod(static_cast<double>(i) * step, 1); }

}  // namespace

std::vector<Pose> crowdPoses(double spacing, std::size_t objects, std::size_t frame) {
  const double turn = 2 * static_cast<double>(EIGEN_PI);
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < objects; ++i) {
    const double speed = 0.5 + spread(i, 0.7548776662466927);
    const double angle = turn * (spread(i, 0.6180339887498949) + speed * static_cast<double>(frame) / 1000);
    const Vec2 home(spacing * static_cast<double>(i % kCrowdRow), spacing * static_cast<double>(i / kCrowdRow));
    poses.push_back(poseAt(home + kOrbit * Vec2(std::cos(angle), std::sin(angle)), angle * (i % 2 != 0 ? 1.7 : -1.3)));
  }
  return poses;
}

Crowd makeCrowd(workloads::Kind kind, std::size_t vertices, double spacing, std::size_t objects, std::size_t frames) {
  Crowd crowd;
  for (std::size_t i = 0; i < kShapes; ++i) crowd.shapes.push_back(workloads::makePolygon(kind, vertices, i + 1));
  for (std::size_t frame = 0; frame < frames; ++frame) crowd.poses.push_back(crowdPoses(spacing, objects, frame));
  return crowd;
}

}  // namespace tricover::bench
