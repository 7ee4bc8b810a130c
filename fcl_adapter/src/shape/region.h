// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "shape/heights.h"
#include "tricover/polygon.h"

namespace tricover_fcl {

/// The box around a posed polygon's vertices, as they are rounded.
inline Eigen::AlignedBox2d boundsOf(const tricover::Polygon& polygon,
                                    const tricover::Pose& pose = tricover::Pose::Identity()) {
  Eigen::AlignedBox2d box;
  for (tricover::EdgeIndex e = 0; e < polygon.edgeCount(); ++e) box.extend(pose * polygon.edgeStart(e));
  return box;
}

inline Eigen::AlignedBox2d grown(const Eigen::AlignedBox2d& box, double by) {
  return {box.min().array() - by, box.max().array() + by};
}

/// A geometry in a plane: all that is within `margin` of a posed polygon, between some heights.
struct Region {
  const tricover::Polygon* polygon;
  tricover::Pose pose;
  double margin;
  Heights heights;
};

inline Eigen::AlignedBox2d boxOf(const Region& region) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (region.polygon->isComplement())
    return {tricover::Vec2(-kInfinity, -kInfinity), tricover::Vec2(kInfinity, kInfinity)};
  return grown(boundsOf(*region.polygon, region.pose), std::max(region.margin, 0.0));
}

/// The region of another geometry than a polygon, how far it may be from the true one, and where it comes from.
struct Shadow {
  Shadow() = default;
  Shadow(const tricover::Polygon* known_, const tricover::Pose& pose_, double margin_)
      : known(known_), pose(pose_), margin(margin_) {}

  /// A polygon that is there already is not copied: threads that count a polygon's copies wait for each other.
  const tricover::Polygon& polygon() const { return made ? *made : *known; }
  /// How far what is taken for the region may be from the true one, a length.
  double outlineError() const { return rounding + excess; }

  const tricover::Polygon* known = nullptr;
  std::optional<tricover::Polygon> made;  ///< in place of `known`
  tricover::Pose pose = tricover::Pose::Identity();
  double margin = 0;
  Heights heights{};

  double rounding = 0;      ///< the true region lies in this one inflated by so much
  double excess = 0;        ///< of a round body's outline: the region is larger than the true one, by at most that
  bool is_surface = false;  ///< it has no inside to be in

  /// For each ring of a mesh or an octree what it is the shadow of, as FCL's queries number it, and its edges' number.
  struct Part {
    int id;
    std::size_t edges;
  };
  std::vector<Part> parts;
  /// The part that an edge is of, -1 for none.
  std::ptrdiff_t partOf(std::ptrdiff_t edge) const {
    auto beyond = static_cast<std::size_t>(edge);
    for (const Part& part : parts) {
      if (edge >= 0 && beyond < part.edges) return part.id;
      beyond -= part.edges;
    }
    return -1;
  }

  /// How to separate a polygon from a geometry that covers all of its plane: move the geometry along the unit normal
  /// (in space, polygon's frame) by `depth`.
  struct Lift {
    Eigen::Vector3d normal;
    double depth;
  };
  std::optional<Lift> lift;
};

}  // namespace tricover_fcl
