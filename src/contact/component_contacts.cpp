// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "contact/component_exit.h"
#include "contact/contact_ends.h"
#include "contact/contact_solvers.h"
#include "numbers/angle.h"
#include "numbers/segment.h"
#include "penetration/penetration.h"

namespace tricover::detail {
namespace {

/// How far a unit vector leads from a point of the boundary, beyond its own edges, to the next edge of either polygon;
/// at most `length`.
double wayToNextEdge(const PosedPair& pair, const WorldFrame& frame, const Vec2& from, const Vec2& way, double length) {
  const double error = 8 * frame.error();
  for (const int side : {0, 1})
    forEachEdgeOnRay(pair, frame, side, from, way, length, [&](EdgePosition edge) {
      const auto [v, w] = frame.edgeEnds(side, edge);
      const double over_v = cross(way, v - from), over_w = cross(way, w - from);
      if ((over_v > error && over_w > error) || (over_v < -error && over_w < -error)) return length;
      const double at_v = way.dot(v - from), at_w = way.dot(w - from);
      // Where the edge runs along the way, that is met at its nearer end; one that the way begins on, where it ends.
      const bool across = std::abs(over_v - over_w) > error;
      const double t = across ? std::clamp(over_v / (over_v - over_w), 0.0, 1.0) : at_v < at_w ? 0 : 1;
      const double at = across || std::min(at_v, at_w) > error ? at_v + t * (at_w - at_v) : std::max(at_v, at_w);
      if (at > error) length = std::min(length, at);
      return length;
    });
  return length;
}

/// Where a component is deepest along a unit vector `up`, in the WorldFrame.
struct Middle {
  Vec2 deepest;  ///< its lowest point
  Vec2 middle;   ///< of what its hull has of the line along `up` through the deepest point, or the middle of those
};

/// By its hull. What is less than `error` apart counts as equally deep.
Middle middleOf(const Hull& hull, const Vec2& up, double error) {
  const Vec2 side(-up.y(), up.x());
  double lowest = std::numeric_limits<double>::infinity(), first = lowest, last = -lowest;
  Vec2 deepest = Vec2::Zero();
  for (const BoundaryPoint& p : hull) {
    const double height = up.dot(p.at);
    if (height < lowest) deepest = p.at;
    lowest = std::min(lowest, height);
  }
  for (const BoundaryPoint& p : hull) {
    if (up.dot(p.at) > lowest + error) continue;
    first = std::min(first, side.dot(p.at));
    last = std::max(last, side.dot(p.at));
  }
  const double across = 0.5 * first + 0.5 * last;
  double highest = lowest;
  const Vec2* p = &hull.back().at;
  double from = side.dot(*p) - across;
  for (const BoundaryPoint& corner : hull) {
    const Vec2& q = corner.at;
    const double to = side.dot(q) - across;
    if (!(from > 0 && to > 0) && !(from < 0 && to < 0))
      highest = std::max(highest, up.dot(from != to ? Vec2(*p + from / (from - to) * (q - *p)) : *p));
    p = &q;
    from = to;
  }
  return {deepest, (0.5 * lowest + 0.5 * highest) * up + across * side};
}

/// A point of a component that has an interior: its middle, if no edge is between that and the deepest point. Or else
/// the middle of what the component has of the line from `deepest` along the unit vector `up`; or else `deepest`.
Vec2 pointInside(const PosedPair& pair, const WorldFrame& frame, const Middle& expected, const Vec2& up) {
  const auto& [deepest, wanted] = expected;
  const double error = 8 * frame.error();
  const auto isCommon = [&](const Vec2& p) { return holds(pair, frame, 0, p) && holds(pair, frame, 1, p); };
  const Vec2 way = wanted - deepest;
  const double length = way.norm();
  if (!(length > error)) return wanted;
  // `wanted` itself may be on an edge of another component, or behind one by rounding.
  const double free = wayToNextEdge(pair, frame, deepest, way / length, length);
  if (isCommon(deepest + 0.5 * way) && !(free < length - error))
    return free < length ? Vec2(deepest + (free / length) * way) : wanted;
  const double chord = wayToNextEdge(pair, frame, deepest, up, 0x1p1000);
  const Vec2 middle = deepest + 0.5 * chord * up;
  return chord < 0x1p1000 && isCommon(middle) ? middle : deepest;
}

/// Translations times vertices that a contact may cost: a translation asks each edge that is near, in the worst case
/// all. Up to some 200 vertices that is all that a penetration may try; with less than the least nothing would be
/// found.
constexpr std::size_t kMostWork = std::size_t{1} << 22, kLeastTranslations = std::size_t{1} << 10;

class ContactFinder {
 public:
  ContactFinder(const PosedPair& pair, const SeparatingAxes* axes, const ContactOptions& options)
      : pair_(pair),
        axes_(axes),
        margin_(options.margin),
        detail_(options.detail),
        frame_(pair),
        leaves_touches_(options.touching == Touching::Allowed && options.margin == 0),
        crossings_(findCrossings(pair, frame_)),
        exits_(pair, frame_, crossings_) {}

