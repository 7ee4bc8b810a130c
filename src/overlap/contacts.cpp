// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/contacts.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <unordered_set>
#include <utility>

#include "numbers/rigidity.h"
#include "numbers/segment.h"
#include "overlap/hull_faces.h"
#include "overlap/overlap_components.h"
#include "pair/edge_pairs.h"
#include "pair/kernel_order.h"
#include "polygon/convexity.h"

namespace tricover {
namespace detail {
namespace {

/// A contact in the WorldFrame, edges by position.
struct Exit {
  Vec2 normal = Vec2::UnitX();
  double depth = std::numeric_limits<double>::infinity();
  std::ptrdiff_t edge_a = -1, edge_b = -1;
  bool from_a = true;  ///< a's face, and a point of b is the deepest behind it; or the other way round
};

double turnOf(const Vec2& d) { return std::atan2(d.y(), d.x()); }

/// How far the one of some directions, sorted by turnOf(), that leads farthest along the normal does so; at least 0.
double mostAlong(const std::vector<Vec2>& directions, const Vec2& normal) {
  if (directions.empty()) return 0;
  const auto isBefore = [](const Vec2& d, double turn) { return turnOf(d) < turn; };
  const auto next = std::lower_bound(directions.begin(), directions.end(), turnOf(normal), isBefore);
  const Vec2& after = next == directions.end() ? directions.front() : *next;
  const Vec2& before = next == directions.begin() ? directions.back() : *(next - 1);
  return std::max({0.0, before.dot(normal), after.dot(normal)});
}

class ContactFinder {
 public:
  explicit ContactFinder(const PosedPair& pair)
      : pair_(pair),
        frame_(pair),
        crossings_(findCrossings(pair, frame_, Stars::Thinned)),
        towards_b_(-frame_.originOfA()) {}

  /// In the pair's order.
  std::vector<Contact> contacts() const {
    const std::vector<OverlapComponent> components = findComponents(pair_, frame_, crossings_);
    const bool convex =
        !components.empty() && convexityOf(pair_.a).direction != 0 && convexityOf(pair_.b).direction != 0;
    std::vector<Contact> result;
    for (const OverlapComponent& component : components) {
      Exit exit = convex ? byFacesOfBoth(component) : exitOf(component);
      if (!component.inner || !(exit.depth > 0)) exit.depth = 0;
      result.push_back(inWorld(component, exit));
    }
    return result;
  }

 private:
  Exit exitOf(const OverlapComponent& component) const {
    if (component.crossings.empty()) return byNearestEdge(component);
    if (!component.inner) return ofTouch(component);
    const Exit exit = byFacesOfOverlap(component);
    // All of it may be one rounded point.
    return exit.depth < std::numeric_limits<double>::infinity() ? exit : ofTouch(component);
  }

  /// Of ways that are equally deep but for rounding, the one that leads b's origin away from a's.
  void consider(const Exit& exit, Exit& best) const {
    const double error = 4 * frame_.error();
    if (exit.depth < best.depth - error ||
        (exit.depth <= best.depth + error && exit.normal.dot(towards_b_) > best.normal.dot(towards_b_)))
      best = exit;
  }

  /// The edge of one polygon that both points are on; -1 if there is none.
  static std::ptrdiff_t common(std::ptrdiff_t p, std::ptrdiff_t p_before, std::ptrdiff_t q, std::ptrdiff_t q_before) {
    if (p >= 0 && (p == q || p == q_before)) return p;
    if (p_before >= 0 && (p_before == q || p_before == q_before)) return p_before;
    return -1;
  }
  static std::ptrdiff_t commonOfA(const BoundaryPoint& p, const BoundaryPoint& q) {
    return common(p.a, p.a_before, q.a, q.a_before);
  }
  static std::ptrdiff_t commonOfB(const BoundaryPoint& p, const BoundaryPoint& q) {
    return common(p.b, p.b_before, q.b, q.b_before);
  }

