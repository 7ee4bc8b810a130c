// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/contacts.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <unordered_set>
#include <utility>

#include "contact/contact_point.h"
#include "contact/convex_contact.h"
#include "contact/convex_outline.h"
#include "contact/hull_faces.h"
#include "contact/overlap_components.h"
#include "contact/part_middle.h"
#include "contact/penetration.h"
#include "contact/touch_normal.h"
#include "numbers/rigidity.h"
#include "numbers/segment.h"
#include "pair/collide_by_hierarchy.h"
#include "pair/discs.h"
#include "pair/edge_pairs.h"
#include "pair/facts.h"
#include "pair/kernel_order.h"
#include "pair/pair_fact.h"
#include "polygon/cache_access.h"

namespace tricover {
namespace detail {
namespace {

/// A contact in the WorldFrame, edges by position.
struct Exit {
  Vec2 normal = Vec2::UnitX();
  double depth = std::numeric_limits<double>::infinity();
  std::ptrdiff_t edge_a = -1, edge_b = -1;
  bool from_a = true;      ///< a's face, and a point of b is the deepest behind it; or the other way round
  bool separates = false;  ///< see TouchNormal
};

constexpr double kTurn = 2 * 3.14159265358979323846;

/// Of a containment it is a vertex of what is inside.
const BoundaryPoint& leftmostOf(const OverlapComponent& component) {
  return *std::min_element(component.points.begin(), component.points.end(),
                           [](const BoundaryPoint& p, const BoundaryPoint& q) { return p.at.x() < q.at.x(); });
}

bool isConvex(const PolygonData& polygon) {
  const ConvexOutline& outline = convexOutlineOf(polygon);
  return outline.is_region && outline.corners.size() > 2;
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
    const bool convex = !components.empty() && isConvex(pair_.a) && isConvex(pair_.b);
    std::vector<Contact> result;
    for (const OverlapComponent& component : components) {
      Exit exit = convex                   ? byFacesOfBoth(component)
                  : components.size() == 1 ? exitOfOnly(component)
                                           : exitOf(component);
      if (!component.inner || !(exit.depth > 0)) exit.depth = 0;
      result.push_back(inWorld(exit, pointOf(component, exit, convex)));
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

  /// Whether b, led along the normal by a little more than the depth, leaves a.
  bool parts(const Exit& exit) const {
    const double more = 64 * frame_.error() + 1e-9 * std::min(pair_.a.radius, pair_.b.radius) / frame_.unit();
    Pose moved = pair_.pose_b;
    moved.translation() += (exit.depth + more) * frame_.unit() * exit.normal;
    return !collideByHierarchy(PosedPair(pair_.a, pair_.pose_a, pair_.b, moved), {}, 0, Wanted::Answer).collides;
  }

  /// The same for directions near the normal: it doesn't just slide along a wall.
  bool partsFreely(const Exit& exit) const {
    const Vec2 aside = 0x1p-10 * Vec2(-exit.normal.y(), exit.normal.x());
    const auto turned = [&](const Vec2& by) {
      Exit result = exit;
      result.normal += by;
      return result;
    };
    return parts(exit) && parts(turned(aside)) && parts(turned(-aside));
  }

  Exit exitOfOnly(const OverlapComponent& component) const;
  Exit freed(const Exit& exit) const;

  /// Of ways that are equally deep but for rounding, the one that leads b's origin away from a's. Whether it is the
  /// best so far.
  bool consider(const Exit& exit, Exit& best) const {
    const double error = 4 * frame_.error();
    const bool better = exit.depth < best.depth - error ||
                        (exit.depth <= best.depth + error && exit.normal.dot(towards_b_) > best.normal.dot(towards_b_));
    if (better) best = exit;
    return better;
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

  /// The edge between two corners of a convex polygon; of several, which straight vertices divide, that nearest to p.
  std::ptrdiff_t edgeOfFace(bool of_a, const BoundaryPoint& from, const BoundaryPoint& to, const Vec2& p) const {
    const std::ptrdiff_t common = of_a ? commonOfA(from, to) : commonOfB(from, to);
    if (common >= 0) return common;
    const PolygonData& polygon = of_a ? pair_.a : pair_.b;
    const auto endsOf = [&](std::size_t e) { return of_a ? frame_.edgeEndsOfA(e) : frame_.edgeEndsOfB(e); };
    const std::ptrdiff_t first = of_a ? from.a : from.b, last = of_a ? to.a : to.b;
    const WorldFrame::Ends ahead = endsOf(static_cast<std::size_t>(first));
    const bool forward = (ahead.w - ahead.v).dot(to.at - from.at) > 0;
    // In the ring's direction from one corner's own edge to the other's.
    const auto end = static_cast<std::size_t>(forward ? last : first);
    std::ptrdiff_t nearest = forward ? first : last;
    double least = std::numeric_limits<double>::infinity();
    for (auto e = static_cast<std::size_t>(nearest); e != end; e = edgeAfter(polygon, e)) {
      const auto [v, w] = endsOf(e);
      const double square = squaredDistanceToSegment(p, v, w);
      if (square < least) nearest = static_cast<std::ptrdiff_t>(e);
      least = std::min(square, least);
    }
    return nearest;
  }

  BoundaryPoint vertexOfA(std::size_t v) const { return vertexPoint(pair_.a, 0, v, frame_.fromA(pair_.a.path[v])); }
  BoundaryPoint vertexOfB(std::size_t v) const { return vertexPoint(pair_.b, 1, v, frame_.fromB(pair_.b.path[v])); }

  /// All of a convex polygon.
  Hull hullOfA() const {
    std::vector<BoundaryPoint> points;
    points.reserve(pair_.a.path.size());
    for (std::size_t v = 0; v + 1 < pair_.a.path.size(); ++v)
      if (pair_.a.path[v] != pair_.a.path[v + 1]) points.push_back(vertexOfA(v));
    return hullOf(std::move(points));
  }
  Hull hullOfB() const {
    std::vector<BoundaryPoint> points;
    points.reserve(pair_.b.path.size());
    for (std::size_t v = 0; v + 1 < pair_.b.path.size(); ++v)
      if (pair_.b.path[v] != pair_.b.path[v + 1]) points.push_back(vertexOfB(v));
    return hullOf(std::move(points));
  }

  /// Two convex regions: the separating axes' least depth, which no translation that parts them is shorter than.
  Exit byFacesOfBoth(const OverlapComponent& component) const {
    Exit best;
    const BoundaryPoint *from = nullptr, *to = nullptr, *deepest = nullptr;
    const auto tryFaceOf = [&](bool of_a) {
      return [&, of_a](const BoundaryPoint& p, const BoundaryPoint& q, const Vec2& normal, double depth,
                       const BoundaryPoint& behind) {
        if (!consider({of_a ? normal : Vec2(-normal), depth, -1, -1, of_a}, best)) return;
        from = &p;
        to = &q;
        deepest = &behind;
      };
    };
    const Hull a = hullOfA(), b = hullOfB();
    forEachFace(a, b, tryFaceOf(true));
    forEachFace(b, a, tryFaceOf(false));
    if (deepest != nullptr) {
      best.edge_a = best.from_a ? edgeOfFace(true, *from, *to, deepest->at) : flatterOfA(*deepest, best.normal);
      best.edge_b = best.from_a ? flatterOfB(*deepest, best.normal) : edgeOfFace(false, *from, *to, deepest->at);
    }
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
  Vec2 pointOf(const OverlapComponent& component, const Exit& exit, bool convex) const;
  Vec2 pointOfTouch(const OverlapComponent& component, const Vec2& middle) const;
  Contact inWorld(const Exit& exit, const Vec2& point) const;

  const PosedPair& pair_;
  WorldFrame frame_;
  std::vector<EdgeCrossing> crossings_;
  Vec2 towards_b_;
};

Exit ContactFinder::ofTouch(const OverlapComponent& component) const {
  const EdgeCrossing& main = crossings_[longestStretch(frame_, crossings_, component)];
  const TouchNormal touch = touchNormal(frame_, crossings_, component, main, towards_b_);
  Exit exit{touch.normal, 0, static_cast<std::ptrdiff_t>(main.edge_a), static_cast<std::ptrdiff_t>(main.edge_b), true};
  exit.separates = touch.separates;
  return exit;
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
  const BoundaryPoint& leftmost = leftmostOf(component);
  const bool b_inside = leftmost.b >= 0;
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
  Vec2 in = leftmost.at, out = in;
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

/// Translations times vertices that a contact may cost: a translation asks each edge that is near, in the worst case
/// all. Up to some 200 vertices that is all of a penetration's budget; with less than the least nothing would be found.
constexpr std::size_t kMostWork = std::size_t{1} << 22, kLeastBudget = std::size_t{1} << 10;

/// The only part of the overlap: the shortest way out of it parts the regions.
Exit ContactFinder::exitOfOnly(const OverlapComponent& component) const {
  Exit exit = exitOf(component);
  if (!component.inner) return exit.separates || partsFreely(exit) ? exit : freed(exit);
  PenetrationOptions options;
  options.budget = std::min(options.budget, kMostWork / (pair_.a.path.size() + pair_.b.path.size()));
  if (options.budget < kLeastBudget) return exit;
  const Penetration p = penetrationInOrder(pair_.a, pair_.pose_a, pair_.b, pair_.pose_b, options);
  if (!p.optimal) return exit;
  const double depth = p.depth / frame_.unit(), radius = std::min(pair_.a.radius, pair_.b.radius) / frame_.unit();
  const bool agrees = std::abs(depth - exit.depth) <= 1e-12 * radius + 64 * frame_.error();
  const bool alike = agrees && exit.normal.dot(p.direction) >= 1 - 0x1p-20;
  if (agrees && !alike && partsFreely(exit)) return exit;
  // What agrees with it to its precision is known better.
  if (!alike) exit = {p.direction, depth, -1, -1, true};
  // Of the edges at a vertex that parts last either will do.
  const auto partsLast = [&](const WorldFrame::Ends& edge, const Vec2& point) {
    const Vec2 at = frame_.fromWorld(point);
    return (nearestOnSegment(at, edge.v, edge.w) - at).norm() <= 64 * frame_.error();
  };
  const auto positionOf = [](const PolygonData& polygon, std::ptrdiff_t number) {
    return static_cast<std::ptrdiff_t>(polygon.edgePosition(static_cast<std::size_t>(number)));
  };
  if (exit.edge_a < 0 || !partsLast(frame_.edgeEndsOfA(static_cast<std::size_t>(exit.edge_a)), p.point_a))
    exit.edge_a = positionOf(pair_.a, p.edge_a);
  if (exit.edge_b < 0 || !partsLast(frame_.edgeEndsOfB(static_cast<std::size_t>(exit.edge_b)), p.point_b))
    exit.edge_b = positionOf(pair_.b, p.edge_b);
  if (component.crossings.empty()) (leftmostOf(component).b >= 0 ? exit.edge_a : exit.edge_b) = -1;
  return depth > 64 * frame_.error() || partsFreely(exit) ? exit : freed(exit);
}

/// A touch whose normal leads into or along a wall: the middle of the widest range of directions that part them, if
/// there is one.
Exit ContactFinder::freed(const Exit& exit) const {
  constexpr int kDirections = 64;
  const auto at = [&](double k) {
    Exit result = exit;
    result.normal = Vec2(std::cos(k * kTurn / kDirections), std::sin(k * kTurn / kDirections));
    return result;
  };
  int free_for = 0, longest = 0, end = 0;
  for (int k = 0; k < 2 * kDirections && longest < kDirections; ++k) {
    free_for = parts(at(k)) ? free_for + 1 : 0;
    if (free_for <= longest) continue;
    longest = free_for;
    end = k;
  }
  return longest > 0 ? at(end - 0.5 * (longest - 1)) : exit;
}

/// The middle of the overlap along the normal through the deepest point, or through the middle of those, where that is
/// in it.
Vec2 ContactFinder::pointOf(const OverlapComponent& component, const Exit& exit, bool convex) const {
  struct Places {
    std::size_t size() const { return points.size(); }
    const Vec2& operator[](std::size_t k) const { return points[k].at; }
    const std::vector<BoundaryPoint>& points;
  };
  // Heights above the end where the deepest points are, towards the other.
  const Vec2 up = exit.from_a ? exit.normal : Vec2(-exit.normal);
  const Hull hull = hullOf(component.points);
  const auto [deepest, middle] = partMiddle(Places{component.points}, Places{hull}, up, 4 * frame_.error());
  if (convex) return middle;
  return component.inner ? pointOfPart(pair_, frame_, deepest, up, middle) : pointOfTouch(component, middle);
}

/// The middle, if it is on a common stretch of two edges; otherwise that of the longest one.
Vec2 ContactFinder::pointOfTouch(const OverlapComponent& component, const Vec2& middle) const {
  for (const std::size_t k : component.crossings) {
    const EdgeCrossing& c = crossings_[k];
    const Vec2 from = frame_.edgeOfA(c.edge_a, c.on_a.low), to = frame_.edgeOfA(c.edge_a, c.on_a.high);
    if ((nearestOnSegment(middle, from, to) - middle).norm() <= 4 * frame_.error()) return middle;
  }
  return crossings_[longestStretch(frame_, crossings_, component)].point;
}

Contact ContactFinder::inWorld(const Exit& exit, const Vec2& point) const {
  const auto number = [](const PolygonData& polygon, std::ptrdiff_t position) {
    return position < 0 ? position
                        : static_cast<std::ptrdiff_t>(polygon.edgeNumber(static_cast<std::size_t>(position)));
  };
  assert(exit.depth >= 0 && std::abs(exit.normal.norm() - 1) < 0x1p-40);
  return {frame_.toWorld(point), exit.normal, exit.depth * frame_.unit(), number(pair_.a, exit.edge_a),
          number(pair_.b, exit.edge_b)};
}

std::vector<Contact> allContacts(const PosedPair& pair, PairFacts* cache) {
  if (gapOfDiscs(Placement(pair.a, pair.pose_a, pair.b, pair.pose_b), 0) >= 0) return {};
  const ConvexContact convex = convexContact(pair, cache != nullptr ? &cache->contact : nullptr);
  if (convex.verdict == ConvexContact::Overlap) return {convex.contact};
  return convex.verdict == ConvexContact::Apart ? std::vector<Contact>() : ContactFinder(pair).contacts();
}

std::vector<Contact> deepestContacts(const PosedPair& pair, PairFacts* cache, std::size_t most) {
  Recollection known{};
  if (cache != nullptr && cache->contact.count == 0)
    known = recall(cache->collision, pair.a, pair.pose_a, pair.b, pair.pose_b, 0);
  if (known.certain && !known.collides) return {};
  std::vector<Contact> result = allContacts(pair, cache);
  if (cache != nullptr && result.empty()) {
    PairFact fact{};  // after a jump another may follow: then only the poses are of use
    if (known.coherent) fact = findFact(pair.a, pair.pose_a, pair.b, pair.pose_b, {}, {known.lookahead, true});
    remember(cache->collision, pair.a, pair.pose_a, pair.b, pair.pose_b, false, fact.clearance);
  }
  std::sort(result.begin(), result.end(), [](const Contact& p, const Contact& q) { return p.depth > q.depth; });
  if (result.size() > most) result.erase(result.begin() + static_cast<std::ptrdiff_t>(most), result.end());
  return result;
}

std::vector<Contact> contacts(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                              PairFacts* cache, std::size_t most) {
  requireRigid(pose_a, "pose_a");
  requireRigid(pose_b, "pose_b");
  return inKernelOrder(
      a.data(), pose_a, b.data(), pose_b,
      [&](const auto&... operands) { return deepestContacts(PosedPair(operands...), cache, most); },
      [](std::vector<Contact>& contacts) {
        for (Contact& contact : contacts) {
          contact.normal = -contact.normal;
          std::swap(contact.edge_a, contact.edge_b);
        }
      });
}

}  // namespace
}  // namespace detail

std::vector<Contact> contacts(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                              std::size_t most) {
  return detail::contacts(a, pose_a, b, pose_b, nullptr, most);
}

std::vector<Contact> contacts(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                              PairCache& cache, std::size_t most) {
  return detail::contacts(a, pose_a, b, pose_b, &detail::factsIn(cache), most);
}

}  // namespace tricover