  /// In the pair's order.
  std::vector<Contact> contacts() {
    const bool wants_all = axes_ != nullptr || leaves_touches_;
    std::vector<OverlapComponent> components =
        findComponents(pair_, frame_, crossings_, wants_all ? ContactDetail::GlobalDepth : detail_);
    if (leaves_touches_) leaveTouches(components);
    std::vector<Contact> result;
    result.reserve(components.size());
    for (const OverlapComponent& component : components) {
      if (detail_ == ContactDetail::Points && axes_ == nullptr) {
        result.push_back(anyPointOf(component));
        continue;
      }
      const Hull& hull = exits_.hullOf(component);
      Exit exit = axes_ != nullptr ? exits_.exitOfConvex(component, *axes_) : exits_.exitOf(component);
      const double margin = margin_ / frame_.unit();
      exit.depth += margin;
      if (detail_ == ContactDetail::GlobalDepth && axes_ == nullptr && components.size() == 1)
        exit = exitOfOnly(component, exit);
      // The depth of convex regions is known better than whether there is an inside.
      const bool touches = !component.inner && !(axes_ != nullptr && exit.depth > margin + frame_.error());
      if (touches || !(exit.depth > margin)) exit.depth = margin;
      assert(exit.depth >= 0 && std::abs(exit.normal.norm() - 1) < 0x1p-40);
      const Vec2 point = pointOf(component, hull, exit);
      result.push_back(contactOf(point, exit));
      if (exit.edges[0] != kNoEdge && exit.edges[1] != kNoEdge) addEnds(result.back(), point, exit, hull);
    }
    return result;
  }

 private:
  /// Whether b, led along the normal by a little more than the depth, leaves a: by as much as coordinates are off by,
  /// and by a quarter of that, which details that are as small may be between.
  bool parts(double depth, const Vec2& normal) const {
    // By so much the pose's translation is known: near a corner a shorter way may be free where a longer one isn't.
    const double spacing = 1024 * kUnitRoundoff * (pair_.pose_b.translation() / frame_.unit()).lpNorm<1>();
    const double more = 16 * frame_.error() + spacing + 1e-9 * std::min(pair_.a.radius, pair_.b.radius) / frame_.unit();
    const auto partsBy = [&](double length) {
      return areApartMoved(pair_, Vec2::Zero(), length * frame_.unit() * normal, margin_);
    };
    return partsBy(depth + more) && partsBy(depth + 0.25 * more);
  }

  /// The same for directions near the normal: it doesn't just slide along a wall.
  bool partsFreely(const Exit& exit) const {
    const Vec2 &normal = exit.normal, aside = 0x1p-10 * Vec2(-normal.y(), normal.x());
    return parts(exit.depth, normal) && parts(exit.depth, normal + aside) && parts(exit.depth, normal - aside);
  }

