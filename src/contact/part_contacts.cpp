// SPDX-License-Identifier: BSD-3-Clause
#include "contact/part_contacts.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "contact/contact_ends.h"
#include "contact/contact_point.h"
#include "contact/inner_crossings.h"
#include "contact/part_exit.h"
#include "contact/penetration.h"
#include "contact/touch_normal.h"
#include "numbers/angle.h"
#include "numbers/segment.h"

namespace tricover::detail {
namespace {

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
      const Hull& part = exits_.hullOf(component);
      Exit exit = axes_ != nullptr ? exits_.exitOfConvex(component, *axes_) : exits_.exitOf(component);
      const double margin = margin_ / frame_.unit();
      exit.depth += margin;
      if (detail_ == ContactDetail::GlobalDepth && axes_ == nullptr && components.size() == 1)
        exit = exitOfOnly(component, exit);
      // Of convex regions the depth is known better than whether there is an inside.
      const bool touches = !component.inner && !(axes_ != nullptr && exit.depth > margin + frame_.error());
      if (touches || !(exit.depth > margin)) exit.depth = margin;
      assert(exit.depth >= 0 && std::abs(exit.normal.norm() - 1) < 0x1p-40);
      const Vec2 point = pointOf(component, part, exit);
      result.push_back(contactOf(point, exit.normal, exit.depth, exit.edge_a, exit.edge_b));
      if (exit.edge_a >= 0 && exit.edge_b >= 0) addEnds(result.back(), point, exit, part);
    }
    return result;
  }

 private:
  /// Whether b, led along the normal by a little more than the depth, leaves a: by as much as coordinates are off by,
  /// and by a quarter of that, which details that are as small may be between.
  bool parts(const Exit& exit) const {
    // By so much the pose's translation is known: near a corner a shorter way may be free where a longer one isn't.
    const double spacing = 256 * kUnitRoundoff * (pair_.pose_b.translation() / frame_.unit()).lpNorm<1>();
    const double more = 16 * frame_.error() + spacing + 1e-9 * std::min(pair_.a.radius, pair_.b.radius) / frame_.unit();
    const auto partsBy = [&](double length) {
      return areApartMoved(pair_.a, pair_.pose_a, Vec2::Zero(), pair_.b, pair_.pose_b,
                           length * frame_.unit() * exit.normal, margin_);
    };
    return partsBy(exit.depth + more) && partsBy(exit.depth + 0.25 * more);
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

  void leaveTouches(std::vector<OverlapComponent>& components) const;
  Exit exitOfOnly(const OverlapComponent& component, Exit exit) const;
  Exit exitOfTouch(const Exit& exit, std::optional<Penetration> way) const;
  std::optional<Penetration> shortestWay() const;
  Exit freed(const Exit& exit) const;
  Contact anyPointOf(const OverlapComponent& component) const;
  Vec2 pointOf(const OverlapComponent& component, const Hull& hull, const Exit& exit) const;
  Vec2 pointOfTouch(const OverlapComponent& component, const Vec2& middle) const;
  /// In the world, edges by number.
  Contact contactOf(const Vec2& point, const Vec2& normal, double depth, std::ptrdiff_t edge_a,
                    std::ptrdiff_t edge_b) const;
  void addEnds(Contact& contact, const Vec2& point, const Exit& exit, const Hull& part) const;

  const PosedPair& pair_;
  const SeparatingAxes* axes_;
  const double margin_;  ///< world length
  const ContactDetail detail_;
  const WorldFrame frame_;
  const bool leaves_touches_;
  const std::vector<EdgeCrossing> crossings_;
  PartExits exits_;
};

/// Translations times vertices that a contact may cost: a translation asks each edge that is near, in the worst case
/// all. Up to some 200 vertices that is all that a penetration may try; with less than the least nothing would be
/// found.
constexpr std::size_t kMostWork = std::size_t{1} << 22, kLeastTranslations = std::size_t{1} << 10;

/// Leaves out the components that have no interior.
void ContactFinder::leaveTouches(std::vector<OverlapComponent>& components) const {
  InnerCrossings inner(pair_, crossings_);
  const auto isTouch = [&](const OverlapComponent& component) {
    for (const std::size_t k : component.crossings)
      if (inner.has(crossings_[k].edge_a, crossings_[k].edge_b)) return false;
    // One region within the other, or led to its interior by edges that have none.
    return std::none_of(component.points.begin(), component.points.end(),
                        [&](const BoundaryPoint& p) { return inner.hasBeside(p); });
  };
  components.erase(std::remove_if(components.begin(), components.end(), isTouch), components.end());
}

/// The exit of a component that is the only one, where it is a touch. The shortest way is searched if it isn't known.
Exit ContactFinder::exitOfTouch(const Exit& exit, std::optional<Penetration> way) const {
  if (partsFreely(exit)) return exit;
  Exit result = freed(exit);
  if (parts(result)) return result;
  // They are wedged, or a corner reaches through by more than coordinates are off by.
  if (!way) way = shortestWay();
  if (way && way->optimal) result.normal = way->translation.stableNormalized();
  return result;
}

