// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/collide.h"

#include <cassert>

#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "pair/collide_by_hierarchy.h"
#include "pair/collide_by_paper.h"
#include "pair/collide_spine.h"
#include "pair/discs.h"
#include "pair/facts.h"
#include "pair/kernel_order.h"

namespace tricover {
namespace detail {
namespace {

/// Finds the answer and keeps why it is certain.
bool findFact(const PosedPair& pair, PairCache& cache, const Recollection& recollection,
              const CollideOptions& options) {
  claim(cache, pair.a, pair.b);
  const auto fact = [&](bool overlapping, double clearance) {
    remember(cache, pair.a, pair.pose_a, pair.b, pair.pose_b, overlapping,
             roundedDown<2>(clearance * (1 - pair.scale_defect)));
    return overlapping;
  };
  if (cache.first_edge >= 0 && cache.second_edge >= 0) {
    const auto i = static_cast<std::size_t>(cache.first_edge), j = static_cast<std::size_t>(cache.second_edge);
    if (edgesWithin(pair, i, j, options.margin, options.tolerance)) return fact(true, crossingDepth(pair, i, j));
  }
  // After a jump another may follow: then a clearance would be of no use, only the poses to see that by.
  const Wanted wanted = recollection.coherent ? Wanted::Clearance : Wanted::Answer;
  const Outcome outcome = collideByHierarchy(pair, options, recollection.lookahead, wanted);
  assert(!(outcome.clearance < 0) && cache.first_id == pair.a.id && cache.second_id == pair.b.id);
  cache.first_edge = outcome.edge_a;
  cache.second_edge = outcome.edge_b;
  if (outcome.edge_a < 0 || outcome.edge_b < 0) return fact(outcome.collides, outcome.clearance);
  const auto i = static_cast<std::size_t>(outcome.edge_a), j = static_cast<std::size_t>(outcome.edge_b);
  return fact(true, crossingDepth(pair, i, j));
}

bool collideInOrder(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                    PairCache* cache, const Recollection& recollection, const CollideOptions& options) {
  const Discs discs(a, pose_a, b, pose_b);
  const bool by_paper = options.strategy == Strategy::Paper;
  const auto fact = [&](bool overlapping, double clearance) {
    if (cache != nullptr && !by_paper) remember(*cache, a, pose_a, b, pose_b, overlapping, clearance);
    return overlapping;
  };
  const double gap = discs.gap(options.margin);
  if (gap >= 0) return fact(false, gap);
  if (by_paper) return collideByPaper(PosedPair(a, pose_a, b, pose_b), cache, options);
  const double depth = discs.depth(options.margin);
  if (depth >= 0) return fact(true, depth);
  const PosedPair pair(a, pose_a, b, pose_b);
  return cache != nullptr ? findFact(pair, *cache, recollection, options)
                          : collideByHierarchy(pair, options, 0, Wanted::Answer).collides;
}

/// Whether one is a point, and the other has so few edges that they are asked sooner than a fact.
bool isQuickPoint(const PolygonData& a, const PolygonData& b) {
  constexpr std::size_t kFew = kLanes * kLanes + 1;
  return (a.isPoint() && b.path.size() <= kFew) || (b.isPoint() && a.path.size() <= kFew);
}

bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, PairCache* cache,
             const CollideOptions& options) {
  requireFiniteNotNegative(options.margin, "margin");
  requireFiniteNotNegative(options.tolerance, "tolerance");
  requireRigid(pose_a, "pose_a");
  requireRigid(pose_b, "pose_b");
  if (isQuickPoint(a.data(), b.data()) && options.strategy == Strategy::Hierarchy) {
    return inKernelOrder(
        a.data(), pose_a, b.data(), pose_b,
        [&](const PolygonData& p, const Pose& pose_p, const PolygonData& q, const Pose& pose_q) {
          return q.isPoint() ? pointMeets(p, pose_p, q, pose_q, options) : pointMeets(q, pose_q, p, pose_p, options);
        },
        [](bool) {});
  }
  Recollection recollection{};
  if (cache != nullptr && options.strategy == Strategy::Hierarchy) {
    recollection = recall(*cache, a.data(), pose_a, b.data(), pose_b, options.margin);
    if (recollection.certain) return recollection.collides;
  }
  return inKernelOrder(
      a.data(), pose_a, b.data(), pose_b,
      [&](const auto&... operands) { return collideInOrder(operands..., cache, recollection, options); }, [](bool) {});
}

}  // namespace
}  // namespace detail

bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
             const CollideOptions& options) {
  return detail::collide(a, pose_a, b, pose_b, nullptr, options);
}

bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, PairCache& cache,
             const CollideOptions& options) {
  return detail::collide(a, pose_a, b, pose_b, &cache, options);
}

}  // namespace tricover
