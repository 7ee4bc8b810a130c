// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "placed.h"
#include "workloads.h"

namespace tricover::bench {

/// Outlines that drive in circles and turn, each at speeds of its own.
struct Crowd {
  std::vector<Polygon> shapes;
  std::vector<std::vector<Pose>> poses;  ///< by frame, then object

  const Polygon& shapeOf(std::size_t object) const { return shapes[object % shapes.size()]; }
  std::size_t size() const { return poses.front().size(); }
  std::size_t frames() const { return poses.size(); }
};

/// Homes in rows, however many there are, so that all neighbours meet alike; with this much between them, orbits that
/// reach the neighbours: chosen so that about 5 % of the outlines collide. The density is the same for any number of
/// them.
constexpr std::size_t kCrowdRow = 50;
constexpr double kContourSpacing = 405;
constexpr double kConvexSpacing = 475;

/// Where they are in one frame.
std::vector<Pose> crowdPoses(double spacing, std::size_t objects, std::size_t frame);

Crowd makeCrowd(workloads::Kind kind, std::size_t vertices, double spacing, std::size_t objects, std::size_t frames);

}  // namespace tricover::bench
