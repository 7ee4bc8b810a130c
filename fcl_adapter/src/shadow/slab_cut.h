// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "shape/heights.h"
#include "tricover/pose.h"

namespace tricover_fcl {

/// A point mapped from a geometry's frame into the polygon's is right to this share of its distances from both frames'
/// origins: a matrix inverse, a product and a mapping, less than 2^-49 each. Shadows are those of geometries grown by
/// as much, so that rounding never parts what meets.
constexpr double kMappingError = 0x1p-46;

/// Bound for all points within `reach` of the geometry's origin (the last term is for denormal numbers).
inline double mappingError(const Eigen::Affine3d& to_polygon, double reach) {
  return kMappingError * (to_polygon.translation().stableNorm() + reach) + 0x1p-1066;
}

/// The vertex in the polygon's frame. Throws std::invalid_argument, naming the geometry and the vertex, unless that is
/// finite: nothing after it expects NaN.
Eigen::Vector3d mapVertex(const Eigen::Affine3d& to_polygon, const Eigen::Vector3d& vertex, const char* geometry,
                          std::size_t index);

/// Gathers the corners of a convex polytope's part in the slab, seen along z.
class SlabCut {
 public:
  explicit SlabCut(const Slab& slab) : slab_(slab) {}

  void addVertex(const Eigen::Vector3d& p) {
    if (p.z() < slab_.low || p.z() > slab_.high) return;
    add(p.head<2>(), p.z());
  }

  /// Where the edge passes the slab's planes.
  void addEdge(const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    addCrossing(p, q, slab_.low);
    if (slab_.high > slab_.low) addCrossing(p, q, slab_.high);
  }

  /// Empty where the polytope doesn't reach the slab.
  const std::vector<tricover::Vec2>& corners() const { return corners_; }
  /// The heights of that part.
  const Slab& heights() const { return heights_; }

 private:
  void addCrossing(const Eigen::Vector3d& p, const Eigen::Vector3d& q, double z);
  void add(const tricover::Vec2& corner, double z) {
    corners_.push_back(corner);
    heights_ = {std::min(heights_.low, z), std::max(heights_.high, z)};
  }

  Slab slab_;
  std::vector<tricover::Vec2> corners_;
  Slab heights_ = kNoHeights;
};

/// The slab's part of the axis-parallel box from `low` to `high`, mapped into the polygon's frame; `geometry` names it
/// to mapVertex().
SlabCut cutBox(const Eigen::Vector3d& low, const Eigen::Vector3d& high, const char* geometry,
               const Eigen::Affine3d& to_polygon, const Slab& slab);

}  // namespace tricover_fcl