  /// Of a point's edges the one that is most across the normal: where a whole edge is deepest, that.
  template <typename EdgeEnds>
  static std::ptrdiff_t flatter(std::ptrdiff_t e, std::ptrdiff_t f, const Vec2& normal, EdgeEnds ends) {
    if (e < 0 || e == f) return e;
    const auto slope = [&](std::ptrdiff_t edge) {
      const WorldFrame::Ends at = ends(static_cast<std::size_t>(edge));
      const Vec2 way = at.w - at.v;
      return way.isZero(0) ? 1 : std::abs(way.stableNormalized().dot(normal));
    };
    return slope(f) < slope(e) ? f : e;
  }
  std::ptrdiff_t flatterOfA(const BoundaryPoint& p, const Vec2& normal) const {
    return flatter(p.a, p.a_before, normal, [this](std::size_t i) { return frame_.edgeEndsOfA(i); });
  }
  std::ptrdiff_t flatterOfB(const BoundaryPoint& p, const Vec2& normal) const {
    return flatter(p.b, p.b_before, normal, [this](std::size_t j) { return frame_.edgeEndsOfB(j); });
  }

  BoundaryPoint vertexOfA(std::size_t v) const {
    return {frame_.fromA(pair_.a.path[v]), static_cast<std::ptrdiff_t>(v),
            static_cast<std::ptrdiff_t>(edgeBefore(pair_.a, v)), -1, -1};
  }
  BoundaryPoint vertexOfB(std::size_t v) const {
    return {frame_.fromB(pair_.b.path[v]), -1, -1, static_cast<std::ptrdiff_t>(v),
            static_cast<std::ptrdiff_t>(edgeBefore(pair_.b, v))};
  }

  /// All of the polygons.
  Hull hullOfA() const {
    std::vector<BoundaryPoint> points;
    for (std::size_t v = 0; v + 1 < pair_.a.path.size(); ++v) points.push_back(vertexOfA(v));
    return hullOf(std::move(points));
  }
  Hull hullOfB() const {
    std::vector<BoundaryPoint> points;
    for (std::size_t v = 0; v + 1 < pair_.b.path.size(); ++v) points.push_back(vertexOfB(v));
    return hullOf(std::move(points));
  }

  /// Two convex regions: the separating axes' least depth, which no translation that parts them is shorter than.
  Exit byFacesOfBoth(const OverlapComponent& component) const {
    Exit best;
    const Hull a = hullOfA(), b = hullOfB();
    forEachFace(a, b, [&](auto& from, auto&, const Vec2& normal, double depth, auto& deepest) {
      consider({normal, depth, flatterOfA(from, normal), flatterOfB(deepest, normal), true}, best);
    });
    forEachFace(b, a, [&](auto& from, auto&, const Vec2& normal, double depth, auto& deepest) {
      consider({-normal, depth, flatterOfA(deepest, normal), flatterOfB(from, normal), false}, best);
    });
    if (component.crossings.empty()) (component.points.front().a < 0 ? best.edge_a : best.edge_b) = -1;
    return best;
  }

  /// As if this part of the overlap and the edges around it were all there is: by the faces of their hulls that are
  /// edges, or by any faces if none is.
  Exit byFacesOfOverlap(const OverlapComponent& component) const {
    std::vector<BoundaryPoint> of_a = component.points, of_b = component.points;
    for (const BoundaryPoint& point : component.points) {
      for (const std::ptrdiff_t edge : {point.a, point.a_before}) {
        if (edge < 0) continue;
        const auto v = static_cast<std::size_t>(edge);
        of_a.insert(of_a.end(), {vertexOfA(v), vertexOfA(edgeAfter(pair_.a, v))});
      }
      for (const std::ptrdiff_t edge : {point.b, point.b_before}) {
        if (edge < 0) continue;
        const auto v = static_cast<std::size_t>(edge);
        of_b.insert(of_b.end(), {vertexOfB(v), vertexOfB(edgeAfter(pair_.b, v))});
      }
    }
    const Hull a = hullOf(std::move(of_a)), b = hullOf(std::move(of_b));
    Exit best, bridging;
    forEachFace(a, b, [&](auto& from, auto& to, const Vec2& normal, double depth, auto& deepest) {
      const std::ptrdiff_t edge = commonOfA(from, to);
      consider({normal, depth, edge, flatterOfB(deepest, normal), true}, edge >= 0 ? best : bridging);
    });
    forEachFace(b, a, [&](auto& from, auto& to, const Vec2& normal, double depth, auto& deepest) {
      const std::ptrdiff_t edge = commonOfB(from, to);
      consider({-normal, depth, flatterOfA(deepest, normal), edge, false}, edge >= 0 ? best : bridging);
    });
    Exit& exit = best.depth < std::numeric_limits<double>::infinity() ? best : bridging;
    // What is deepest may be a vertex of the other polygon.
    if (exit.edge_a < 0 || exit.edge_b < 0) completeEdges(component, exit);
    return exit;
  }