  /// Leaves out the components that no point of is in the interior of either region.
  void leaveTouches(std::vector<OverlapComponent>& components) const {
    InnerCrossings inner(pair_, crossings_);
    const auto isTouch = [&](const OverlapComponent& component) {
      for (const std::size_t k : component.crossings)
        if (inner.meetAt(crossings_[k])) return false;
      // One region within the other, or led to its interior by edges that have none.
      return std::none_of(component.points.begin(), component.points.end(),
                          [&](const BoundaryPoint& p) { return inner.meetBeside(p); });
    };
    components.erase(std::remove_if(components.begin(), components.end(), isTouch), components.end());
  }

  /// The exit of a component that is the only one, where it is a touch. The shortest way is searched if it isn't known.
  Exit exitOfTouch(const Exit& exit, std::optional<Penetration> way) const {
    if (partsFreely(exit)) return exit;
    Exit result = exit;
    result.normal = freed(exit);
    if (parts(result.depth, result.normal)) return result;
    // They are wedged, or a corner reaches through by more than coordinates are off by.
    if (!way) way = shortestWay();
    if (way && way->optimal) result.normal = way->translation.stableNormalized();
    return result;
  }

  /// Nothing where so few translations may be tried that none would be found.
  std::optional<Penetration> shortestWay() const {
    const std::size_t most = std::min(kMostTranslations, kMostWork / (pair_.a.path.size() + pair_.b.path.size()));
    if (most < kLeastTranslations) return {};
    return penetrationInOrder(pair_.a, pair_.pose_a, pair_.b, pair_.pose_b, margin_, most);
  }

  /// The only component of the overlap, which has an exit of its own: the shortest way out of it parts the regions.
  Exit exitOfOnly(const OverlapComponent& component, Exit exit) const {
    if (!component.inner) return exitOfTouch(exit, {});
    const std::optional<Penetration> way = shortestWay();
    if (!way || !way->optimal) return exit;
    const Penetration& p = *way;
    const double depth = p.depth / frame_.unit();
    const double least = p.lower_bound / frame_.unit(), error = 4 * frame_.error();
    const bool agrees = least - error <= exit.depth && exit.depth <= depth + error;
    const bool alike = agrees && exit.normal.dot(p.normal) >= 1 - 0x1p-20;
    if (agrees && !alike && partsFreely(exit)) return exit;
    // An exit that agrees with the search to its precision is known better.
    if (!alike || !parts(exit.depth, exit.normal)) exit = {p.normal, depth};
    // Either edge at a vertex that parts last will do.
    const auto partsLast = [&](int side, EdgePosition position) {
      const WorldFrame::Ends edge = frame_.edgeEnds(side, position);
      const Vec2 at = frame_.fromWorld(side == 0 ? p.point_a : p.point_b);
      return (nearestOnSegment(at, edge.v, edge.w) - at).norm() <= 64 * frame_.error();
    };
    for (const int side : {0, 1}) {
      EdgePosition& edge = exit.edges[side];
      if (edge != kNoEdge && partsLast(side, edge)) continue;
      edge = polygonOf(pair_, side).edgePosition(side == 0 ? p.edge_a : p.edge_b);
    }
    if (component.crossings.empty()) exit.edges[leftmostOf(component).edge[1] != kNoEdge ? 0 : 1] = kNoEdge;
    return depth > 64 * frame_.error() ? exit : exitOfTouch(exit, way);
  }

  /// The middle of the widest range of directions that part them, if there is one, for a touch whose normal leads into
  /// or along a wall.
  Vec2 freed(const Exit& exit) const {
    constexpr int kDirections = 64;
    const auto at = [](double k) {
      return Vec2(std::cos(k * 2 * kPi / kDirections), std::sin(k * 2 * kPi / kDirections));
    };
    int free_for = 0, longest = 0, end = 0;
    for (int k = 0; k < 2 * kDirections && longest < kDirections; ++k) {
      free_for = parts(exit.depth, at(k)) ? free_for + 1 : 0;
      if (free_for <= longest) continue;
      longest = free_for;
      end = k;
    }
    return longest > 0 ? at(end - 0.5 * (longest - 1)) : exit.normal;
  }

