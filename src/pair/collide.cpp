// SPDX-License-Identifier: BSD-3-Clause
#include "pair/collide.h"

#include <cassert>
#include <cmath>
#include <cstdint>
#include <optional>

#include "pair/certificate.h"
#include "pair/collide_by_edges.h"
#include "pair/collide_by_hierarchy.h"
#include "pair/discs.h"
#include "pair/kernel_order.h"

namespace tricover::detail {
namespace {

/// By brute force over edges until both hierarchies are paid for, then by these. Not inlined, because discs answer most
/// queries.
[[gnu::noinline]] Outcome collideClose(const PosedPair& placement, double defect, const EdgeTest& test,
                                       double lookahead, Wanted wanted) {
  if (!haveHierarchies(placement.a, placement.b))
    if (const std::optional<Outcome> outcome = collideByEdges(test)) return *outcome;
  return collideByHierarchy(placement.inUnits(defect), test, lookahead, wanted);
}

/// What bounding and inner discs, and a field, tell, if they decide.
std::optional<Outcome> certificateOfDiscs(const PosedPair& placement, double defect, double margin,
                                          const CertificateWish& wish) {
  const double gap = gapOfDiscs(placement, margin);
  if (gap >= 0) return Outcome{false, gap, wish.edge_a, wish.edge_b};
  const double in_field = BodyInField(placement, defect).gap(margin + wish.lookahead);
  if (in_field != 0) return Outcome{in_field < 0, std::abs(in_field), wish.edge_a, wish.edge_b};
  const double depth = depthOfDiscs(placement, margin);
  if (depth >= 0) return Outcome{true, depth, wish.edge_a, wish.edge_b};
  return std::nullopt;
}

/// What the hierarchy finds, or the edges that answered last.
Outcome findCloseCertificate(const PosedPair& placement, double defect, const CollideOptions& options,
                             const CertificateWish& wish) {
  const EdgeTest test(placement, options);
  const auto hit = [&](EdgePosition edge_a, EdgePosition edge_b) {
    const double depth = crossingDepth(placement, edge_a, edge_b);
    return Outcome{true, depth, edge_a, edge_b};
  };
  if (wish.edge_a != kNoEdge && wish.edge_b != kNoEdge && test(wish.edge_a, wish.edge_b))
    return hit(wish.edge_a, wish.edge_b);
  const Wanted wanted = wish.wants_clearance ? Wanted::Clearance : Wanted::Answer;
  const Outcome outcome = collideClose(placement, defect, test, wish.lookahead, wanted);
  assert(!(outcome.clearance < 0));
  if (outcome.edge_a != kNoEdge && outcome.edge_b != kNoEdge) return hit(outcome.edge_a, outcome.edge_b);
  return outcome;
}

/// Without a certificate. A cache in back-off counts down only on queries that discs don't decide.
[[gnu::always_inline]] inline bool collideAfresh(const PolygonData& a, const Pose& pose_a, const PolygonData& b,
                                                 const Pose& pose_b, double defect, const CollideOptions& options,
                                                 Certificate* backing_off) {
  const PosedPair placement(a, pose_a, b, pose_b);
  if (gapOfDiscs(placement, options.margin) >= 0) return false;
  const double in_field = BodyInField(placement, defect).gap(options.margin);
  if (in_field != 0) return in_field < 0;
  if (depthOfDiscs(placement, options.margin) >= 0) return true;
  if (backing_off != nullptr) countDown(*backing_off, a, pose_a, b, pose_b);
  return collideClose(placement, defect, EdgeTest(placement, options), 0, Wanted::Answer).collides;
}

}  // namespace

bool collide(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b, double defect,
             Certificate* cache, const CollideOptions& options) {
  Recollection recollection{};
  const bool is_renewed = cache != nullptr && !cache->back_off.isOn();
  if (is_renewed) {
    recollection = recall(*cache, a, pose_a, b, pose_b, defect, options.margin);
    if (recollection.certain) return recollection.collides;
  }
  return inKernelOrder(
      a, pose_a, b, pose_b,
      [&](const auto&... operands) {
        if (is_renewed)
          if (const std::optional<bool> renewed = renewCertificate(operands..., defect, *cache, recollection, options))
            return *renewed;
        return collideAfresh(operands..., defect, options, is_renewed ? nullptr : cache);
      },
      [](bool) {});
}

Outcome findCertificate(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                        double defect, const CollideOptions& options, const CertificateWish& wish) {
  const PosedPair placement(a, pose_a, b, pose_b);
  if (const auto found = certificateOfDiscs(placement, defect, options.margin, wish)) return *found;
  return findCloseCertificate(placement, defect, options, wish);
}

std::optional<bool> renewCertificate(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                                     double defect, Certificate& cache, const Recollection& recollection,
                                     const CollideOptions& options) {
  if (!beginRenewal(cache, a, pose_a, b, pose_b, recollection)) return std::nullopt;
  const CertificateWish wish{recollection.lookahead, true, cache.first_edge, cache.second_edge};
  const PosedPair placement(a, pose_a, b, pose_b);
  if (const auto found = certificateOfDiscs(placement, defect, options.margin, wish)) {
    cache.back_off.left = 1;  // discs cost no more than recall(), as long as they decide
    return found->collides;
  }
  const Outcome found = findCloseCertificate(placement, defect, options, wish);
  remember(cache, a, pose_a, b, pose_b, found.collides, found.clearance);
  // The last hit's edges meet again: that costs less than the query, unless all edges are tested at once.
  const bool hits_again =
      found.collides && found.edge_b != kNoEdge && found.edge_a == wish.edge_a && found.edge_b == wish.edge_b;
  if (hits_again && a.path.size() > SmallPolygon::kMost + 1) cache.was_sought = false;
  cache.first_edge = found.edge_a;
  cache.second_edge = found.edge_b;
  return found.collides;
}

}  // namespace tricover::detail
