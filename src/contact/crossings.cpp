// SPDX-License-Identifier: BSD-3-Clause
#include "contact/crossings.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "numbers/segment.h"
#include "overlay/interiors.h"
#include "pair/edge_pairs.h"
#include "pair/kernel_order.h"
#include "tricover/contacts.h"

namespace tricover {
namespace detail {
namespace {

/// Whether an edge is there only because a path has three of each ring: the next one has its number.
bool isPadding(const PolygonData& polygon, EdgePosition edge) {
  return polygon.has_repeats && edge + 1 < polygon.edgeEnd(polygon.ringOf(edge)) &&
         polygon.edgeNumber(edge) == polygon.edgeNumber(edge + 1);
}

std::vector<Crossing> crossingsInWorld(const PosedPair& pair, const CrossingOptions& options) {
  const double margin = options.margin;
  const bool is_open = options.touching == Touching::Allowed;
  const WorldFrame frame(pair);
  std::vector<Crossing> result;
  const auto add = [&](EdgePosition i, EdgePosition j, const Vec2& point) {
    if (isPadding(pair.a, i) || isPadding(pair.b, j)) return;
    result.push_back({pair.a.edgeNumber(i), pair.b.edgeNumber(j), frame.toWorld(point)});
  };
  std::optional<InnerCrossings> inner;
  const std::vector<EdgeCrossing> found = findCrossings(pair, frame);
  if (is_open && margin == 0) inner.emplace(pair, found);
  for (const EdgeCrossing& crossing : found)
    if (!inner || inner->has(crossing)) add(crossing.edge[0], crossing.edge[1], crossing.point);
  if (margin == 0) return result;
  forEachPair(pair, margin, [&](double, EdgePosition i, EdgePosition j) {
    if (!edgesMeet(pair, i, j) && edgesWithin(pair, i, j, margin, 0, is_open)) {
      const auto [on_a, on_b] = nearestPlaces(frame.edgeEndsOfA(i), frame.edgeEndsOfB(j));
      add(i, j, 0.5 * on_a + 0.5 * on_b);
    }
    return margin;
  });
  return result;
}

/// Keeps of the span where f is between low and high, f going evenly from f0 to f1.
void clip(Span& span, double f0, double f1, double low, double high) {
  if (f0 == f1) return;
  const double s = (low - f0) / (f1 - f0), t = (high - f0) / (f1 - f0);
  span.low = std::max(span.low, std::min(s, t));
  span.high = std::min(span.high, std::max(s, t));
}

}  // namespace

Span spanNear(const WorldFrame::Ends& edge, const WorldFrame::Ends& other, double error) {
  Span span{0, 1};
  const Vec2 u = other.w - other.v;
  const double length = u.norm();
  const Vec2 along = length > 0 ? Vec2(u / length) : Vec2::Zero(), from = edge.v - other.v, to = edge.w - other.v;
  if (length > 0) {
    clip(span, cross(along, from), cross(along, to), -error, error);
    clip(span, along.dot(from), along.dot(to), -error, length + error);
  } else {
    const Vec2 way = edge.w - edge.v;
    const double way_length = way.norm();
    if (way_length > 0) clip(span, way.dot(from) / way_length, way.dot(to) / way_length, -error, error);
  }
  if (span.low > span.high) span.low = span.high = std::clamp(span.middle(), 0.0, 1.0);
  return span;
}

std::vector<EdgeCrossing> findCrossings(const PosedPair& pair, const WorldFrame& frame) {
  std::vector<EdgeCrossing> result;
  result.reserve(8);
  forEachPair(pair, 0, [&](double, EdgePosition i, EdgePosition j) {
    if (edgesMeet(pair, i, j)) {
      const WorldFrame::Ends edge_a = frame.edgeEndsOfA(i), edge_b = frame.edgeEndsOfB(j);
      const Span on_a = spanNear(edge_a, edge_b, frame.error()), on_b = spanNear(edge_b, edge_a, frame.error());
      result.push_back({{i, j}, {on_a, on_b}, frame.edgeOfB(j, on_b.middle()), crossingDirection(pair, i, j)});
    }
    return 0.0;
  });
  return result;
}

}  // namespace detail

std::vector<Crossing> crossings(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                                const CrossingOptions& options) {
  detail::requireFiniteNotNegative(options.margin, "margin");
  detail::requireTouching(options.touching);
  detail::requireRigid(pose_a, pose_b);
  return detail::inKernelOrder(
      detail::dataOf(a), pose_a, detail::dataOf(b), pose_b,
      [&](const auto&... operands) { return detail::crossingsInWorld(detail::PosedPair(operands...), options); },
      [](std::vector<Crossing>& crossings) {
        for (Crossing& crossing : crossings) std::swap(crossing.edge_a, crossing.edge_b);
      });
}

}  // namespace tricover
