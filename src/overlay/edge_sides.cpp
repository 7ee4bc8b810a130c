// SPDX-License-Identifier: BSD-3-Clause
#include "overlay/edge_sides.h"

#include <algorithm>
#include <cmath>

#include "hierarchy/simd.h"
#include "numbers/segment.h"
#include "pair/root_box.h"
#include "polygon/covering.h"

namespace tricover::detail {

namespace {

/// x / (x + y) of areas on both sides of a line: with x and y wrong by their bounds it errs by at most the sum of both
/// divided by x + y, but for the latter's error: twice. Anything from 0 to 1 where that says nothing.
struct Share {
  double middle, error;
};
Share shareOf(const ApproxArea& x, const ApproxArea& y) {
  const double whole = std::abs(x.area - y.area), bound = x.bound + y.bound;
  if (!(whole > 4 * bound && whole < 0x1p1000)) return {0.5, 0.5};
  return {std::abs(x.area) / whole, 2 * bound / whole + 4 * kUnitRoundoff};
}

/// Whether a polygon may wind around a point, in its units. Nothing winds around a point of a degenerate polygon.
bool mayWindAround(const PolygonData& polygon, const Vec2& at, double error) {
  if (polygon.isDegenerate()) return false;
  return !(polygon.fitsUnit() && distanceFromRoot(topOf(polygon).root, {at.x(), at.y(), error}) > 0);
}

/// A point, in units, outside of the box around everything: from `at` towards the nearest side, askew, so that the way
/// from there is hardly along edges.
Vec2 outsideBeside(const PolygonData& polygon, const Vec2& at) {
  const double far = 0x1p-6 + 0x1p-48 * polygon.extent * polygon.inverse_unit;
  // Where the polygon doesn't fit the unit, doubles are below 16 units: nothing is 32 units from S.
  if (!polygon.fitsUnit() || !(at.lpNorm<1>() < 0x1p10)) return {64, 24};
  const Box& root = topOf(polygon).root;
  const Vec2 axis(root.ux, root.uy), from = at - Vec2(root.x, root.y), normal(-axis.y(), axis.x());
  const double along = from.dot(axis), across = from.dot(normal);
  const double room_along = root.along - std::abs(along), room_across = root.across - std::abs(across);
  const Vec2 out = room_along < room_across ? Vec2(std::copysign(1, along) * axis) : std::copysign(1, across) * normal;
  const double length = std::max(std::min(room_along, room_across), 0.0) + far;
  return at + length * (out + 0.38 * Vec2(-out.y(), out.x()));
}

}  // namespace

PosedRegions::PosedRegions(const PolygonData& polygon) : size_(1), finds_along_(false) {
  static const Pose kHere = Pose::Identity();
  pairs_.emplace_back(polygon, kHere, polygon, kHere);
}

bool PosedRegions::isNear(std::size_t i, const ApproxPoint& v, const ApproxPoint& w) const {
  const PolygonData& region = polygon(i);
  const ApproxPoint center = approx(i, region.origin);
  const double reach = region.reach * (1 + 4 * kLargestDefect) + 4 * (center.error + std::max(v.error, w.error));
  const double square = squaredDistanceToSegment({center.x, center.y}, {v.x, v.y}, {w.x, w.y});
  return !(squarable(reach) && square > reach * reach);
}

/// Wrong as the pair's points are, which this one may be beyond.
ApproxPoint PosedRegions::approx(std::size_t i, const Vec2& p) const {
  const PosedPair& pair = pairs_[i == 0 ? 0 : i - 1];
  const ApproxPoint at = i == 0 ? pair.fromA(p) : pair.fromB(p);
  return {at.x, at.y, PosedPair::kErrorOfB * (pair.size() + p.lpNorm<1>()) * (1 + 8 * kUnitRoundoff) + kTiny};
}

ApproxPoint PosedRegions::inFrame(std::size_t i, std::size_t of, EdgePosition position) const {
  const Vec2& p = polygon(of).path[position];
  if (i == of) return {p.x(), p.y(), 0};
  return seenFromA({polygon(i), pose(i), polygon(of), pose(of)}, p).approx;
}

EdgeSides::EdgeSides(const PosedRegions& regions, std::size_t operand, EdgePosition edge, const EdgeSides* before)
    : regions_(regions),
      operand_(operand),
      edge_(edge),
      line_(regions.edge(operand, edge), regions.at(operand, edge).approx, regions.at(operand, edge + 1).approx) {
  const Path& path = regions.polygon(operand).path;
  if (path[edge] == path[edge + 1]) return;
  for (std::size_t i = 0; i < regions.size(); ++i)
    if (i == operand || regions.isNear(i, line_.v.approx, line_.w.approx)) findEvents(i, before);
  line_.forEachPlace(events_, operand, edge, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) windings_.at(events_[i].polygon).add(events_[i]);
    if (end < events_.size()) addPiece(end - 1);
  });
}