  void completeEdges(const OverlapComponent& component, Exit& exit) const {
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const BoundaryPoint& point : component.points) {
      const double height = exit.normal.dot(point.at);
      if (exit.edge_b < 0 && point.b >= 0 && height < lowest) lowest = height;
      if (exit.edge_a < 0 && point.a >= 0 && height > highest) highest = height;
    }
    const bool needs_a = exit.edge_a < 0, needs_b = exit.edge_b < 0;
    for (const BoundaryPoint& point : component.points) {
      const double height = exit.normal.dot(point.at);
      if (needs_b && point.b >= 0 && height == lowest) exit.edge_b = point.b;
      if (needs_a && point.a >= 0 && height == highest) exit.edge_a = point.a;
    }
  }

  Exit ofTouch(const OverlapComponent& component) const;
  PolygonData ringsOf(const OverlapComponent& component, bool of_b) const;
  Exit byNearestEdge(const OverlapComponent& component) const;
  Vec2 middleOf(const OverlapComponent& component, const Exit& exit) const;
  Contact inWorld(const OverlapComponent& component, const Exit& exit) const;

  const PosedPair& pair_;
  WorldFrame frame_;
  std::vector<EdgeCrossing> crossings_;
  Vec2 towards_b_;
};

/// Where edges touch along a stretch, across these; where there is but a point, of the normals of its edges the one
/// that both polygons' edges keep to their sides of best.
Exit ContactFinder::ofTouch(const OverlapComponent& component) const {
  const double error = frame_.error();
  const auto length = [&](std::size_t k) {
    const EdgeCrossing& c = crossings_[k];
    const WorldFrame::Ends edge = frame_.edgeEndsOfA(c.edge_a);
    return (edge.w - edge.v).norm() * (c.on_a.high - c.on_a.low);
  };
  std::size_t longest = component.crossings.front();
  for (const std::size_t k : component.crossings)
    if (length(k) > length(longest) + error) longest = k;
  const EdgeCrossing& main = crossings_[longest];
  Exit best;
  best.depth = 0;
  best.edge_a = static_cast<std::ptrdiff_t>(main.edge_a);
  best.edge_b = static_cast<std::ptrdiff_t>(main.edge_b);
  if (component.facing.norm() > 8 * error) {
    best.normal = component.facing.normalized();
    return best;
  }

  std::vector<std::size_t> edges_a, edges_b;
  for (const std::size_t k : component.crossings) {
    if ((crossings_[k].point - main.point).norm() > 8 * error) continue;
    edges_a.push_back(crossings_[k].edge_a);
    edges_b.push_back(crossings_[k].edge_b);
  }
  // Where the edges lead from the point: a's on, b's turned back, so that none should go along the normal.
  std::vector<Vec2> directions;
  for (const bool of_a : {true, false}) {
    std::vector<std::size_t>& edges = of_a ? edges_a : edges_b;
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const std::size_t edge : edges) {
      const WorldFrame::Ends ends = of_a ? frame_.edgeEndsOfA(edge) : frame_.edgeEndsOfB(edge);
      for (const Vec2& end : {ends.v, ends.w}) {
        const Vec2 way = of_a ? Vec2(end - main.point) : Vec2(main.point - end);
        if (way.norm() > 8 * error) directions.push_back(way.normalized());
      }
    }
  }
  std::sort(directions.begin(), directions.end(), [](const Vec2& d, const Vec2& e) { return turnOf(d) < turnOf(e); });
  constexpr double kSameAngle = 1e-9;
  best.normal = towards_b_.isZero(0) ? Vec2(Vec2::UnitX()) : Vec2(towards_b_.stableNormalized());
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2& direction : directions) {
    for (const Vec2& normal : {Vec2(direction.y(), -direction.x()), Vec2(-direction.y(), direction.x())}) {
      const double most = mostAlong(directions, normal);
      const bool better = normal.dot(towards_b_) > best.normal.dot(towards_b_);
      if (most > least + kSameAngle || (most >= least - kSameAngle && !better)) continue;
      least = most;
      best.normal = normal;
    }
  }
  return best;
}

