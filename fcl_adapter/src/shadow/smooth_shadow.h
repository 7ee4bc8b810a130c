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
/// a chord between the points of two tangents lies in the cap: the triangle between chord and tangents. Tangents are
/// added where a query depends on them, until what it may be wrong by is less than kError of the body's reach.
class SmoothShadow {
 public:
  static constexpr double kError = 1e-9;

  /// `to_polygon` maps the body's frame to the polygon's; `rounding` bounds the error of a point it maps.
  SmoothShadow(const SmoothBody& body, const Eigen::Affine3d& to_polygon, const Slab& slab, double rounding);

  /// Whether C and the polygon come as close as `margin`: never false where they do, but it may be true where they come
  /// as close as margin + kError.
  bool meets(const tricover::Polygon& polygon, double margin) const;

  /// Of the polygon (a) and C (b), at most kError above the truth and never below it, less the margin: 0 exactly where
  /// meets() is true.
  tricover::DistanceResult distance(const tricover::Polygon& polygon, double margin) const;

  /// A polygon within C, roughly.
  tricover::Polygon inscribed() const;

  /// A polygon around C, which the tangents make.
  tricover::Polygon outline() const { return around(tangents()); }
  /// About the normal of C near a point of that edge of outline().
  tricover::Vec2 normalNear(std::ptrdiff_t edge, const tricover::Vec2& point) const;
  /// Adds tangents until outlines are as fine as `error` where C has that normal; false if they were.
  bool sharpen(const tricover::Vec2& normal, double error);
  /// Adds tangents at both ends of that edge of outline(), or everywhere if it is -1, where that isn't as fine as
  /// `error`; false if it is.
  bool refine(std::ptrdiff_t edge, double error);
  /// As a length, and not less than rounding allows.
  double outlineError(double error) const { return std::max(error * body_.reach(), finest_); }

 private:
  /// C lies within `height` + `slack` along the normal; `point` is one of C, at most `slack` short of that.
  struct Tangent {
    tricover::Vec2 normal, point;
    double slack;
  };
  using Tangents = std::vector<Tangent>;  ///< all around, counter-clockwise, none 180 degrees from the next
  struct Cap {
    Tangent first, second;
    tricover::Vec2 tip;
    double width, height;
  };

  Eigen::Vector3d support(const Eigen::Vector3d& direction) const {
    return to_polygon_ * body_.support(to_polygon_.linear().transpose() * direction);
  }
  /// The slack is less than `enough`, or as rounding leaves it.
  Tangent tangent(const tricover::Vec2& normal, double enough = 0) const;
  static tricover::Vec2 chordNormal(const Cap& cap);
  Cap cap(const Tangent& first, const Tangent& second) const;
  tricover::Polygon around(const Tangents& tangents) const;
  static tricover::Polygon within(const Tangents& tangents);
  /// Whether there was none with that normal.
  static bool insert(Tangents& tangents, const Tangent& tangent);
  bool isFine(const Cap& cap, double error) const { return cap.width <= finest_ || cap.height <= outlineError(error); }
  /// Halves all caps that are higher than `height`; false if there are none.
  bool refineAll(Tangents& tangents, double height, double enough = 0) const;
  /// Of outlines; queries don't need them.
  Tangents tangents() const;

  struct Nearest {
    tricover::Vec2 point;
    std::size_t chord;
  };
  static Nearest nearestWithin(const Tangents& tangents, const tricover::Vec2& p);
  static bool goRound(const Tangents& tangents, const tricover::Vec2& p);
  tricover::Vec2 closeIn(Tangents& tangents, const tricover::Vec2& p, double enough) const;
  struct Approach;
  Approach approach(const tricover::Polygon& polygon, double margin, bool only_whether) const;

  SmoothBody body_;
  Eigen::Affine3d to_polygon_;
  Slab slab_;
  double rounding_, finest_;
  Tangents tangents_;  ///< of outlines, once some were added
};

}  // namespace tricover_fcl