/// Finds the winding numbers of one polygon at v, and its events from there on.
void EdgeSides::findEvents(std::size_t operand, const EdgeSides* before) {
  const PolygonData& polygon = regions_.polygon(operand);
  const ApproxPoint v = regions_.inFrame(operand, operand_, edge_), w = regions_.inFrame(operand, operand_, edge_ + 1);
  const Vec2 at_v = polygon.inUnits({v.x, v.y}), at_w = polygon.inUnits({w.x, w.y});
  Approach approach;
  approach.u = before != nullptr ? before->line_.v : line_.w;
  if (before != nullptr) {
    const auto known = before->windings_.find(operand);
    if (known != before->windings_.end()) approach.windings = {known->second.left, known->second.right, 0};
  } else if (const double error = 1.5 * v.error * polygon.inverse_unit; mayWindAround(polygon, at_v, error)) {
    comeFromOutside(approach, operand, at_v, error);
  }
  approach.bend = orientation(approach.u, line_.v, line_.w);
  approach.leads_back = approach.bend == 0 && !isBetween(line_.v, approach.u, line_.w);
  windings_[operand] = approach.windings;
  if (approach.leads_back) std::swap(windings_[operand].left, windings_[operand].right);
  forEachEdgeNear(polygon, at_v, at_w, 1.5 * std::max(v.error, w.error) * polygon.inverse_unit, [&](EdgePosition edge) {
    const SeenPoint q = regions_.at(operand, edge), r = regions_.at(operand, edge + 1);
    const LineMeeting meeting = meetLine(line_.v, line_.w, operand, edge, q, r);
    if (meeting.kind == LineMeeting::Along && operand != operand_ && operand_ == A && regions_.findsAlong())
      for (const LineMeeting& end : line_.meetAlong(operand, edge, q.exact, r.exact)) {
        if (end.at_v <= 0) windings_.at(operand).add(end.event);
        addEvent(end, q, r);
      }
    if (meeting.kind == LineMeeting::Point) addEvent(meeting, q, r);
    const bool is_at_v = meeting.kind == LineMeeting::Point
                             ? meeting.at_v == 0
                             : meeting.kind == LineMeeting::Along && isBetween(line_.v, q, r);
    if (is_at_v) goAround(approach, meeting, q, r);
    return true;
  });
}

/// v is `at`, in units of the polygon, but for an error in any direction. The segment begins at a point of the
/// polygon's frame: an eighth of it doesn't overflow.
void EdgeSides::comeFromOutside(Approach& approach, std::size_t operand, const Vec2& at, double error) const {
  const PolygonData& polygon = regions_.polygon(operand);
  const Vec2 begin = outsideBeside(polygon, at);
  const Vec2 eighth = 0.125 * polygon.origin + 0.125 * polygon.unit * begin;
  approach.pose = regions_.pose(operand);
  approach.pose.matrix().topLeftCorner<2, 2>() *= 8;
  approach.u = {regions_.approx(operand, 8 * eighth), {&approach.pose, eighth}};
  const double room = error + 0x1p-48 * polygon.extent * polygon.inverse_unit;
  forEachEdgeNear(polygon, begin, at, room, [&](EdgePosition edge) {
    const LineMeeting meeting =
        meetLine(approach.u, line_.v, operand, edge, regions_.at(operand, edge), regions_.at(operand, edge + 1));
    if (meeting.kind == LineMeeting::Point && meeting.at_v > 0 && meeting.at_w < 0)
      approach.windings.add(meeting.event);
    return true;
  });
}

