// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/collide.h"

#include <cassert>
#include <cstdint>
#include <optional>

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

namespace tricover {
namespace detail {
namespace {

/// At most so much is a length of a's frame in the world.
double inWorld(double length, double scale_defect) { return roundedDown<2>(length * (1 - scale_defect)); }

/// Of polygons of which one lacks a hierarchy, for now or until now.
Outcome collideAnew(const Placement& placement, double defect, const EdgeTest& test, double lookahead, Wanted wanted) {
  if (const std::optional<Outcome> outcome = collideByEdges(placement, defect, test)) return *outcome;
  return collideByHierarchy(placement.inUnits(defect), test, lookahead, wanted);
}
[[gnu::cold, gnu::noinline]] bool collideAnew(const Placement& placement, double defect,
                                              const CollideOptions& options) {
  return collideAnew(placement, defect, EdgeTest(placement, options), 0, Wanted::Answer).collides;
}

/// What bounding and inner discs tell, if they decide.
std::optional<Outcome> factOfDiscs(const Placement& placement, double margin, const FactWish& wish) {
  const double gap = gapOfDiscs(placement, margin);
  if (gap >= 0) return Outcome{false, gap, wish.edge_a, wish.edge_b};
  const double depth = depthOfDiscs(placement, margin);
  if (depth >= 0) return Outcome{true, depth, wish.edge_a, wish.edge_b};
  return std::nullopt;
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
  return {outcome.collides, inWorld(outcome.clearance, at.scale_defect), outcome.edge_a, outcome.edge_b};
}

/// Without a certificate. A cache in back-off counts down only on queries that discs don't decide.
[[gnu::always_inline]] inline bool collideAfresh(const PolygonData& a, const Pose& pose_a, const PolygonData& b,
                                                 const Pose& pose_b, double defect, const CollideOptions& options,
                                                 CollisionFact* backing_off) {
  const Placement placement(a, pose_a, b, pose_b);
  if (gapOfDiscs(placement, options.margin) >= 0) return false;
  if (depthOfDiscs(placement, options.margin) >= 0) return true;
  if (backing_off != nullptr) countDown(*backing_off, a, pose_a, b, pose_b);
  if (!haveHierarchies(a, b)) return collideAnew(placement, defect, options);
  return collideByHierarchy(placement.inUnits(defect), EdgeTest(placement, options), 0, Wanted::Answer).collides;
}


bool collide(const Polygon& polygon_a, const Pose& pose_a, const Polygon& polygon_b, const Pose& pose_b,
             CollisionFact* cache, const CollideOptions& options) {
  requireFiniteNotNegative(options.margin, "margin");
  requireFiniteNotNegative(options.tolerance, "tolerance");
  const PolygonData &a = polygon_a.data(), &b = polygon_b.data();
  const auto inOrder = [&](auto query) { return inKernelOrder(a, pose_a, b, pose_b, query, [](bool) {}); };
  if (cache == nullptr || cache->back_off.isOn()) {
    const double defect = requireRigid(pose_a, pose_b);
    return inOrder([&](const auto&... operands) { return collideAfresh(operands..., defect, options, cache); });
  }
  const Recollection recollection = recall(*cache, a, pose_a, b, pose_b, options.margin);
  if (recollection.certain) return recollection.collides;
  return inOrder([&](const auto&... operands) {
    const std::optional<bool> renewed = renewFact(operands..., *cache, recollection, options);
    return renewed ? *renewed : collideAfresh(operands..., defectOf(pose_a, pose_b), options, nullptr);
  });
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
  if (const auto fact = factOfDiscs(placement, options.margin, wish)) return *fact;
  return findCloseFact(placement, options, wish);
}

std::optional<bool> renewFact(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                              CollisionFact& cache, const Recollection& recollection, const CollideOptions& options) {
  claim(cache, a, b);
  if (!isWorthRenewing(cache, recollection)) {
    rememberPoses(cache, a, pose_a, b, pose_b);
    return std::nullopt;
  }
  const FactWish wish{recollection.lookahead, true, cache.first_edge, cache.second_edge};
  const Placement placement(a, pose_a, b, pose_b);
  if (const auto fact = factOfDiscs(placement, options.margin, wish)) {
    cache.back_off.left = 1;  // discs cost no more than recall(), as long as they decide
    return fact->collides;
  }
  const Outcome fact = findCloseFact(placement, options, wish);
  remember(cache, a, pose_a, b, pose_b, fact.collides, fact.clearance);
  // The last hit's edges meet again: that costs less than the query, unless all edges are tested at once.
  const bool hits_again = fact.collides && fact.edge_b >= 0 && fact.edge_a == wish.edge_a && fact.edge_b == wish.edge_b;
  if (hits_again && a.path.size() > SmallPolygon::kMost + 1) cache.was_sought = false;
  cache.first_edge = static_cast<std::int32_t>(fact.edge_a);
  cache.second_edge = static_cast<std::int32_t>(fact.edge_b);
  return fact.collides;
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
