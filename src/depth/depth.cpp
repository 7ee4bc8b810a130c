// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/depth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "depth/border.h"
#include "depth/deepest_point.h"
#include "depth/depth_in_order.h"
#include "depth/excess.h"
#include "depth/posed_side.h"
#include "numbers/rigidity.h"
#include "overlay/interiors.h"
#include "pair/discs.h"
#include "pair/kernel_order.h"
#include "pair/posed_pair.h"
#include "penetration/separating_axes.h"
#include "polygon/convexity.h"
#include "tricover/collide.h"
#include "tricover/covers.h"

namespace tricover {
namespace detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Above what lengths lose near the least double.
constexpr double kLeast = 0x1p-1060;

Depth noDepth() { return {0, Vec2::UnitX(), Vec2::Zero(), Vec2::Zero(), -1, -1, false, 0}; }

/// Of convex regions no point is deeper than the shortest translation is long. So that is the depth, where the corner
/// behind the least face has no other edge nearer. A depth that is larger than `beside` may be any corner's.
std::optional<Depth> depthOfConvex(const PosedPair& pair, double beside, double* precision) {
  if (cornersOf(pair.a) == nullptr || cornersOf(pair.b) == nullptr) return std::nullopt;
  const SeparatingAxes axes(pair);
  if (axes.verdict() != SeparatingAxes::Meet) return std::nullopt;
  const double tie = axes.tie() + kLeast;
  *precision = tie;
  if (axes.leastDepth() + tie < beside && beside < kInfinity) {
    Depth less = noDepth();
    less.upper_bound = axes.leastDepth();
    return less;
  }
  const WorldFrame frame(pair);
  for (const FaceDepth& face : axes) {
    const int own = face.of_a ? 0 : 1;
    const AxisSide& other = axes.side(!face.of_a);
    const PosedSide region(pair, frame, own);
    // Corners beside it may be as deep.
    const auto& ring = other.ring.ring;
    for (const std::uint32_t k : {face.deepest, ring.next(face.deepest), ring.previous(face.deepest)}) {
      const EdgePosition corner = other.outline.corners[k];
      const Vec2 point = frame.from(1 - own, other.polygon.path[corner]);
      const PosedSide::Near near = region.nearest(point);
      const double depth = near.distance * frame.unit();
      const bool is_wanted = depth >= face.depth - tie || depth - tie > beside;
      if (!(depth > tie && is_wanted) || region.locate(point) == Location::Outside) continue;
      const Vec2 at = frame.toWorld(point), nearest = frame.toWorld(near.point);
      const Vec2 way = (near.point - point) / near.distance;
      const EdgeIndex own_edge = region.polygon.edgeName(near.edge), other_edge = other.polygon.edgeName(corner);
      const double most = std::max(depth, face.depth);
      return face.of_a ? Depth{depth, way, nearest, at, own_edge, other_edge, false, most}
                       : Depth{depth, -way, at, nearest, other_edge, own_edge, true, most};
    }
  }
  return std::nullopt;
}

/// Whose depths are above `enough` or not above `least` needs no better answer.
Depth depthBetween(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b, double least,
                   double enough, double* precision) {
  Depth result = noDepth();
  DeepestPoint of_b, of_a;
  const PolygonData *const in_a = withBordersOnly(a), *const in_b = withBordersOnly(b);
  std::optional<Overlap> overlap;
  if (in_a != nullptr) {
    overlap.emplace(b, pose_b, Overlap::Area{*in_a, pose_a, true});
    of_b = findDeepestPoint(*overlap, false, least, enough);
  }
  if (in_b != nullptr && !(of_b.distance > enough)) {
    const bool are_given = in_a == &a && in_b == &b;
    if (!are_given) overlap.emplace(a, pose_a, Overlap::Area{*in_b, pose_b, true});
    of_a = findDeepestPoint(*overlap, are_given, std::max(least, of_b.distance), enough);
  }
  if (overlap) *precision = overlap->precision() * overlap->frame.unit();
  result.is_point_of_a = of_a.distance > of_b.distance;
  const DeepestPoint& deepest = result.is_point_of_a ? of_a : of_b;
  result.depth = deepest.distance;
  result.upper_bound = std::max({of_a.upper_bound, of_b.upper_bound, result.depth});
  // Points that rounding makes one have no direction.
  if (deepest.point != deepest.nearest) {
    result.point_a = result.is_point_of_a ? deepest.point : deepest.nearest;
    result.point_b = result.is_point_of_a ? deepest.nearest : deepest.point;
    result.normal = result.is_point_of_a ? Vec2(-deepest.way) : deepest.way;
    const auto nearest = [&](const PolygonData& polygon, const PolygonData& region) {
      return polygon.edgeName(givenEdge(polygon, region, deepest.nearest_edge));
    };
    result.edge_a = result.is_point_of_a ? a.edgeName(deepest.edge) : nearest(a, *in_a);
    result.edge_b = result.is_point_of_a ? nearest(b, *in_b) : b.edgeName(deepest.edge);
  }
  return result;
}

}  // namespace

