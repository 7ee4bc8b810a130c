// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/collide.h"

#include <cassert>
#include <cstdint>
#include <optional>

#include "convex/nearest_features.h"
#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "pair/collide_by_edges.h"
#include "pair/collide_by_hierarchy.h"
#include "pair/discs.h"
#include "pair/facts.h"
#include "pair/find_fact.h"
#include "pair/interiors.h"
#include "pair/kernel_order.h"
#include "polygon/cache_access.h"
#include "polygon/convexity.h"

namespace tricover {
namespace detail {
namespace {

/// At most so much is a length of a's frame in the world.
double inWorld(double length, double scale_defect) { return roundedDown<2>(length * (1 - scale_defect)); }

/// Of convex polygons, by their nearest features. Those that start with the vertices of the last ones are tried first.
std::optional<Outcome> findConvexFact(const PolygonData& a, const Pose& pose_a, const PolygonData& b,
                                      const Pose& pose_b, double margin, const FactWish& wish) {
  const PolygonData *corners_a = cornersOf(a), *corners_b = cornersOf(b);
  if (corners_a == nullptr || corners_b == nullptr) return std::nullopt;
  FeaturePair tried;
  if (wish.edge_a >= 0 && wish.edge_b >= 0)
    tried = {FeaturePair::kVertices, cornerFrom(a, static_cast<std::size_t>(wish.edge_a)),
             cornerFrom(b, static_cast<std::size_t>(wish.edge_b))};
  const PosedVertices vertices(*corners_a, pose_a, *corners_b, pose_b);
  const NearestFeatures nearest = findNearestFeatures(vertices, tried);
  const double apart = nearest.are_apart ? nearest.atLeast(vertices) : 0;
  if (!(apart > margin)) return std::nullopt;
  return Outcome{false, apart, static_cast<std::ptrdiff_t>(convexityOf(a).corner(nearest.features.edge_a)),
                 static_cast<std::ptrdiff_t>(convexityOf(b).corner(nearest.features.edge_b))};
}

/// Of polygons of which one lacks a hierarchy, for now or until now.
Outcome collideAnew(const Placement& placement, double defect, const EdgeTest& test, double lookahead, Wanted wanted) {
  if (const std::optional<Outcome> outcome = collideByEdges(placement, defect, test)) return *outcome;
  return collideByHierarchy(placement.inUnits(defect), test, lookahead, wanted);
}
[[gnu::cold, gnu::noinline]] bool collideAnew(const Placement& placement, double defect,
                                              const CollideOptions& options) {
  return collideAnew(placement, defect, EdgeTest(placement, options), 0, Wanted::Answer).collides;
}

/// What the hierarchy finds, or the edges that answered last.
Outcome findCloseFact(const Placement& placement, const CollideOptions& options, const FactWish& wish) {
  const EdgeTest test(placement, options);
  const auto hit = [&](std::ptrdiff_t edge_a, std::ptrdiff_t edge_b) {
    const PosedPair& pair = test.pair();
    const double depth = crossingDepth(pair, static_cast<std::size_t>(edge_a), static_cast<std::size_t>(edge_b));
    return Outcome{true, inWorld(depth, pair.scale_defect), edge_a, edge_b};
  };
  if (wish.edge_a >= 0 && wish.edge_b >= 0)
    if (test(static_cast<std::size_t>(wish.edge_a), static_cast<std::size_t>(wish.edge_b)))
      return hit(wish.edge_a, wish.edge_b);
  const Wanted wanted = wish.wants_clearance ? Wanted::Clearance : Wanted::Answer;
  const UnitPlacement at = placement.inUnits();
  const Outcome outcome = haveHierarchies(placement.a, placement.b)
                              ? collideByHierarchy(at, test, wish.lookahead, wanted)
                              : collideAnew(placement, at.scale_defect, test, wish.lookahead, wanted);
  assert(!(outcome.clearance < 0));
  if (outcome.edge_a >= 0 && outcome.edge_b >= 0) return hit(outcome.edge_a, outcome.edge_b);
  return {outcome.collides, inWorld(outcome.clearance, at.scale_defect), outcome.edge_a, outcome.edge_b, outcome.by};
}

/// `resting` is a cache whose facts rest: until discs don't answer any more, which are sooner asked, and then for so
/// many queries.
[[gnu::always_inline]] inline bool collideAfresh(const PolygonData& a, const Pose& pose_a, const PolygonData& b,
                                                 const Pose& pose_b, double defect, const CollideOptions& options,
                                                 CollisionFact* resting) {
  const Placement placement(a, pose_a, b, pose_b);
  if (gapOfDiscs(placement, options.margin) >= 0) return false;
  if (depthOfDiscs(placement, options.margin) >= 0) return true;
  if (resting != nullptr) rest(*resting, a, pose_a, b, pose_b);
  if (!haveHierarchies(a, b)) return collideAnew(placement, defect, options);
  return collideByHierarchy(placement.inUnits(defect), EdgeTest(placement, options), 0, Wanted::Answer).collides;
}
[[gnu::noinline]] bool collideAfresh(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                                     const CollideOptions& options) {
  return collideAfresh(a, pose_a, b, pose_b, defectOf(pose_a, pose_b), options, nullptr);
}

/// What finding it has cost, in quarters of the query: more than by boxes, or by few edges, which are asked at once,
/// than by trees. The edges that met last and do again are sooner asked than those.
std::int8_t costOf(const Outcome& fact, const CollisionFact& cache, const PolygonData& a) {
  const bool is_known =
      fact.collides && fact.edge_b >= 0 && fact.edge_a == cache.first_edge && fact.edge_b == cache.second_edge;
  if (fact.by == Outcome::By::Boxes) return 4;
  if (a.path.size() <= SmallPolygon::kMost + 1) return is_known ? 5 : 8;
  return is_known ? -1 : 1;
}

bool collide(const Polygon& polygon_a, const Pose& pose_a, const Polygon& polygon_b, const Pose& pose_b,
             CollisionFact* cache, const CollideOptions& options) {
  requireFiniteNotNegative(options.margin, "margin");
  requireFiniteNotNegative(options.tolerance, "tolerance");
  const PolygonData &a = polygon_a.data(), &b = polygon_b.data();
  const auto inOrder = [&](auto query) { return inKernelOrder(a, pose_a, b, pose_b, query, [](bool) {}); };
  CollisionFact* const resting = cache != nullptr && cache->balance.resting > 0 ? cache : nullptr;
  if (cache == nullptr || resting != nullptr) {
    const double defect = requireRigid(pose_a, pose_b);
    return inOrder([&](const auto&... operands) { return collideAfresh(operands..., defect, options, resting); });
  }
  const Recollection recollection = recall(*cache, a, pose_a, b, pose_b, options.margin);
  if (recollection.certain) return recollection.collides;
  return inOrder([&](const auto&... operands) { return renewFact(operands..., *cache, recollection, options); });
}

/// Where touching is allowed.
[[gnu::cold, gnu::noinline]] bool collideInside(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                                const Pose& pose_b, CollisionFact* cache,
                                                const CollideOptions& options) {
  requireTouching(options.touching);
  if (!asksForInteriors(options)) return collide(a, pose_a, b, pose_b, cache, options);
  return collide(a, pose_a, b, pose_b, cache, {}) && interiorsMeet(a.data(), pose_a, b.data(), pose_b);
}

}  // namespace

Outcome findFact(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                 const CollideOptions& options, const FactWish& wish) {
  if (asksForInteriors(options)) {
    Outcome fact = findFact(a, pose_a, b, pose_b, {}, wish);
    if (!fact.collides) return fact;
    // What keeps regions together doesn't keep their interiors together.
    fact.collides = interiorsMeet(a, pose_a, b, pose_b);
    fact.clearance = 0;
    return fact;
  }
  const Placement placement(a, pose_a, b, pose_b);
  const double gap = gapOfDiscs(placement, options.margin);
  if (gap >= 0) return {false, gap, wish.edge_a, wish.edge_b, Outcome::By::Discs};
  const double depth = depthOfDiscs(placement, options.margin);
  if (depth >= 0) return {true, depth, wish.edge_a, wish.edge_b, Outcome::By::Discs};
  if (wish.was_apart && wish.wants_clearance)
    if (const auto fact = findConvexFact(a, pose_a, b, pose_b, options.margin, wish)) return *fact;
  return findCloseFact(placement, options, wish);
}

namespace {

/// What a new fact says, if one is worth finding.
[[gnu::always_inline]] inline std::optional<bool> keptFact(const PolygonData& a, const Pose& pose_a,
                                                           const PolygonData& b, const Pose& pose_b,
                                                           CollisionFact& cache, const Recollection& recollection,
                                                           const CollideOptions& options, bool are_apart) {
  claim(cache, a, b);
  if (!isWorthRenewing(cache, recollection.coherent)) return std::nullopt;
  if (!recollection.coherent) {
    // After a jump another may follow: only the poses are of use, to see that by.
    remember(cache, a, pose_a, b, pose_b, false, 0);
    return std::nullopt;
  }
  const Outcome fact = findFact(
      a, pose_a, b, pose_b, options,
      {recollection.lookahead, true, static_cast<std::ptrdiff_t>(cache.first_edge),
       static_cast<std::ptrdiff_t>(cache.second_edge), are_apart || (cache.clearance > 0 && !cache.overlapping)});
  const std::int8_t cost = costOf(fact, cache, a);
  cache.first_edge = fact.edge_a;
  cache.second_edge = fact.edge_b;
  const bool is_by_discs = fact.by == Outcome::By::Discs;
  remember(cache, a, pose_a, b, pose_b, fact.collides, is_by_discs ? 0 : fact.clearance);
  if (is_by_discs) {
    if (isWorthIt(cache.balance, -1)) cache.balance.resting = 1;
  } else {
    cache.cost = cost;
    cache.looked_ahead = static_cast<float>(fact.clearance);
  }
  return fact.collides;
}

}  // namespace

bool renewFact(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b, CollisionFact& cache,
               const Recollection& recollection, const CollideOptions& options) {
  const std::optional<bool> fact = keptFact(a, pose_a, b, pose_b, cache, recollection, options, false);
  return fact ? *fact : collideAfresh(a, pose_a, b, pose_b, options);
}

void renewFactApart(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                    CollisionFact& cache, const Recollection& recollection, const CollideOptions& options) {
  keptFact(a, pose_a, b, pose_b, cache, recollection, options, true);
}

}  // namespace detail

bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
             const CollideOptions& options) {
  if (options.touching != Touching::Collides) return detail::collideInside(a, pose_a, b, pose_b, nullptr, options);
  return detail::collide(a, pose_a, b, pose_b, nullptr, options);
}

bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, PairCache& cache,
             const CollideOptions& options) {
  detail::CollisionFact* facts = &detail::factsIn(cache).collision;
  if (options.touching != Touching::Collides) return detail::collideInside(a, pose_a, b, pose_b, facts, options);
  return detail::collide(a, pose_a, b, pose_b, facts, options);
}

}  // namespace tricover
