// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/collide.h"

#include <cassert>
#include <optional>

#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "pair/collide_by_hierarchy.h"
#include "pair/collide_degenerate.h"
#include "pair/convex_apart.h"
#include "pair/discs.h"
#include "pair/facts.h"
#include "pair/kernel_order.h"
#include "pair/meet_at_once.h"
#include "pair/pair_fact.h"
#include "pair/polygon_place.h"
#include "polygon/cache_access.h"

namespace tricover {
namespace detail {
namespace {

/// What the hierarchy finds, or the edges that answered last.
PairFact findCloseFact(const PosedPair& pair, const CollideOptions& options, const FactWish& wish) {
  const auto fact = [&](bool collides, double clearance, std::ptrdiff_t edge_a, std::ptrdiff_t edge_b) {
    return PairFact{collides, roundedDown<2>(clearance * (1 - pair.scale_defect)), edge_a, edge_b};
  };
  const auto hit = [&](std::ptrdiff_t edge_a, std::ptrdiff_t edge_b) {
    const auto i = static_cast<std::size_t>(edge_a), j = static_cast<std::size_t>(edge_b);
    return fact(true, crossingDepth(pair, i, j), edge_a, edge_b);
  };
  // Points and segments have no tree, nor do they need a line.
  const bool may_have_line = wish.was_apart && wish.wants_clearance && !pair.a.isDegenerate() && !pair.b.isDegenerate();
  if (may_have_line && hierarchyOf(pair.a).convex != 0 && hierarchyOf(pair.b).convex != 0) {
    const double reach = pair.reach(options.margin);
    if (const auto line = findConvexApart(pair, wish.edge_a, wish.edge_b, reach + 0.25 * wish.lookahead))
      if (line->gap > reach) return fact(false, line->gap, line->near_a, line->near_b);
  } else if (wish.edge_a >= 0 && wish.edge_b >= 0) {
    const auto i = static_cast<std::size_t>(wish.edge_a), j = static_cast<std::size_t>(wish.edge_b);
    if (edgesWithin(pair, i, j, options.margin, options.tolerance)) return hit(wish.edge_a, wish.edge_b);
  }
  const Wanted wanted = wish.wants_clearance ? Wanted::Clearance : Wanted::Answer;
  const Outcome outcome = collideByHierarchy(pair, options, wish.lookahead, wanted);
  assert(!(outcome.clearance < 0));
  if (outcome.edge_a >= 0 && outcome.edge_b >= 0) return hit(outcome.edge_a, outcome.edge_b);
  return fact(outcome.collides, outcome.clearance, outcome.edge_a, outcome.edge_b);
}

/// The edge test where it is seldom asked for: the relative pose is composed when it is.
class RareEdgeTest {
 public:
  RareEdgeTest(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
               const CollideOptions& options)
      : a_(a), pose_a_(pose_a), b_(b), pose_b_(pose_b), options_(options) {}

  const PosedPair& pair() const { return pair_ ? *pair_ : pair_.emplace(a_, pose_a_, b_, pose_b_); }

  static bool meet(const void* context, std::size_t edge_a, std::size_t edge_b) {
    const RareEdgeTest& test = *static_cast<const RareEdgeTest*>(context);
    return edgesWithin(test.pair(), edge_a, edge_b, test.options_.margin, test.options_.tolerance);
  }

