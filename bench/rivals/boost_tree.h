// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "scenes/placed.h"

namespace tricover::bench {

/// boost::geometry::index::rtree over the boxes of posed regions, built in one go, which packs it. Those whose boxes
/// meet the asking polygon's are asked by boost::geometry::intersects.
class BoostTree {
 public:
  BoostTree(const Placement& placement, const Polygon& moving);
  ~BoostTree();

  void prepare(std::vector<Pose> poses);

  /// Whether it meets any of them.
  bool collide(std::size_t i);

 private:
  struct Shapes;
  std::unique_ptr<Shapes> shapes_;  ///< keeps Boost's templates in one file
  std::vector<Pose> poses_;
};

/// The same over all edges: a ray takes the nearest of those that it crosses.
class BoostRays {
 public:
  BoostRays(const Placement& placement, std::vector<Ray> rays);
  ~BoostRays();

  /// The fraction of ray i; infinity where it hits nothing.
  double value(std::size_t i);

 private:
  struct Edges;
  std::unique_ptr<Edges> edges_;
  std::vector<Ray> rays_;
};

/// The pairs of boxes that meet, the lower index first, and of them those with the first index below `first`.
std::vector<std::pair<std::uint32_t, std::uint32_t>> meetingBoxes(const std::vector<Eigen::AlignedBox2d>& boxes,
                                                                  std::size_t first);

}  // namespace tricover::bench