/// Adds the event of an edge, if that meets this one between its ends.
void EdgeSides::addEvent(const LineMeeting& meeting, const SeenPoint& q, const SeenPoint& r) {
  if (meeting.at_v <= 0 || meeting.at_w >= 0) return;
  const ApproxPoint &v = line_.v.approx, &w = line_.w.approx;
  const Share share = shareOf(approxArea(q.approx, r.approx, v), approxArea(q.approx, r.approx, w));
  events_.push_back(meeting.event);
  events_.back().place = share.middle;
  events_.back().error = share.error;
}

/// The left of the sweep stays on the left of the path u v w, its right on the right. An edge that v is on leads from v
/// to its end r, and to v from its end q. If v sees such an end on the left of the path, the left is led past it,
/// clockwise; on the right the right is led past it, counter-clockwise. A path that leads straight back exchanges both
/// sides, and goes past nothing.
void EdgeSides::goAround(const Approach& approach, const LineMeeting& meeting, const SeenPoint& q, const SeenPoint& r) {
  if (approach.leads_back) return;
  Windings& beside = windings_.at(meeting.event.polygon);
  const auto pass = [&](const SeenPoint& end, int of_end, int direction) {
    if (of_end == 0 && (meeting.kind == LineMeeting::Point || isBetween(line_.v, end, end))) return;  // it is v
    const int of_approach = orientation(approach.u, line_.v, end);
    const int side = approach.bend >= 0 ? std::min(of_approach, of_end) : std::max(of_approach, of_end);
    if (side > 0) beside.left -= direction;
    if (side < 0) beside.right += direction;
  };
  pass(q, meeting.of_q, -1);
  pass(r, meeting.of_r, 1);
}

EdgeSides::Sides EdgeSides::insides(std::size_t operand) const {
  const Fill& fill = regions_.polygon(operand).fill;
  const auto found = windings_.find(operand);
  const Windings windings = found != windings_.end() ? found->second : Windings{};
  return {isInside(fill, windings.left), isInside(fill, windings.right)};
}

/// After an event, with the windings there.
void EdgeSides::addPiece(std::size_t event) {
  const SweepEvent& end = events_[event + 1];
  const double from = pieces_.empty() ? 0 : pieces_.back().to;
  const double to = event + 2 < events_.size()
                        ? 0.5 * std::max(end.place - end.error, 0.0) + 0.5 * std::min(end.place + end.error, 1.0)
                        : 1;
  Piece piece{from, to, event, operand_ == A, insides(operand_), insides(A), {false, false}, false};
  for (const auto& [operand, windings] : windings_) {
    if (operand == A) continue;
    const Sides other = insides(operand);
    piece.others.left |= other.left;
    piece.others.right |= other.right;
    piece.has_along |= windings.along > 0;
  }
  pieces_.push_back(piece);
}

bool EdgeSides::hasBoundaryWithin(EdgePosition edge, double margin) const {
  return std::any_of(pieces_.begin(), pieces_.end(),
                     [&](const Piece& piece) { return piece.isBoundary() && isWithin(piece, edge, margin); });
}

/// The edge as a whole is nearer. Points err by 5U of the pair's size, with which they are mapped; places between them,
/// and the nearest ones, by few U of it more.
///
/// Where that hides whether the distance is less than the margin, exact numbers tell: of the ends of the edge whose
/// feet are on the piece, and of the piece's ends.
bool EdgeSides::isWithin(const Piece& piece, EdgePosition edge, double margin) const {
  if (events_.size() == 2) return true;
  const SweepEvent &begin = events_[piece.event], &end = events_[piece.event + 1];
  const ApproxPoint &from = line_.v.approx, &to = line_.w.approx;
  const SeenPoint p = regions_.at(A, edge), q = regions_.at(A, edge + 1);
  const Vec2 v(from.x, from.y), along(to.x - v.x(), to.y - v.y());
  const auto distanceOf = [&](double low, double high) {
    const Ends other{{p.approx.x, p.approx.y}, {q.approx.x, q.approx.y}};
    return nearestPlaces(other, {v + std::max(low, 0.0) * along, v + std::min(high, 1.0) * along}).way().norm();
  };
  const double size = (p.approx.error + from.error) / kUnitRoundoff, error = 0x1p-46 * size;
  if (size > 0x1p-400 && size < 0x1p400) {  // squares don't leave the range of doubles
    const double inner = begin.place + begin.error, inner_end = end.place - end.error;
    if (inner <= inner_end && distanceOf(inner, inner_end) + error < margin) return true;
    if (distanceOf(begin.place - begin.error, end.place + end.error) - error > margin) return false;
  }
  const PosedSegment own = regions_.edge(operand_, edge_), other = regions_.edge(A, edge);
  const auto isNear = [&](const PosedPoint& end_of_other) {
    return compareFootExact(end_of_other, own, begin.edge()) >= 0 &&
           compareFootExact(end_of_other, own, end.edge()) <= 0 &&
           withinExact(end_of_other, own[0], own[1], margin, true);
  };
  return isNear(other[0]) || isNear(other[1]) || meetingWithinExact(own, begin.edge(), other, margin) ||
         meetingWithinExact(own, end.edge(), other, margin);
}