 private:
  const PolygonData& a_;
  const Pose& pose_a_;
  const PolygonData& b_;
  const Pose& pose_b_;
  const CollideOptions& options_;
  mutable std::optional<PosedPair> pair_;
};

/// What discs leave open; `defect` is defectOf() the poses. Inlined, because what discs have computed is in registers.
[[gnu::always_inline]] inline bool collideNear(const PolygonData& a, const Pose& pose_a, const PolygonData& b,
                                               const Pose& pose_b, const Discs& discs, double defect,
                                               const CollideOptions& options) {
  if (a.isDegenerate() || b.isDegenerate())
    return collideByHierarchy(PosedPair(a, pose_a, b, pose_b), options, 0, Wanted::Answer).collides;
  const Hierarchy &tree_a = hierarchyOf(a), &tree_b = hierarchyOf(b);
  const PolygonPlace place(a, b, discs, defect);
  const double limit = place.reach(options.margin) * a.inverse_unit;
  const RareEdgeTest test(a, pose_a, b, pose_b, options);
  double clearance;
  const Meeting meeting = meetAtOnce(tree_a, tree_b, place.map, place.rounding(), limit, Wanted::Answer,
                                     {&test, &RareEdgeTest::meet}, clearance);
  if (meeting != Meeting::Unknown) return meeting == Meeting::Meet;
  return searchTrees(test.pair(), place.map, place.rounding(), options, 0, Wanted::Answer).collides;
}

bool collideInOrder(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                    CollisionFact* cache, const Recollection& recollection, double defect,
                    const CollideOptions& options) {
  if (cache != nullptr) {
    claim(*cache, a, b);
    // After a jump another may follow: then a clearance would be of no use, only the poses to see that by.
    const PairFact fact =
        findFact(a, pose_a, b, pose_b, options,
                 {recollection.lookahead, recollection.coherent, static_cast<std::ptrdiff_t>(cache->first_edge),
                  static_cast<std::ptrdiff_t>(cache->second_edge), cache->clearance > 0 && !cache->overlapping});
    cache->first_edge = fact.edge_a;
    cache->second_edge = fact.edge_b;
    remember(*cache, a, pose_a, b, pose_b, fact.collides, fact.clearance);
    return fact.collides;
  }
  const Discs discs(a, pose_a, b, pose_b);
  if (discs.gap(options.margin) >= 0) return false;
  return discs.depth(options.margin) >= 0 || collideNear(a, pose_a, b, pose_b, discs, defect, options);
}

/// Whether one is a point, and the other has so few edges that they are asked sooner than a fact.
bool isQuickPoint(const PolygonData& a, const PolygonData& b) {
  constexpr std::size_t kFew = kLanes * kLanes + 1;
  return (a.isPoint() && b.path.size() <= kFew) || (b.isPoint() && a.path.size() <= kFew);
}

bool pointCollides(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                   const CollideOptions& options) {
  if (!a.isPoint()) return pointMeets(a, pose_a, b, pose_b, options);
  if (!b.isPoint()) return pointMeets(b, pose_b, a, pose_a, options);
  return inKernelOrder(
      a, pose_a, b, pose_b, [&](const auto&... operands) { return pointMeets(operands..., options); }, [](bool) {});
}

bool collide(const Polygon& polygon_a, const Pose& pose_a, const Polygon& polygon_b, const Pose& pose_b,
             CollisionFact* cache, const CollideOptions& options) {
  requireFiniteNotNegative(options.margin, "margin");
  requireFiniteNotNegative(options.tolerance, "tolerance");
  const PolygonData &a = polygon_a.data(), &b = polygon_b.data();
  const bool is_quick = isQuickPoint(a, b);
  Recollection recollection{};
  double defect = 0;
  if (cache == nullptr || is_quick) {
    defect = requireRigid(pose_a, pose_b);
    if (is_quick) return pointCollides(a, pose_a, b, pose_b, options);
  } else {
    recollection = recall(*cache, a, pose_a, b, pose_b, options.margin);
    if (recollection.certain) return recollection.collides;
  }
  return inKernelOrder(
      a, pose_a, b, pose_b,
      [&](const auto&... operands) { return collideInOrder(operands..., cache, recollection, defect, options); },
      [](bool) {});
}

}  // namespace

PairFact findFact(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                  const CollideOptions& options, const FactWish& wish) {
  const Discs discs(a, pose_a, b, pose_b);
  const double gap = discs.gap(options.margin);
  if (gap >= 0) return {false, gap, wish.edge_a, wish.edge_b};
  const double depth = discs.depth(options.margin);
  if (depth >= 0) return {true, depth, wish.edge_a, wish.edge_b};
  return findCloseFact(PosedPair(a, pose_a, b, pose_b), options, wish);
}

bool collideClose(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                  const CollideOptions& options) {
  if (isQuickPoint(a, b)) return pointCollides(a, pose_a, b, pose_b, options);
  const double defect = defectOf(pose_a, pose_b);
  return inKernelOrder(
      a, pose_a, b, pose_b,
      [&](const auto&... operands) { return collideNear(operands..., Discs(operands...), defect, options); },
      [](bool) {});
}

}  // namespace detail

bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
             const CollideOptions& options) {
  return detail::collide(a, pose_a, b, pose_b, nullptr, options);
}

bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, PairCache& cache,
             const CollideOptions& options) {
  return detail::collide(a, pose_a, b, pose_b, &detail::factsIn(cache).collision, options);
}

}  // namespace tricover
