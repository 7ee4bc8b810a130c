// SPDX-License-Identifier: BSD-3-Clause
// One polygon against the bodies of a scene.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "distance/options.h"
#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "pair/facts.h"
#include "pair/find_fact.h"
#include "pair/kernel_order.h"
#include "polygon/cache_access.h"
#include "scene/scene_state.h"

namespace tricover {

using detail::SceneState;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void check(const Pose& pose, const CollideOptions& options) {
  detail::requireFiniteNotNegative(options.margin, "margin");
  detail::requireFiniteNotNegative(options.tolerance, "tolerance");
  detail::requireRigid(pose, "pose");
}

/// A SceneCache's clearance looks ahead for so many steps: fewer than a PairCache's, because all bodies within are
/// asked.
constexpr double kCacheSteps = 8;

/// A posed polygon that bodies are asked about.
class Asked {
  static constexpr std::size_t kFew = 2 * detail::kLanes + 1;

 public:
  Asked(const detail::PolygonData& polygon, const Pose& pose, const CollideOptions& options)
      : polygon_(polygon), pose_(pose), options_(options), discs_(polygon, pose) {}

  /// What discs know, and how far those inside are apart for their size: the less, the likelier the bodies meet.
  struct Glance {
    enum { Apart, Near, Meets } answer;
    double rank;
  };
  Glance glance(const SceneState::BodyState& body) const {
    detail::WorldDiscs found;
    const detail::WorldDiscs& discs = body.discs.of(body.polygon.data(), body.pose, found);
    const double margin = sumWith(body).margin;
    if (detail::areApart(discs_, discs, margin)) return {Glance::Apart, 0};
    if (detail::areWithin(discs_, discs, margin)) return {Glance::Meets, 0};
    const double within = discs_.inner_radius + discs.inner_radius;
    const double rank = detail::squaredLength(discs.inner - discs_.inner) / (within * within);
    return {Glance::Near, within > 0 ? rank : kInfinity};
  }

  /// The truth, where discs don't know it, of a body in this box.
  bool meetsClose(const SceneState::BodyState& body, const detail::Bounds& box) const {
    if (!box.meets(bounds()) || body.clear.holds(bounds())) return false;
    if (detail::collideClose(polygon_, pose_, body.polygon.data(), body.pose, sumWith(body))) return true;
    body.clear.learn(body.polygon.data(), body.pose, body.options.margin, box, bounds());
    return false;
  }

  bool meets(const SceneState::BodyState& body, const detail::Bounds& box) const {
    const auto answer = glance(body).answer;
    return answer == Glance::Near ? meetsClose(body, box) : answer == Glance::Meets;
  }

  const detail::Bounds& bounds() const {
    if (!bounds_) bounds_ = detail::boundsOf(polygon_, pose_, options_.margin);
    return *bounds_;
  }

  /// Wider, unless few vertices tell, and sooner there: around the bounding disc. In units of U, of the centre and the
  /// reach: either side's sum and difference, and the margin's sum with a body's.
  detail::Bounds quickBounds() const {
    if (polygon_.path.size() <= kFew) return bounds();
    const double x = discs_.center[0], y = discs_.center[1], reach = discs_.radius + options_.margin;
    const double wide = reach + 8 * detail::kUnitRoundoff * (std::abs(x) + std::abs(y) + reach);
    const detail::Bounds box{x - wide, y - wide, x + wide, y + wide};
    // Negated for NaN.
    return !(wide < kInfinity && std::abs(x) < kInfinity && std::abs(y) < kInfinity) ? bounds() : box;
  }

 private:
  CollideOptions sumWith(const SceneState::BodyState& body) const {
    return detail::withMargin(options_, body.options.margin);
  }

  const detail::PolygonData& polygon_;
  const Pose& pose_;
  const CollideOptions& options_;
  const detail::WorldDiscs discs_;
  mutable std::optional<detail::Bounds> bounds_;
};

/// A lower bound of the distance between points of two boxes; never NaN.
double gapBetween(const detail::Bounds& p, const detail::Bounds& q) {
  const double x = std::max({0.0, p.min_x - q.max_x, q.min_x - p.max_x});
  const double y = std::max({0.0, p.min_y - q.max_y, q.min_y - p.max_y});
  return std::max({x, y, detail::normBelow(x, y)}) * (1 - 4 * detail::kUnitRoundoff);
}

}  // namespace

namespace {

constexpr BodyHandle kNone = ~BodyHandle{0};

/// A body that collides, or kNone.
BodyHandle findMet(const SceneState& state, const Asked& asked, std::uint32_t mask) {
  // All discs first: one that is met spares all that is near. What is near waits in order.
  constexpr int kMost = 16;
  struct Waiting {
    double rank;
    BodyHandle body;
  } near[kMost];
  int count = 0;
  BodyHandle met = kNone;
  state.tree.visit(asked.quickBounds(), [&](BodyHandle body) {
    const auto& other = state.bodies[body];
    if ((other.options.category & mask) == 0) return true;
    const Asked::Glance glance = asked.glance(other);
    if (glance.answer == Asked::Glance::Apart) return true;
    if (glance.answer == Asked::Glance::Meets ||
        (count == kMost && asked.meetsClose(other, state.tree.boundsOf(body)))) {
      met = body;
      return false;
    }
    if (count == kMost) return true;
    int place = count++;
    for (; place > 0 && glance.rank < near[place - 1].rank; --place) near[place] = near[place - 1];
    near[place] = {glance.rank, body};
    return true;
  });
  if (met != kNone || count == 0) return met;
  const Waiting* first = std::find_if(near, near + count, [&](const Waiting& some) {
    return asked.meetsClose(state.bodies[some.body], state.tree.boundsOf(some.body));
  });
  return first == near + count ? kNone : first->body;
}

}  // namespace