Depth depthInOrder(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                   const DepthWish& wish) {
  if (a.fill.is_complement && b.fill.is_complement)
    return {kInfinity, Vec2::UnitX(), Vec2::Zero(), Vec2::Zero(), -1, -1, false, kInfinity};
  double precision = 0;
  const auto known = [&](const Depth& found) {
    // Rounding must not hide whether a point of one is inside of the other.
    if (found.upper_bound > 64 * precision) return found;
    const bool is_deep = interiorsMeet(a, pose_a, b, pose_b);
    if (is_deep && found.depth > 0) return found;
    const double least = is_deep ? std::numeric_limits<double>::denorm_min() : 0;
    return Depth{least, found.normal, Vec2::Zero(), Vec2::Zero(), -1, -1, false, least};
  };
  if (const std::optional<Depth> found = depthOfConvex(PosedPair(a, pose_a, b, pose_b), wish.beside, &precision))
    return known(*found);
  // Bounds that are farther apart than the precision of all searches decide.
  const double room =
      0x1p-44 * (a.extent + b.extent + (pose_a.translation() - pose_b.translation()).lpNorm<1>()) + kLeast;
  const double least = wish.beside - room, enough = wish.beside + room;
  if (wish.beside < kInfinity && least > 0) {
    Depth found = depthBetween(a, pose_a, b, pose_b, least, enough, &precision);
    if (found.depth > enough) return found;
    if (found.upper_bound <= least) {
      found.upper_bound = std::min(least, std::nextafter(wish.beside, 0.0));
      return found;
    }
  }
  return known(depthBetween(a, pose_a, b, pose_b, 0, kInfinity, &precision));
}

}  // namespace detail

Depth depth(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  const bool meet = collide(a, pose_a, b, pose_b);
  return detail::inKernelOrder(
      detail::dataOf(a), pose_a, detail::dataOf(b), pose_b,
      [&](const auto&... operands) { return meet ? detail::depthInOrder(operands..., {}) : detail::noDepth(); },
      [](Depth& depth) {
        depth.normal = -depth.normal;
        std::swap(depth.point_a, depth.point_b);
        std::swap(depth.edge_a, depth.edge_b);
        depth.is_point_of_a = !depth.is_point_of_a;
      });
}

Excess excess(const Polygon& part, const Pose& pose_part, const Polygon& area, const Pose& pose_area) {
  const detail::PolygonData &of_part = detail::dataOf(part), &of_area = detail::dataOf(area);
  if (covers(area, pose_area, part, pose_part)) return {0, Vec2::Zero(), Vec2::Zero(), -1, -1, 0};
  const detail::DeepestPoint found =
      detail::excessOfUnion({detail::PosedPair(of_part, pose_part, of_area, pose_area)}, detail::kInfinity);
  // Not covered, though rounding may hide it.
  const double least = std::numeric_limits<double>::denorm_min();
  return {std::max(found.distance, least),
          found.point,
          found.nearest,
          of_part.edgeName(found.edge),
          of_area.edgeName(found.nearest_edge),
          std::max(found.upper_bound, least)};
}

double hausdorffDistance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  detail::requireRigid(pose_a, pose_b);
  return std::max(excess(a, pose_a, b, pose_b).distance, excess(b, pose_b, a, pose_a).distance);
}

}  // namespace tricover