/// Nothing where so few translations may be tried that none would be found.
std::optional<Penetration> ContactFinder::shortestWay() const {
  const std::size_t most = std::min(kMostTranslations, kMostWork / (pair_.a.path.size() + pair_.b.path.size()));
  if (most < kLeastTranslations) return {};
  return penetrationInOrder(pair_.a, pair_.pose_a, pair_.b, pair_.pose_b, margin_, most);
}

/// The only part of the overlap, which has an exit of its own: the shortest way out of it parts the regions.
Exit ContactFinder::exitOfOnly(const OverlapComponent& component, Exit exit) const {
  if (!component.inner) return exitOfTouch(exit, {});
  const std::optional<Penetration> way = shortestWay();
  if (!way || !way->optimal) return exit;
  const Penetration& p = *way;
  const double depth = p.depth / frame_.unit();
  const double least = p.lower_bound / frame_.unit(), error = 4 * frame_.error();
  const bool agrees = least - error <= exit.depth && exit.depth <= depth + error;
  const bool alike = agrees && exit.normal.dot(p.normal) >= 1 - 0x1p-20;
  if (agrees && !alike && partsFreely(exit)) return exit;
  // What agrees with it to its precision is known better.
  if (!alike || !parts(exit)) exit = {p.normal, depth, -1, -1, true};
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
  return depth > 64 * frame_.error() ? exit : exitOfTouch(exit, way);
}

/// A touch whose normal leads into or along a wall: the middle of the widest range of directions that part them, if
/// there is one.
Exit ContactFinder::freed(const Exit& exit) const {
  constexpr int kDirections = 64;
  const auto at = [&](double k) {
    Exit result = exit;
    result.normal = Vec2(std::cos(k * 2 * kPi / kDirections), std::sin(k * 2 * kPi / kDirections));
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

/// Of its crossings the one of the first edges, or else its first vertex.
Contact ContactFinder::anyPointOf(const OverlapComponent& component) const {
  const auto isFirst = [&](std::size_t k, std::size_t l) {
    const EdgeCrossing &c = crossings_[k], &d = crossings_[l];
    return c.edge_a != d.edge_a ? c.edge_a < d.edge_a : c.edge_b < d.edge_b;
  };
  const auto first = std::min_element(component.crossings.begin(), component.crossings.end(), isFirst);
  if (first == component.crossings.end()) {
    const BoundaryPoint& vertex = component.points.front();
    return contactOf(vertex.at, Vec2::Zero(), 0, vertex.a, vertex.b);
  }
  const EdgeCrossing& c = crossings_[*first];
  return contactOf(c.point, Vec2::Zero(), 0, static_cast<std::ptrdiff_t>(c.edge_a),
                   static_cast<std::ptrdiff_t>(c.edge_b));
}

/// The middle of the overlap along the normal through the deepest point, or through the middle of those, where that is
/// in it.
Vec2 ContactFinder::pointOf(const OverlapComponent& component, const Hull& hull, const Exit& exit) const {
  // Heights above the end where the deepest points are, towards the other.
  const Vec2 up = exit.from_a ? exit.normal : Vec2(-exit.normal);
  const PartMiddle part = partMiddle(hull, up, 4 * frame_.error());
  if (axes_ != nullptr) return part.middle;
  return component.inner ? pointOfPart(pair_, frame_, part, up) : pointOfTouch(component, part.middle);
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

Contact ContactFinder::contactOf(const Vec2& point, const Vec2& normal, double depth, std::ptrdiff_t edge_a,
                                 std::ptrdiff_t edge_b) const {
  const auto number = [](const PolygonData& polygon, std::ptrdiff_t position) {
    return position < 0 ? position : polygon.edgeName(static_cast<std::size_t>(position));
  };
  return contactAt(frame_.toWorld(point), normal, depth * frame_.unit(), number(pair_.a, edge_a),
                   number(pair_.b, edge_b));
}

/// On the component, whose hull tells how far its edges matter.
void ContactFinder::addEnds(Contact& contact, const Vec2& point, const Exit& exit, const Hull& part) const {
  Extent extent{Vec2(-exit.normal.y(), exit.normal.x())};
  const auto isBefore = [&](const BoundaryPoint& p, const BoundaryPoint& q) {
    return extent.along.dot(p.at) < extent.along.dot(q.at);
  };
  const auto [first, last] = std::minmax_element(part.begin(), part.end(), isBefore);
  extent.low = extent.along.dot(first->at);
  extent.high = extent.along.dot(last->at);
  const auto pieceOf = [&](int side, std::ptrdiff_t edge) {
    return straightPiece(pair_, frame_, side, static_cast<std::size_t>(edge), extent);
  };
  detail::addEnds(contact, frame_, pieceOf(0, exit.edge_a), pieceOf(1, exit.edge_b), point, margin_);
}

}  // namespace

std::vector<Contact> partContacts(const PosedPair& pair, const SeparatingAxes* axes, const ContactOptions& options) {
  return ContactFinder(pair, axes, options).contacts();
}

}  // namespace tricover::detail