bool Scene::collides(const Polygon& polygon, const Pose& pose, const CollideOptions& options,
                     std::uint32_t mask) const {
  return anyColliding(polygon, pose, options, mask).has_value();
}

std::optional<Scene::Body> Scene::anyColliding(const Polygon& polygon, const Pose& pose, const CollideOptions& options,
                                               std::uint32_t mask) const {
  check(pose, options);
  const Body met = findMet(impl_->settled(), Asked(polygon.data(), pose, options), mask);
  return met != kNone ? std::optional<Body>(met) : std::nullopt;
}

bool Scene::collides(const Polygon& polygon, const Pose& pose, SceneCache& caller_cache, const CollideOptions& options,
                     std::uint32_t mask) const {
  detail::SceneFact& cache = detail::factsIn(caller_cache);
  check(pose, options);
  const SceneState& state = impl_->settled();
  const detail::PolygonData& data = polygon.data();
  const bool known = cache.scene == state.id && cache.version == state.version && cache.polygon == data.id &&
                     (mask & ~cache.mask) == 0;
  double lookahead = 0;
  bool coherent = false;
  if (known) {
    const detail::Change change(data, cache.pose, pose);
    const double room = detail::roundedDown<1>(cache.clearance - options.margin);
    const double motion = change.any() ? change.displacement() : 0;
    if (motion < room) {
      ++cache.uses;
      return false;
    }
    coherent = motion <= detail::kCoherentPart * data.radius;
    if (coherent) lookahead = kCacheSteps * motion / (cache.uses + 1.0);
  }
  const Asked asked(data, pose, options);
  if (coherent && contains(cache.body)) {
    const auto& last = state.bodies[cache.body];
    if ((last.options.category & mask) != 0 && asked.meets(last, state.tree.boundsOf(cache.body))) {
      cache.clearance = 0;
      return true;
    }
  }
  cache = {state.id, state.version, data.id, {}, 0, cache.body, mask, 0};
  detail::store(cache.pose, pose);
  if (!coherent) {  // after a jump another may follow
    const Body met = findMet(state, asked, mask);
    if (met != kNone) cache.body = met;
    return met != kNone;
  }
  double clearance = lookahead;  // beyond all margins
  const detail::Bounds& bounds = asked.bounds();
  const bool free = state.tree.visit(detail::grown(bounds, lookahead), [&](Body body) {
    const auto& other = state.bodies[body];
    if ((other.options.category & mask) == 0) return true;
    if (const double gap = gapBetween(bounds, state.tree.boundsOf(body)); gap > 0) {
      clearance = std::min(clearance, gap);  // less than the truth, and sooner known
      return true;
    }
    const CollideOptions sum = detail::withMargin(options, other.options.margin);
    const detail::Outcome fact = detail::inKernelOrder(
        data, pose, other.polygon.data(), other.pose,
        [&](const auto&... operands) {
          return detail::findFact(operands..., sum, {lookahead, true});
        },
        [](const detail::Outcome&) {});
    if (fact.collides) cache.body = body;
    clearance = std::min(clearance, detail::roundedDown<1>(fact.clearance - sum.margin));
    return !fact.collides;
  });
  cache.clearance = free ? detail::roundedDown<1>(options.margin + std::max(clearance, 0.0)) : 0;
  return !free;
}

std::vector<Scene::Body> Scene::colliding(const Polygon& polygon, const Pose& pose, const CollideOptions& options,
                                          std::uint32_t mask) const {
  check(pose, options);
  const SceneState& state = impl_->settled();
  const Asked asked(polygon.data(), pose, options);
  std::vector<Body> found;
  state.tree.visit(asked.bounds(), [&](Body body) {
    const auto& other = state.bodies[body];
    if ((other.options.category & mask) != 0 && asked.meets(other, state.tree.boundsOf(body))) found.push_back(body);
    return true;
  });
  std::sort(found.begin(), found.end());
  return found;
}

std::optional<BodyDistance> Scene::nearest(const Polygon& polygon, const Pose& pose, const DistanceOptions& options,
                                           std::uint32_t mask) const {
  return nearestWithin(polygon, pose, kInfinity, options, mask);
}

std::optional<BodyDistance> Scene::nearestWithin(const Polygon& polygon, const Pose& pose, double limit,
                                                 const DistanceOptions& options, std::uint32_t mask) const {
  detail::checkOptions(options);
  detail::requireNotNegative(limit, "limit");
  detail::requireRigid(pose, "pose");
  const SceneState& state = impl_->settled();
  // Boxes hold the bodies' margins, this one the query's own: a result is what margins leave of a distance.
  const detail::Bounds bounds = detail::boundsOf(polygon.data(), pose, options.margin);
  std::optional<BodyDistance> best;
  DistanceOptions sum = options;
  state.tree.visitNear(bounds, limit, [&](Body body) {
    const auto& other = state.bodies[body];
    if ((other.options.category & mask) == 0) return limit;
    if (best && limit == 0 && body > best->body) return limit;  // no nearer
    sum.margin = std::min(options.margin + other.options.margin, std::numeric_limits<double>::max());
    const auto result = distanceWithin(polygon, pose, other.polygon, other.pose, limit, sum);
    if (!result || result->distance == kInfinity) return limit;
    if (!best || std::pair(result->distance, body) < std::pair(best->result.distance, best->body))
      best = BodyDistance{body, *result};
    limit = std::min(limit, best->result.distance);
    return limit;
  });
  return best;
}

}  // namespace tricover