  /// The component's crossing of the first edges, or else its first vertex.
  Contact anyPointOf(const OverlapComponent& component) const {
    const auto isFirst = [&](std::size_t k, std::size_t l) {
      const EdgeCrossing &c = crossings_[k], &d = crossings_[l];
      return std::tie(c.edge[0], c.edge[1]) < std::tie(d.edge[0], d.edge[1]);
    };
    const auto first = std::min_element(component.crossings.begin(), component.crossings.end(), isFirst);
    Exit none{Vec2::Zero(), 0};
    if (first == component.crossings.end()) {
      const BoundaryPoint& vertex = component.points.front();
      std::copy(vertex.edge, vertex.edge + 2, none.edges);
      return contactOf(vertex.at, none);
    }
    const EdgeCrossing& c = crossings_[*first];
    for (const int side : {0, 1}) none.edges[side] = c.edge[side];
    return contactOf(c.point, none);
  }

  /// The middle of the overlap along the normal through the deepest point, or through the middle of those, where that
  /// is in it.
  Vec2 pointOf(const OverlapComponent& component, const Hull& hull, const Exit& exit) const {
    // Heights above the end where the deepest points are, towards the other.
    const Vec2 up = exit.face == 0 ? exit.normal : Vec2(-exit.normal);
    const Middle expected = middleOf(hull, up, 4 * frame_.error());
    if (axes_ != nullptr) return expected.middle;
    return component.inner ? pointInside(pair_, frame_, expected, up) : pointOfTouch(component, expected.middle);
  }

  /// The middle, if it is on a common stretch of two edges; otherwise that of the longest one.
  Vec2 pointOfTouch(const OverlapComponent& component, const Vec2& middle) const {
    for (const std::size_t k : component.crossings) {
      const EdgeCrossing& c = crossings_[k];
      const Vec2 from = frame_.edgeOfA(c.edge[0], c.on[0].low), to = frame_.edgeOfA(c.edge[0], c.on[0].high);
      if ((nearestOnSegment(middle, from, to) - middle).norm() <= 4 * frame_.error()) return middle;
    }
    return crossings_[longestStretch(frame_, crossings_, component)].point;
  }

  Contact contactOf(const Vec2& point, const Exit& exit) const {
    return contactAt(frame_.toWorld(point), exit.normal, exit.depth * frame_.unit(), pair_.a.edgeName(exit.edges[0]),
                     pair_.b.edgeName(exit.edges[1]));
  }

  /// On the component, whose hull tells how far its edges matter.
  void addEnds(Contact& contact, const Vec2& point, const Exit& exit, const Hull& hull) const {
    Extent extent{Vec2(-exit.normal.y(), exit.normal.x())};
    const auto isBefore = [&](const BoundaryPoint& p, const BoundaryPoint& q) {
      return extent.along.dot(p.at) < extent.along.dot(q.at);
    };
    const auto [first, last] = std::minmax_element(hull.begin(), hull.end(), isBefore);
    extent.low = extent.along.dot(first->at);
    extent.high = extent.along.dot(last->at);
    const auto pieceOf = [&](int side) { return straightPiece(pair_, frame_, side, exit.edges[side], extent); };
    detail::addEnds(contact, frame_, pieceOf(0), pieceOf(1), point, margin_);
  }

  const PosedPair& pair_;
  const SeparatingAxes* axes_;
  const double margin_;  ///< world length
  const ContactDetail detail_;
  const WorldFrame frame_;
  const bool leaves_touches_;
  const std::vector<EdgeCrossing> crossings_;
  ComponentExits exits_;
};

}  // namespace

std::vector<Contact> componentContacts(const PosedPair& pair, const SeparatingAxes* axes,
                                       const ContactOptions& options) {
  return ContactFinder(pair, axes, options).contacts();
}

}  // namespace tricover::detail
