// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tricover/collide.h"
#include "tricover/export.h"
#include "tricover/polygon.h"

namespace tricover {
namespace detail {
struct CacheAccess;
}  // namespace detail

/// The covering, the influence areas and Algorithm 3 of *Efficient Collision Detection between 2D Polygons* (Jimenez,
/// Segura and Feito, 2004), for readers of the paper. Other programs do not need this header.
namespace paper {

/// A triangle (S, v, w) of a polygon's covering (Definition 3). (v, w) is an edge.
struct CoveringTriangle {
  Vec2 s;    ///< S, the covering's origin.
  Vec2 v;    ///< Where the edge starts.
  Vec2 w;    ///< Where the edge ends.
  int sign;  ///< The sign of the triangle's area: 1 or -1, and 0 where the edge's line goes through S.
};

/// The covering: one triangle an edge, in the edges' order, from S, which is Polygon::coveringOrigin(). O(n), made anew
/// at each call.
///
/// \snippet paper.cpp covering
TRICOVER_EXPORT std::vector<CoveringTriangle> covering(const Polygon& polygon);

/// The influence areas of an edge for a length n >= 0, from Sections 4 and 5.
enum class InfluenceKind {
  OneSided,  ///< Figure 3: from the edge's line to its parallel at distance n on the outer side, unbounded along it.
  Extended,  ///< Figure 4: within n of the edge's line, on both sides, unbounded along it.
  Bounded,   ///< Figure 9b: Extended, cut by two axis-parallel lines at distance n beyond the vertices.
};

/// Whether `point`, in the polygon's frame, lies in the influence area of `edge` for the given length.
///
/// Extended and Bounded are rounded outwards: they hold every point within n of the edge, so that a point outside of
/// them is proven to be farther away than n. The kernel decides by these two only.
///
/// The outer side of OneSided is that away from S where the edge's covering triangle is positive, and S's own where it
/// is negative. (The paper's text is wrong in concavities and holes.) It is meant for rings that run with the region on
/// their left.
///
/// \throws std::invalid_argument for a length that is negative or NaN, for a point that is not finite, and for a value
/// that InfluenceKind doesn't have
/// \throws std::out_of_range for an edge that isn't there
///
/// \snippet paper.cpp influence
TRICOVER_EXPORT bool inInfluenceArea(const Polygon& polygon, EdgeIndex edge, const Vec2& point, double length,
                                     InfluenceKind kind);

/// One bit an edge: whether the point, in the polygon's frame, is in that edge's bounded area. Edge i has bit i % 64 of
/// word i / 64. If no bit is set, no edge comes within that length of the point.
///
/// \throws std::invalid_argument for a length that is negative or NaN and for a point that is not finite
///
/// \snippet paper.cpp influence mask
TRICOVER_EXPORT std::vector<std::uint64_t> influenceMask(const Polygon& polygon, const Vec2& point, double length);

/// The corners of an edge's bounded area, in order, rounded: for drawings.
///
/// \throws std::invalid_argument for a length that is negative or NaN
/// \throws std::out_of_range for an edge that isn't there
///
/// \snippet paper.cpp bounded influence area
TRICOVER_EXPORT std::array<Vec2, 4> boundedInfluenceArea(const Polygon& polygon, EdgeIndex edge, double length);

/// Remembers a pair of polygons for Algorithm 3: on which side of every edge the moving centroid was when it was last
/// outside every influence area and the regions were apart. The rules are those of a PairCache.
///
/// \snippet paper.cpp collide
class MaskCache {
 private:
  friend struct detail::CacheAccess;
  std::vector<std::uint64_t> masks_;
};

/// tricover::collide() by Algorithm 3, with the repairs that it needs. The same answers, from the same predicates and
/// the same edge test, in O(n m).
///
/// \throws std::invalid_argument for a pose that checkPose() refuses, for a margin or a tolerance that is negative or
/// not finite, and for a value that Touching doesn't have
///
/// \snippet paper.cpp collide
TRICOVER_EXPORT bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                             const CollideOptions& options = {});

/// The same answer, using and renewing the mask in `cache`. O(n) while the mask stays as it is.
///
/// \snippet paper.cpp collide
TRICOVER_EXPORT bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                             MaskCache& cache, const CollideOptions& options = {});

}  // namespace paper
}  // namespace tricover
