// SPDX-License-Identifier: BSD-3-Clause
// A part that is covered stays so until it crosses a piece of an edge beside which no area has its inside on both
// sides. These pieces are walls. A part that may stick out is taken as one that may be deep in them (see
// deep_impact.cpp): moved by no more than is allowed it meets no wall for a time, and sticks out by no more.
#include "depth/exit.h"

#include <algorithm>
#include <limits>

#include "depth/conflicts.h"
#include "depth/deep_impact.h"
#include "depth/excess.h"
#include "overlay/edge_sides.h"
#include "overlay/union_covers.h"
#include "polygon/edge_walk.h"

namespace tricover::detail {
namespace {

std::vector<PosedPair> pairsOf(const Polygon& part, const Pose& pose, const std::vector<StillArea>& areas) {
  std::vector<PosedPair> pairs;
  for (const StillArea& area : areas) pairs.emplace_back(dataOf(part), pose, area.polygon, area.pose);
  return pairs;
}

/// Segments seen from `from`, rounded: the boundary of the union.
std::vector<Ring> wallsAround(const Polygon& part, const Pose& pose, const std::vector<StillArea>& areas,
                              const Vec2& from) {
  KnownSides sides(PosedRegions(pairsOf(part, pose, areas)));
  std::vector<Ring> walls;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const auto at = [&](EdgePosition position) {
      return Vec2(areas[i].pose.linear() * areas[i].polygon.path[position] + (areas[i].pose.translation() - from));
    };
    forEachEdge(areas[i].polygon, [&](EdgePosition edge) {
      const Vec2 v = at(edge), w = at(edge + 1);
      for (const EdgeSides::Piece& piece : sides.of(i + 1, edge).pieces())
        if (piece.isBoundary()) {
          const Vec2 begin = (1 - piece.from) * v + piece.from * w, end = (1 - piece.to) * v + piece.to * w;
          walls.push_back({begin, end, end});
        }
      return true;
    });
  }
  return walls;
}

Depth excessAt(const Polygon& part, const Pose& pose, const std::vector<StillArea>& areas) {
  Depth result{0, Vec2::UnitX(), Vec2::Zero(), Vec2::Zero(), -1, -1, false, 0};
  const std::vector<PosedPair> pairs = pairsOf(part, pose, areas);
  if (unionCovers(pairs, 0)) return result;
  const DeepestPoint found = excessOfUnion(pairs, std::numeric_limits<double>::infinity());
  result.depth = found.distance;
  result.upper_bound = found.upper_bound;
  result.point_a = found.nearest;
  result.point_b = found.point;
  result.normal = found.way;
  return result;
}

/// Where the part sticks out as soon as it does: at an exit it doesn't yet.
void addPlace(Impact& impact, const Polygon& part, const Motion& motion, const std::vector<StillArea>& areas,
              double first_step) {
  for (double step = 0; step <= 1; step = step > 0 ? 2 * step : first_step) {
    const Depth out = excessAt(part, motion.at(std::min(impact.time + step, 1.0)), areas);
    impact.point = out.point_b;
    impact.normal = out.normal;
    if (out.depth > 0) return;
  }
}

}  // namespace

std::optional<Impact> firstExit(const Polygon& part, const Motion& motion, const std::vector<StillArea>& areas,
                                double margin) {
  const Impact at_begin{0, motion.start * part.coveringOrigin(), Vec2::UnitX(), -1, -1};
  if (areas.empty() || !unionCoversBut(pairsOf(part, motion.start, areas), margin)) return at_begin;
  const Vec2 from = areas[0].pose.translation();
  const std::vector<Ring> rings = wallsAround(part, motion.start, areas, from);
  if (rings.empty()) return std::nullopt;
  const Polygon walls(rings);
  const Motion still = Motion::still(Pose(Eigen::Translation2d(from)));
  const MovingContact contact(walls, still, part, motion, {std::max(margin, 0.0)});
  const double rounding = contact.precision();
  if (margin > 0) {
    // A wall exactly at the margin is far enough.
    std::optional<Impact> impact = timeOfImpact(walls, still, part, motion, {std::max(margin - rounding, 0.0)});
    if (impact) impact->edge_a = impact->edge_b = -1;
    return impact;
  }
  DeepQuestion question{walls,    still,          part, motion, walls, part, std::max(-margin, 4 * rounding),
                        rounding, contact.speed()};
  question.asks_b = true;
  question.depth = [&](double time) { return excessAt(part, motion.at(time), areas); };
  question.deepest = [&](const Polygon& piece, bool, double time) {
    return excessOfUnion(pairsOf(piece, motion.at(time), areas), std::numeric_limits<double>::infinity());
  };
  question.away = [](const Impact& touch, bool, double) { return std::vector<Vec2>{touch.normal}; };
  question.is_free = [&](const Polygon& piece, const Pose& pose) {
    return unionCovers(pairsOf(piece, pose, areas), 0);
  };
  std::optional<Impact> impact = findDeepImpact(question);
  if (!impact) return impact;
  impact->edge_a = impact->edge_b = -1;
  addPlace(*impact, part, motion, areas, std::max(rounding / contact.speed(), 1e-15));
  return impact;
}

}  // namespace tricover::detail
