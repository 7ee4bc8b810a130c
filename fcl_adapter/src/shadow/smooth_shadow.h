// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "shadow/slab_cut.h"
#include "tricover/distance.h"
#include "tricover/polygon.h"

namespace tricover_fcl {

/// The convex hull of two ellipsoids, axis-parallel and centred at -+half_height on the z axis: sphere, ellipsoid,
/// capsule, cone and cylinder are all of this kind.
struct SmoothBody {
  double half_height;
  Eigen::Vector3d bottom, top;  ///< radii; 0 for a point or a flat disc

  /// A point of the body that is farthest in `direction`.
  Eigen::Vector3d support(const Eigen::Vector3d& direction) const;

  /// Radius of a ball around the origin that holds the body.
  double reach() const { return half_height + bottom.cwiseMax(top).maxCoeff(); }
};

/// What of a smooth body lies in the slab, seen along z: a convex region C, known by its tangents. The part of C beyond
/// a chord between the points of two tangents lies in the cap: the triangle between chord and tangents. Queries split
/// the caps they depend on until these are less than kError of the body's reach high.
class SmoothShadow {
 public:
  static constexpr double kError = 1e-9;

  /// `to_polygon` maps the body's frame to the polygon's; `rounding` bounds the error of a point it maps.
  SmoothShadow(const SmoothBody& body, const Eigen::Affine3d& to_polygon, const Slab& slab, double rounding);

  /// Whether C and the polygon come as close as `margin`: never false where they do, but it may be true where they come
  /// as close as margin + kError.
  bool meets(const tricover::Polygon& polygon, double margin) const;

  /// Of the polygon (a) and C (b), at most kError above the truth.
  tricover::DistanceResult distance(const tricover::Polygon& polygon) const;

  /// A polygon within C, roughly.
  tricover::Polygon inscribed() const;

  /// How fine an outline is, as shares of the body's reach: `error`, but `elsewhere` where it doesn't meet `polygon`,
  /// if there is one.
  struct Fineness {
    double error;
    const tricover::Polygon* polygon = nullptr;
    double elsewhere = 0;
  };
  /// A polygon around C.
  tricover::Polygon outline(const Fineness& fineness) const;
  /// From now on all outlines touch C in that direction.
  void addTangent(const tricover::Vec2& normal);
  /// As a length, and not less than rounding allows.
  double outlineError(double error) const { return std::max(error * body_.reach(), finest_); }

 private:
  /// C lies within `height` + `slack` along the normal; `point` is one of C, at most `slack` short of that.
  struct Tangent {
    tricover::Vec2 normal, point;
    double slack;
  };
  struct Cap {
    Tangent first, second;
    tricover::Vec2 tip;
    double width, height, slack;
  };
  /// A split halves the angle between two tangents, so rounding alone can bring it here, where a cap counts as flat.
  static constexpr int kDeepest = 64;

  Eigen::Vector3d support(const Eigen::Vector3d& direction) const {
    return to_polygon_ * body_.support(to_polygon_.linear().transpose() * direction);
  }
  Tangent tangent(const tricover::Vec2& normal) const;
  static tricover::Vec2 chordNormal(const Cap& cap);
  static tricover::Polygon triangle(const tricover::Vec2& p, const tricover::Vec2& q, const tricover::Vec2& r) {
    return tricover::Polygon({{p, q, r}});
  }
  Cap cap(const Tangent& first, const Tangent& second) const;
  bool meets(const tricover::Polygon& polygon, double margin, const Cap& cap, int depth) const;
  void improve(tricover::DistanceResult& best, const tricover::Polygon& polygon, const Cap& cap, int depth) const;
  void addOutline(tricover::Ring& ring, const Cap& cap, const Fineness& fineness, int depth) const;

  SmoothBody body_;
  Eigen::Affine3d to_polygon_;
  Slab slab_;
  double rounding_, finest_;
  std::vector<Tangent> tangents_;  ///< all around, counter-clockwise
};

}  // namespace tricover_fcl
