// SPDX-License-Identifier: BSD-3-Clause
#include "overlay/edge_sides.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hierarchy/simd.h"
#include "numbers/segment.h"
#include "pair/root_box.h"
#include "polygon/covering.h"

namespace tricover::detail {

namespace {

bool areOne(const PosedPoint& p, const PosedPoint& q) { return p.pose == q.pose && p.local == q.local; }

/// The sign of the signed area |p q r|. Exact.
int sign(const SeenPoint& p, const SeenPoint& q, const SeenPoint& r) {
  const int sign = orientFilter(p.approx, q.approx, r.approx);
  if (sign != kUncertain) return sign;
  const PosedPoint &x = p.exact, &y = q.exact, &z = r.exact;
  return areOne(x, y) || areOne(y, z) || areOne(x, z) ? 0 : orientExact(x, y, z);
}

/// Whether p, on the line of q and r, is between them or one of them. Exact.
bool isBetween(const SeenPoint& p, const SeenPoint& q, const SeenPoint& r) {
  const ApproxPoint &x = p.approx, &y = q.approx, &z = r.approx;
  const double error = 2 * (x.error + std::max(y.error, z.error));
  const auto tell = [&](double to_q, double to_r) {
    if (std::max(to_q, to_r) < -error || std::min(to_q, to_r) > error) return -1;
    return std::min(to_q, to_r) < -error && std::max(to_q, to_r) > error ? 1 : 0;
  };
  const int in_x = tell(y.x - x.x, z.x - x.x), in_y = tell(y.y - x.y, z.y - x.y);
  if (in_x != 0 || in_y != 0) return in_x >= 0 && in_y >= 0;
  return areOne(p.exact, q.exact) || areOne(p.exact, r.exact) || betweenExact(p.exact, q.exact, r.exact);
}

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

/// A point, in units, outside of the box around everything: from `at` towards the nearest side, askew, so that the way
/// from there is hardly along edges.
Vec2 outsideBeside(const PolygonData& polygon, const Vec2& at) {
  const double far = 0x1p-6 + 0x1p-48 * polygon.extent * polygon.inverse_unit;
  if (!polygon.fitsUnit() || !(at.lpNorm<1>() < 0x1p10)) return {8, 3};
  const Box& root = topOf(polygon).root;
  const Vec2 axis(root.ux, root.uy), from = at - Vec2(root.x, root.y), normal(-axis.y(), axis.x());
  const double along = from.dot(axis), across = from.dot(normal);
  const double room_along = root.along - std::abs(along), room_across = root.across - std::abs(across);
  const Vec2 out = room_along < room_across ? Vec2(std::copysign(1, along) * axis) : std::copysign(1, across) * normal;
  const double length = std::max(std::min(room_along, room_across), 0.0) + far;
  return at + length * (out + 0.38 * Vec2(-out.y(), out.x()));
}

}  // namespace

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

ApproxPoint PosedRegions::inFrame(std::size_t i, std::size_t of, std::size_t position) const {
  const Vec2& p = polygon(of).path[position];
  if (i == of) return {p.x(), p.y(), 0};
  return seenFromA({polygon(i), pose(i), polygon(of), pose(of)}, p).approx;
}

EdgeSides::EdgeSides(const PosedRegions& regions, std::size_t operand, std::size_t edge, const EdgeSides* before)
    : regions_(regions), operand_(operand), edge_(edge) {
  const Path& path = regions.polygon(operand).path;
  if (path[edge] == path[edge + 1]) return;
  v_ = regions.at(operand, edge);
  w_ = regions.at(operand, edge + 1);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  addPoint(operand, v_.exact, 0, -kInfinity, -kInfinity);
  for (std::size_t i = 0; i < regions.size(); ++i)
    if (i == operand || regions.isNear(i, v_.approx, w_.approx)) findCuts(i, before);
  std::sort(cuts_.begin() + 1, cuts_.end(), [&](const Cut& p, const Cut& q) { return isBefore(p, q); });
  addPoint(operand, w_.exact, 0, kInfinity, kInfinity);
  for (std::size_t i = 0; i + 1 < cuts_.size(); ++i) {
    windings_.at(cuts_[i].operand).add(cuts_[i]);
    // Between cuts at one place there is nothing.
    if (isBefore(cuts_[i], cuts_[i + 1])) look(i);
  }
}

/// Finds those of one polygon.
void EdgeSides::findCuts(std::size_t operand, const EdgeSides* before) {
  const PolygonData& polygon = regions_.polygon(operand);
  const ApproxPoint v = regions_.inFrame(operand, operand_, edge_), w = regions_.inFrame(operand, operand_, edge_ + 1);
  const Vec2 at_v = polygon.inUnits({v.x, v.y}), at_w = polygon.inUnits({w.x, w.y});
  Way way;
  if (before != nullptr) {
    way.from = before->v_;
    const auto known = before->windings_.find(operand);
    if (known != before->windings_.end()) way.winding = known->second.right;
  } else {
    leadFromOutside(way, operand, at_v, 1.5 * v.error * polygon.inverse_unit);
  }
  windings_[operand] = {way.winding, way.winding};
  forEachEdgeNear(polygon, at_v, at_w, 1.5 * std::max(v.error, w.error) * polygon.inverse_unit, [&](std::size_t edge) {
    add(operand, edge, way);
    return true;
  });
}

/// v is `at`, in units of the polygon, but for an error in any direction. The way begins at a point of its frame: an
/// eighth of it doesn't overflow.
void EdgeSides::leadFromOutside(Way& way, std::size_t operand, const Vec2& at, double error) const {
  const PolygonData& polygon = regions_.polygon(operand);
  way.from = w_;
  if (polygon.isDegenerate()) return;  // nothing winds around a point
  if (polygon.fitsUnit() && distanceFromRoot(topOf(polygon).root, {at.x(), at.y(), error}) > 0) return;
  const Vec2 begin = outsideBeside(polygon, at);
  const Vec2 eighth = 0.125 * polygon.origin + 0.125 * polygon.unit * begin;
  way.pose = regions_.pose(operand);
  way.pose.matrix().topLeftCorner<2, 2>() *= 8;
  way.from = {regions_.approx(operand, 8 * eighth), {&way.pose, eighth}};
  const double room = error + 0x1p-48 * polygon.extent * polygon.inverse_unit;
  forEachEdgeNear(polygon, begin, at, room, [&](std::size_t edge) {
    const SeenPoint q = regions_.at(operand, edge), r = regions_.at(operand, edge + 1);
    const int of_q = sign(way.from, v_, q), of_r = sign(way.from, v_, r);
    const int slant = of_q < 0 ? 1 : -1;
    if ((of_q < 0) != (of_r < 0) && sign(q, r, v_) * slant < 0 && sign(q, r, way.from) * slant > 0)
      way.winding -= slant;
    return true;
  });
}

/// With u from v to w, d along the other edge from q to r, and D = |u d|, that edge's line meets this one's at
///   s     = |q r v| / D,
///   s - 1 = |q r w| / D,
/// and D has the sign of what r is to the left of q by. The way goes from the left of d to its right where D > 0.
void EdgeSides::add(std::size_t operand, std::size_t edge, Way& way) {
  const SeenPoint q = regions_.at(operand, edge), r = regions_.at(operand, edge + 1);
  const int of_q = sign(v_, w_, q), of_r = sign(v_, w_, r);
  if (of_q * of_r > 0) return;
  if (of_q == 0 && of_r == 0) {
    if (operand != operand_ && operand_ == A && regions_.sought() == PosedRegions::Outside) addAlong(operand, q, r);
    if (!isBetween(v_, q, r)) return;
    if (!isBetween(v_, q, q)) pass(way, q, 0, -1);
    if (!isBetween(v_, r, r)) pass(way, r, 0, 1);
    return;
  }
  const int slant = of_r > of_q ? 1 : -1, at_v = sign(q, r, v_) * slant;
  if (at_v < 0) return;
  if (at_v == 0) {
    if (of_q != 0) pass(way, q, of_q, -1);
    if (of_r != 0) pass(way, r, of_r, 1);
    return;
  }
  if (sign(q, r, w_) * slant >= 0) return;
  const Share place = shareOf(approxArea(q.approx, r.approx, v_.approx), approxArea(q.approx, r.approx, w_.approx));
  cuts_.push_back({q.exact.pose,
                   {q.exact.local, r.exact.local},
                   operand,
                   static_cast<std::int8_t>(-slant),
                   of_q > 0 || of_r > 0,
                   of_q < 0 || of_r < 0,
                   0,
                   place.middle - place.error,
                   place.middle + place.error});
}

/// An edge along the line, or a point on it: from its first end on there is one more, from its last end on one less.
void EdgeSides::addAlong(std::size_t operand, const SeenPoint& q, const SeenPoint& r) {
  const int direction = compareAlong(q, r);
  for (const auto& [end, along] : {std::pair(&q, direction), std::pair(&r, -direction)}) {
    if (compareAlong(*end, v_) >= 0)
      windings_.at(operand).along += along;
    else if (compareAlong(*end, w_) > 0)
      addPoint(operand, end->exact, static_cast<std::int8_t>(along), 0, 1);
  }
}

void EdgeSides::addPoint(std::size_t operand, const PosedPoint& point, std::int8_t along, double low, double high) {
  cuts_.push_back({point.pose, {point.local, point.local}, operand, 0, true, false, along, low, high});
}

/// The order of two points on the line: 1 if the way comes to p before q, -1 after it.
int EdgeSides::compareAlong(const SeenPoint& p, const SeenPoint& q) const {
  for (const int axis : {0, 1})
    if (const int sign = compareExact(w_.exact, v_.exact, axis)) return compareExact(q.exact, p.exact, axis) * sign;
  return 0;
}

/// An edge leaves v for `end` (turn 1), or comes from there (-1), which is on that side of v w: counter-clockwise
/// around v it may be passed before v w, or be along that.
void EdgeSides::pass(Way& way, const SeenPoint& end, int side, int turn) {
  Windings& beside = windings_.rbegin()->second;  // its polygon's
  if (way.course == kUncertain) {
    way.course = sign(v_, way.from, w_);
    way.leads_back = way.course == 0 && !isBetween(v_, way.from, w_);
  }
  const int of_way = sign(v_, way.from, end);
  const bool is_along = side == 0 && !isBetween(v_, end, w_);
  const bool is_passed = way.course > 0 ? of_way > 0 && side < 0 : of_way > 0 || side < 0;
  if (way.leads_back) {  // v w is the last one around v, and the first
    if (!is_along) beside.right += turn;
    return;
  }
  if (is_passed) beside.right += turn;
  if (is_passed || is_along) beside.left += turn;
}

bool EdgeSides::isBefore(const Cut& p, const Cut& q) const {
  if (p.high < q.low) return true;
  if (q.high < p.low) return false;
  return compareFractionsExact(edgeOf(operand_, edge_), p.edge(), q.edge()) < 0;
}

EdgeSides::Sides EdgeSides::insides(std::size_t operand) const {
  const Fill& fill = regions_.polygon(operand).fill;
  const auto found = windings_.find(operand);
  const Windings windings = found != windings_.end() ? found->second : Windings{};
  return {isInside(fill, windings.left), isInside(fill, windings.right)};
}

/// At a piece, whose windings are known.
void EdgeSides::look(std::size_t piece) {
  const Sides first = insides(A), own = insides(operand_);
  Sides others{false, false};
  bool has_along = false;
  for (const auto& [operand, windings] : windings_) {
    if (operand == A) continue;
    const Sides other = insides(operand);
    others.left |= other.left;
    others.right |= other.right;
    has_along |= windings.along > 0;
  }
  const bool is_bare = !own.left && !own.right, inside = regions_.sought() == PosedRegions::Inside;
  const bool is_off = !inside && operand_ == A && is_bare && !others.left && !others.right && !has_along;
  if ((first.left && others.left == inside) || (first.right && others.right == inside) || is_off)
    sought_.push_back(piece);
  if (inside && (operand_ == A ? others.left && others.right : first.left && first.right)) in_other_.push_back(piece);
  if (!inside && operand_ != A && !(others.left && others.right)) boundary_.push_back(piece);
  if (is_bare) bare_.push_back(piece);
  if (own.left != own.right)
    borders_.push_back(piece);
  else
    is_seam_ = true;
}

std::vector<EdgeSides::Piece> EdgeSides::pieces() const {
  std::vector<Piece> all;
  const auto has = [](const std::vector<std::size_t>& some, std::size_t piece) {
    return std::binary_search(some.begin(), some.end(), piece);
  };
  for (std::size_t i = 0; i + 1 < cuts_.size(); ++i) {
    if (!isBefore(cuts_[i], cuts_[i + 1])) continue;
    const Cut& end = cuts_[i + 1];
    const double to = i + 2 < cuts_.size() ? 0.5 * std::max(end.low, 0.0) + 0.5 * std::min(end.high, 1.0) : 1;
    all.push_back({all.empty() ? 0 : all.back().to, to, has(borders_, i), has(boundary_, i)});
  }
  return all;
}

bool EdgeSides::hasBoundaryWithin(std::size_t edge, double margin) const {
  return std::any_of(boundary_.begin(), boundary_.end(),
                     [&](std::size_t piece) { return isWithin(piece, edge, margin); });
}

/// The edge as a whole is nearer. Points err by 5U of the pair's size, with which they are mapped; places between them,
/// and the nearest ones, by few U of it more.
///
/// Where that hides whether the distance is less than the margin, exact numbers tell: of the ends of the edge whose
/// feet are on the piece, and of the piece's ends.
bool EdgeSides::isWithin(std::size_t piece, std::size_t edge, double margin) const {
  if (cuts_.size() == 2) return true;
  const Cut &begin = cuts_[piece], &end = cuts_[piece + 1];
  const SeenPoint p = regions_.at(A, edge), q = regions_.at(A, edge + 1);
  const Vec2 v(v_.approx.x, v_.approx.y), along(w_.approx.x - v.x(), w_.approx.y - v.y());
  const auto distanceOf = [&](double from, double to) {
    const Ends other{{p.approx.x, p.approx.y}, {q.approx.x, q.approx.y}};
    return nearestPlaces(other, {v + std::max(from, 0.0) * along, v + std::min(to, 1.0) * along}).way().norm();
  };
  const double size = (p.approx.error + v_.approx.error) / kUnitRoundoff, error = 0x1p-46 * size;
  if (size > 0x1p-400 && size < 0x1p400) {  // squares don't leave the range of doubles
    if (begin.high <= end.low && distanceOf(begin.high, end.low) + error < margin) return true;
    if (distanceOf(begin.low, end.high) - error > margin) return false;
  }
  const PosedSegment own = edgeOf(operand_, edge_), other = edgeOf(A, edge);
  const auto isNear = [&](const PosedPoint& end_of_other) {
    return compareFootExact(end_of_other, own, begin.edge()) >= 0 &&
           compareFootExact(end_of_other, own, end.edge()) <= 0 &&
           withinExact(end_of_other, own[0], own[1], margin, true);
  };
  return isNear(other[0]) || isNear(other[1]) || meetingWithinExact(own, begin.edge(), other, margin) ||
         meetingWithinExact(own, end.edge(), other, margin);
}

/// Whether what the other edge has in common with this one is, as a whole, on one side of a cut: 1 after it, -1 before.
bool EdgeSides::isBeyond(std::size_t edge, const Cut& cut, int side) const {
  const std::size_t operand = operand_ == A ? B : A;
  const SeenPoint q = regions_.at(operand, edge), r = regions_.at(operand, edge + 1);
  const auto isThere = [&](const SeenPoint& from, const SeenPoint& to) {
    const Cut at{from.exact.pose, {from.exact.local, to.exact.local}, operand, 0, false, false, 0, 0, 1};
    return side > 0 ? isBefore(cut, at) : isBefore(at, cut);
  };
  return sign(v_, w_, q) != 0 || sign(v_, w_, r) != 0 ? isThere(q, r) : isThere(q, q) && isThere(r, r);
}

bool EdgeSides::isAnyUntil(const std::vector<std::size_t>& pieces, const std::vector<std::size_t>& edges,
                           int side) const {
  return std::any_of(pieces.begin(), pieces.end(), [&](std::size_t piece) {
    const Cut& cut = cuts_[side > 0 ? piece : piece + 1];
    return std::none_of(edges.begin(), edges.end(), [&](std::size_t edge) { return isBeyond(edge, cut, -side); });
  });
}

bool EdgeSides::isAnyAt(const std::vector<std::size_t>& pieces, std::size_t edge) const {
  return std::any_of(pieces.begin(), pieces.end(), [&](std::size_t piece) {
    return !isBeyond(edge, cuts_[piece], -1) && !isBeyond(edge, cuts_[piece + 1], 1);
  });
}

const EdgeSides& KnownSides::of(std::size_t operand, std::size_t edge) {
  if (const EdgeSides* known = ifKnown(operand, edge)) return *known;
  const EdgeSides* before = ifKnown(operand, edgesAt(regions_.polygon(operand), edge).before);
  return known_.try_emplace({operand, edge}, regions_, operand, edge, before).first->second;
}

bool crossAlone(const PosedPair& pair, std::size_t i, std::size_t j) {
  if (crossingDirection(pair, i, j) == 0) return false;
  const ApproxPoint v = pair.fromA(pair.a.path[i]), w = pair.fromA(pair.a.path[i + 1]);
  const ApproxPoint q = pair.fromB(pair.b.path[j]), r = pair.fromB(pair.b.path[j + 1]);
  // The path of units errs by few U.
  const auto isAlone = [](const PolygonData& polygon, std::size_t edge, const Share& place) {
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