/// The rings that a containment is made of, as a polygon of their own.
PolygonData ContactFinder::ringsOf(const OverlapComponent& component, bool of_b) const {
  const PolygonData& polygon = of_b ? pair_.b : pair_.a;
  std::vector<Ring> rings;
  std::size_t last = polygon.ringCount();
  for (const BoundaryPoint& point : component.points) {
    const std::ptrdiff_t edge = of_b ? point.b : point.a;
    if (edge < 0) continue;
    const std::size_t ring = ringOf(polygon, static_cast<std::size_t>(edge));
    if (ring != last) rings.push_back(polygon.rings[ring]);
    last = ring;
  }
  return PolygonData(std::move(rings), polygon.fill);
}

/// In a containment: past the nearest of the outer polygon's edges.
Exit ContactFinder::byNearestEdge(const OverlapComponent& component) const {
  const auto leftmost =
      std::min_element(component.points.begin(), component.points.end(),
                       [](const BoundaryPoint& p, const BoundaryPoint& q) { return p.at.x() < q.at.x(); });
  const bool b_inside = leftmost->b >= 0;
  // Only what is inside is searched from, so that many parts don't cost their number squared.
  const PolygonData inside = ringsOf(component, b_inside), &outside = b_inside ? pair_.a : pair_.b;
  const Pose &pose_inside = b_inside ? pair_.pose_b : pair_.pose_a,
             &pose_outside = b_inside ? pair_.pose_a : pair_.pose_b;
  // Edges of the component's own rings are no way out of it.
  std::unordered_set<std::size_t> own;
  for (const BoundaryPoint& point : component.points) {
    const std::ptrdiff_t edge = b_inside ? point.a : point.b;
    if (edge >= 0) own.insert(static_cast<std::size_t>(edge));
  }
  double nearest = std::numeric_limits<double>::infinity();
  Vec2 in = leftmost->at, out = in;
  Vec2 across = Vec2::UnitX();
  const auto tryPoints = [&](const Vec2& inner, const Vec2& outer, const WorldFrame::Ends& outer_edge) {
    const double distance = (outer - inner).norm();
    if (!(distance < nearest)) return;
    nearest = distance;
    in = inner;
    out = outer;
    const Vec2 way = outer_edge.w - outer_edge.v;
    if (!way.isZero(0)) across = Vec2(way.y(), -way.x()).stableNormalized();
  };
  const auto tryEdges = [&](std::size_t i, std::size_t o) {
    const Vec2 &v = inside.path[i], &w = inside.path[i + 1];
    const WorldFrame::Ends inner = b_inside ? WorldFrame::Ends{frame_.fromB(v), frame_.fromB(w)}
                                            : WorldFrame::Ends{frame_.fromA(v), frame_.fromA(w)},
                           outer = b_inside ? frame_.edgeEndsOfA(o) : frame_.edgeEndsOfB(o);
    for (const Vec2& p : {inner.v, inner.w}) tryPoints(p, nearestOnSegment(p, outer.v, outer.w), outer);
    for (const Vec2& q : {outer.v, outer.w}) tryPoints(nearestOnSegment(q, inner.v, inner.w), q, outer);
  };
  const double far = 4 * std::min(pair_.a.radius + pair_.b.radius, 0x1p1020);
  const auto search = [&](const PosedPair& pair, bool inside_first) {
    forEachPair(pair, far, [&](double, std::size_t i, std::size_t j) {
      if (own.count(inside_first ? j : i) == 0) inside_first ? tryEdges(i, j) : tryEdges(j, i);
      return std::min(far, pair.reach((nearest + frame_.error()) * frame_.unit()));
    });
  };
  if (inside.unit > outside.unit)
    search(PosedPair(inside, pose_inside, outside, pose_outside), true);
  else
    search(PosedPair(outside, pose_outside, inside, pose_inside), false);
  Exit exit;
  Vec2 outwards = across;
  if (nearest > 4 * frame_.error())
    outwards = (out - in).normalized();
  else if (across.dot(out - (b_inside ? Vec2(Vec2::Zero()) : frame_.originOfA())) < 0)
    outwards = -across;
  exit.depth = 0;
  for (const BoundaryPoint& point : component.points) {
    const double depth = outwards.dot(out - point.at);
    if (depth < exit.depth) continue;
    exit.depth = depth;
    exit.edge_a = flatterOfA(point, outwards);
    exit.edge_b = flatterOfB(point, outwards);
  }
  exit.normal = b_inside ? outwards : Vec2(-outwards);
  exit.from_a = b_inside;
  return exit;
}

