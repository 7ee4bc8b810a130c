// SPDX-License-Identifier: BSD-3-Clause
// Two moving polygons with a negative margin: when they are as deep in each other first, and how long they stay so.
#include <limits>
#include <optional>
#include <vector>

#include "depth/border.h"
#include "depth/conflicts.h"
#include "depth/deep_impact.h"
#include "numbers/rigidity.h"
#include "overlay/rings.h"
#include "polygon/edge_walk.h"
#include "tricover/polygon.h"

namespace tricover::detail {
namespace {

/// From an edge of a region that has its inside on one side of each alone; and from the next one, at their vertex. A
/// piece that lies within the region touches no edge.
std::vector<Vec2> outwards(const Polygon& region, const Pose& pose, const Impact& touch, double precision) {
  if (touch.edge_a == -1) return {touch.normal};
  const PolygonData& data = dataOf(region);
  const EdgePosition edge = data.edgePosition(touch.edge_a);
  std::vector<Vec2> normals;
  const auto add = [&](EdgePosition position) {
    const Vec2 along = pose.linear() * (data.path[position + 1] - data.path[position]);
    const double side = regionSidesOf(data).rings[data.ringOf(position)] * (isMirrored(pose) ? -1 : 1);
    normals.push_back((side * Vec2(along.y(), -along.x())).stableNormalized());
  };
  add(edge);
  const auto isAt = [&](EdgePosition position) {
    return (pose * data.path[position] - touch.point).stableNorm() <= precision;
  };
  if (isAt(edge + 1)) add(edgeAfter(data, edge));
  if (isAt(edge)) add(edgesAt(data, edge).before);
  return normals;
}

}  // namespace

/// Whether the deepest point of either time, `at`, stays so far from the borders around it.
bool MovingContact::staysDeep(double time, double next, double at) const {
  const Depth& deep = depthAt(at);
  if (!(deep.depth > 0 && touch_margin_ < 0 && next > time) || deep.point_a == deep.point_b) return false;
  const bool of_a = deep.is_point_of_a;
  const Motion &own = of_a ? motion_a_ : motion_b_, &other = of_a ? motion_b_ : motion_a_;
  std::optional<Polygon>& walls = walls_[of_a ? 1 : 0];
  if (!walls) walls.emplace(wallsOf(of_a ? b_ : a_));
  const Vec2 place = own.at(at).inverse(Eigen::Affine) * (of_a ? deep.point_a : deep.point_b);
  if (!place.allFinite()) return false;
  return !timeOfImpact(*walls, other.part(time, next), Polygon::point(place), own.part(time, next),
                       {-touch_margin_, 1});
}

/// The first contact that is as deep as the margin allows.
std::optional<Impact> MovingContact::deepImpact() const {
  const Polygon borders_a = bordersOf(a_), borders_b = bordersOf(b_);
  DeepQuestion question{a_, motion_a_, b_, motion_b_, borders_a, borders_b, -margin_, precision_, speed_};
  question.asks_a = withBordersOnly(dataOf(b_)) != nullptr;
  question.asks_b = withBordersOnly(dataOf(a_)) != nullptr;
  question.depth = [&](double time) { return depthAt(time); };
  question.deepest = [&](const Polygon& piece, bool of_a, double time) {
    const Pose pose_a = motion_a_.at(time), pose_b = motion_b_.at(time);
    const Polygon& region = of_a ? borders_b : borders_a;
    const Overlap overlap(dataOf(piece), of_a ? pose_a : pose_b, {dataOf(region), of_a ? pose_b : pose_a, true});
    return findDeepestPoint(overlap, false, 0, std::numeric_limits<double>::infinity());
  };
  question.away = [&](const Impact& touch, bool of_a, double time) {
    return outwards(of_a ? borders_b : borders_a, (of_a ? motion_b_ : motion_a_).at(time), touch,
                    kDeepEnough * precision_);
  };
  return findDeepImpact(question);
}

}  // namespace tricover::detail