/// Whether what the other edge has in common with this one is, as a whole, on one side of an event: 1 after it, -1
/// before.
bool EdgeSides::isBeyond(EdgePosition edge, const SweepEvent& event, int side) const {
  const std::size_t operand = operand_ == A ? B : A;
  const SeenPoint q = regions_.at(operand, edge), r = regions_.at(operand, edge + 1);
  const auto isThere = [&](const SeenPoint& from, const SeenPoint& to) {
    const SweepEvent at{from.exact.pose, {from.exact.local, to.exact.local}, operand, edge};
    return line_.compare(event, at) * side < 0;
  };
  return orientation(line_.v, line_.w, q) != 0 || orientation(line_.v, line_.w, r) != 0
             ? isThere(q, r)
             : isThere(q, q) && isThere(r, r);
}

bool EdgeSides::hasAny(Is is) const {
  return std::any_of(pieces_.begin(), pieces_.end(), [&](const Piece& piece) { return (piece.*is)(); });
}

bool EdgeSides::hasAnyUntil(Is is, const std::vector<EdgePosition>& edges, int side) const {
  return std::any_of(pieces_.begin(), pieces_.end(), [&](const Piece& piece) {
    const SweepEvent& event = events_[side > 0 ? piece.event : piece.event + 1];
    return (piece.*is)() &&
           std::none_of(edges.begin(), edges.end(), [&](EdgePosition edge) { return isBeyond(edge, event, -side); });
  });
}

bool EdgeSides::hasAnyAt(Is is, EdgePosition edge) const {
  return std::any_of(pieces_.begin(), pieces_.end(), [&](const Piece& piece) {
    return (piece.*is)() && !isBeyond(edge, events_[piece.event], -1) && !isBeyond(edge, events_[piece.event + 1], 1);
  });
}

const EdgeSides& KnownSides::of(std::size_t operand, EdgePosition edge) {
  if (const EdgeSides* known = ifKnown(operand, edge)) return *known;
  const EdgeSides* before = ifKnown(operand, edgesAt(regions_.polygon(operand), edge).before);
  return known_.try_emplace({operand, edge}, regions_, operand, edge, before).first->second;
}

bool crossAlone(const PosedPair& pair, EdgePosition i, EdgePosition j) {
  if (crossingDirection(pair, i, j) == 0) return false;
  const ApproxPoint v = pair.fromA(pair.a.path[i]), w = pair.fromA(pair.a.path[i + 1]);
  const ApproxPoint q = pair.fromB(pair.b.path[j]), r = pair.fromB(pair.b.path[j + 1]);
  // The path of units errs by few U.
  const auto isAlone = [](const PolygonData& polygon, EdgePosition edge, const Share& place) {
    if (!polygon.fitsUnit()) return false;
    const Vec2 begin = polygon.inUnits(polygon.path[edge]), way = polygon.inUnits(polygon.path[edge + 1]) - begin;
    const Vec2 at = begin + place.middle * way;
    bool is_alone = true;
    forEachEdgeNear(polygon, at, at, place.error * way.lpNorm<1>(), [&](std::size_t found) {
      return is_alone = found == edge || polygon.path[found] == polygon.path[found + 1];
    });
    return is_alone;
  };
  return isAlone(pair.a, i, shareOf(approxArea(q, r, v), approxArea(q, r, w))) &&
         isAlone(pair.b, j, shareOf(approxArea(v, w, q), approxArea(v, w, r)));
}

}  // namespace tricover::detail
