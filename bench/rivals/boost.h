// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "scenes/placed.h"

/// boost::geometry, whose templates stay in one file.
namespace tricover::bench {

/// boost::geometry::intersects and distance (which compares all edges with all) on polygons (on multi polygons where a
/// region has several parts). It knows no prepared geometry, so that each query writes the coordinates of the polygon
/// with fewer vertices in the other one's frame.
class BoostGeometry {
 public:
  BoostGeometry(const Polygon& fixed, const Polygon& moving);

  void prepare(const std::vector<Pose>& poses);
  bool collide(std::size_t i);
  double value(std::size_t i);  ///< the distance

 private:
  struct Shapes;

  bool fixed_is_still_;
  std::shared_ptr<Shapes> shapes_;
  std::vector<Pose> poses_;  ///< of the moved polygon in the other one's frame
};

/// boost::geometry::index::rtree over the boxes of posed regions, built in one go, which packs it. Those whose boxes
/// meet the asking polygon's are asked by boost::geometry::intersects.
class BoostTree {
 public:
  BoostTree(const Placement& placement, const Polygon& moving);

  void prepare(std::vector<Pose> poses) { poses_ = std::move(poses); }

  /// Whether it meets any of them.
  bool collide(std::size_t i);

 private:
  struct Shapes;
  std::shared_ptr<Shapes> shapes_;
  std::vector<Pose> poses_;
};

/// The same over all edges: a ray takes the nearest of those that it crosses.
class BoostRays {
 public:
  BoostRays(const Placement& placement, std::vector<Ray> rays);

  /// The fraction of ray i; infinity where it hits nothing.
  double value(std::size_t i);

 private:
  struct Edges;
  std::shared_ptr<Edges> edges_;
  std::vector<Ray> rays_;
};

/// The pairs of boxes that meet, the lower index first, and of them those with the first index below `first`.
std::vector<std::pair<std::uint32_t, std::uint32_t>> meetingBoxes(const std::vector<Eigen::AlignedBox2d>& boxes,
                                                                  std::size_t first);

/// A tree likewise packed over the bodies' boxes, with our own collide() and distance().
class BoostMap {
 public:
  explicit BoostMap(Placement bodies);

  bool collides(const Polygon& polygon, const Pose& pose) const;
  double distance(const Polygon& polygon, const Pose& pose) const;

 private:
  struct Boxes;
  Placement bodies_;
  std::shared_ptr<Boxes> boxes_;
};

}  // namespace tricover::bench
