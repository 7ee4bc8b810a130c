// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/covers.h"

#include <limits>
#include <vector>

#include "depth/excess.h"
#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "overlay/union_covers.h"

namespace tricover {
namespace detail {
namespace {

/// All rings of some areas, seen from the first one's translation. The fill rule means nothing.
Polygon edgesOf(const std::vector<PosedPair>& part_and_areas, const Vec2& from) {
  std::vector<Ring> rings;
  for (const PosedPair& pair : part_and_areas)
    for (std::size_t ring = 0; ring < pair.b.ringCount(); ++ring) {
      rings.push_back(pair.b.vertices(ring));
      for (Vec2& p : rings.back()) p = pair.pose_b.linear() * p + (pair.pose_b.translation() - from);
    }
  return Polygon(rings);
}

/// The edge of the first area that is one of all areas; kNoEdge for another area's. Vertices that rounding makes one
/// keep their numbers, not their positions.
EdgePosition positionIn(const PolygonData& first, const PolygonData& all, EdgePosition position) {
  const std::size_t ring = all.ringOf(position);
  if (ring >= first.ringCount()) return kNoEdge;
  return first.edgeBegin(ring) + static_cast<EdgePosition>(all.edgeName(position) - all.firstNumber(ring));
}

bool excludes(const PosedPair& pair, const Vec2& p) {
  const Vec2 local = pair.pose_b.linear().inverse() * (p - pair.pose_b.translation());
  return locateInPolygon(pair.b, IncludedPoint::ofFrame(local)) == Location::Outside;
}

}  // namespace

DeepestPoint excessOfUnion(const std::vector<PosedPair>& part_and_areas, double enough) {
  const PolygonData& part = part_and_areas[0].a;
  const auto isBounded = [](const PosedPair& pair) { return !pair.b.fill.is_complement; };
  if (part.fill.is_complement && std::all_of(part_and_areas.begin(), part_and_areas.end(), isBounded)) {
    DeepestPoint result;
    result.distance = result.upper_bound = std::numeric_limits<double>::infinity();
    return result;
  }
  Pose pose = Pose::Identity();
  pose.translation() = part_and_areas[0].pose_b.translation();
  const Polygon edges = edgesOf(part_and_areas, pose.translation());
  const auto isExcluded = [&](const Vec2& p) {
    return std::all_of(part_and_areas.begin(), part_and_areas.end(),
                       [&](const PosedPair& pair) { return excludes(pair, p); });
  };
  const Overlap overlap(part, part_and_areas[0].pose_a, {detail::dataOf(edges), pose, false, isExcluded});
  DeepestPoint found = findDeepestPoint(overlap, false, 0, enough);
  if (found.nearest_edge != kNoEdge)
    found.nearest_edge = positionIn(part_and_areas[0].b, detail::dataOf(edges), found.nearest_edge);
  return found;
}

bool unionCoversBut(const std::vector<PosedPair>& part_and_areas, double margin) {
  if (margin >= 0 || part_and_areas.empty()) return unionCovers(part_and_areas, margin);
  return unionCovers(part_and_areas, 0) || excessOfUnion(part_and_areas, -margin).upper_bound <= -margin;
}

}  // namespace detail

bool covers(const Polygon& area, const Pose& pose_area, const Polygon& part, const Pose& pose_part,
            const CoverOptions& options) {
  detail::requireFiniteMargin(options.margin, "margin");
  detail::requireRigid(pose_area, "pose_area");
  detail::requireRigid(pose_part, "pose_part");
  const detail::PosedPair pair(detail::dataOf(part), pose_part, detail::dataOf(area), pose_area);
  return options.margin >= 0 ? detail::areaCovers(pair, options.margin)
                             : detail::unionCoversBut({pair}, options.margin);
}

}  // namespace tricover