/// The middle of the overlap along the normal through the deepest point, or through the middle of those.
Vec2 ContactFinder::middleOf(const OverlapComponent& component, const Exit& exit) const {
  // Heights above the end where the deepest points are, towards the other.
  const Vec2 up = exit.from_a ? exit.normal : Vec2(-exit.normal), side(-up.y(), up.x());
  double lowest = std::numeric_limits<double>::infinity(), first = lowest, last = -lowest;
  for (const BoundaryPoint& point : component.points) lowest = std::min(lowest, up.dot(point.at));
  for (const BoundaryPoint& point : component.points) {
    if (up.dot(point.at) > lowest + 4 * frame_.error()) continue;
    first = std::min(first, side.dot(point.at));
    last = std::max(last, side.dot(point.at));
  }
  const double across = 0.5 * first + 0.5 * last;
  double highest = lowest;
  const Hull hull = hullOf(component.points);
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Vec2 &p = hull[k].at, &q = hull[k + 1 < hull.size() ? k + 1 : 0].at;
    const double from = side.dot(p) - across, to = side.dot(q) - across;
    if ((from > 0 && to > 0) || (from < 0 && to < 0)) continue;
    highest = std::max(highest, up.dot(from != to ? Vec2(p + from / (from - to) * (q - p)) : p));
  }
  return (0.5 * lowest + 0.5 * highest) * up + across * side;
}

Contact ContactFinder::inWorld(const OverlapComponent& component, const Exit& exit) const {
  const auto number = [](const PolygonData& polygon, std::ptrdiff_t position) {
    return position < 0 ? position
                        : static_cast<std::ptrdiff_t>(polygon.edgeNumber(static_cast<std::size_t>(position)));
  };
  assert(exit.depth >= 0 && std::abs(exit.normal.norm() - 1) < 0x1p-40);
  return {frame_.toWorld(middleOf(component, exit)), exit.normal, exit.depth * frame_.unit(),
          number(pair_.a, exit.edge_a), number(pair_.b, exit.edge_b)};
}

std::vector<Contact> deepestContacts(const PosedPair& pair, std::size_t most) {
  std::vector<Contact> result = ContactFinder(pair).contacts();
  std::sort(result.begin(), result.end(), [](const Contact& p, const Contact& q) { return p.depth > q.depth; });
  if (result.size() > most) result.erase(result.begin() + static_cast<std::ptrdiff_t>(most), result.end());
  return result;
}

}  // namespace
}  // namespace detail

std::vector<Contact> contacts(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                              std::size_t most) {
  detail::requireRigid(pose_a, "pose_a");
  detail::requireRigid(pose_b, "pose_b");
  return detail::inKernelOrder(
      a.data(), pose_a, b.data(), pose_b,
      [&](const auto&... operands) { return detail::deepestContacts(detail::PosedPair(operands...), most); },
      [](std::vector<Contact>& contacts) {
        for (Contact& contact : contacts) {
          contact.normal = -contact.normal;
          std::swap(contact.edge_a, contact.edge_b);
        }
      });
}

}  // namespace tricover
