// SPDX-License-Identifier: BSD-3-Clause
// The paper's Algorithm 3, repaired.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "overlay/interiors.h"
#include "pair/containment.h"
#include "pair/discs.h"
#include "pair/kernel_order.h"
#include "pair/posed_pair.h"
#include "paper/influence_area.h"
#include "polygon/cache_access.h"
#include "tricover/paper.h"

namespace tricover {
namespace detail {
namespace {

/// The moving centroid against the influence areas of a: two bits an edge, the side of the edge's line (sign + 1) or
/// kHeld where its bounded area holds the centroid.
constexpr std::uint64_t kHeld = 3;
constexpr std::size_t kPerWord = 32;

std::vector<std::uint64_t> influenceMask(const PolygonData& a, const IncludedPoint& centroid, double length,
                                         std::vector<EdgePosition>& held) {
  std::vector<std::uint64_t> mask((a.path.size() + kPerWord - 1) / kPerWord, 0);
  for (std::size_t r = 0; r < a.ringCount(); ++r)
    for (EdgePosition e = a.edgeBegin(r); e < a.edgeEnd(r); ++e) {
      const Vec2 &v = a.path[e], &w = a.path[e + 1];
      std::uint64_t state = kHeld;
      if (inBoundedArea(v, w, centroid.approx, length)) {
        held.push_back(e);
      } else {
        state = static_cast<std::uint64_t>(centroid.side(v, w) + 1);
      }
      mask[e / kPerWord] |= state << 2 * (e % kPerWord);
    }
  return mask;
}

/// The detailed test: an edge of a whose area holds the centroid, against the edges of b on whose ends the sign of s
/// (their side of that edge's line) changes, or isn't certain. With a margin or a tolerance an edge may be in reach
/// without a change.
bool detailedTest(const PosedPair& pair, const std::vector<EdgePosition>& held, const CollideOptions& options) {
  const bool any_edge = options.margin > 0 || options.tolerance > 0;
  std::vector<ApproxPoint> moved;
  moved.reserve(pair.b.path.size());
  for (const Vec2& p : pair.b.path) moved.push_back(pair.fromB(p));
  for (const EdgePosition i : held) {
    const ApproxPoint v = pair.fromA(pair.a.path[i]), w = pair.fromA(pair.a.path[i + 1]);
    for (std::size_t r = 0; r < pair.b.ringCount(); ++r) {
      int sign = orientFilter(v, w, moved[pair.b.edgeBegin(r)]);
      for (EdgePosition j = pair.b.edgeBegin(r); j < pair.b.edgeEnd(r); ++j) {
        const int next = orientFilter(v, w, moved[j + 1]);
        if ((any_edge || sign != next || sign == kUncertain) &&
            edgesWithin(pair, i, j, options.margin, options.tolerance, options.touching == Touching::Allowed))
          return true;
        sign = next;
      }
    }
  }
  return false;
}

/// What a MaskCache keeps: the ids of the polygons in the kernel's own order, and then, if the regions were apart, two
/// bits of the mask for each edge of the first one.
using KeptMask = std::vector<std::uint64_t>;
constexpr std::size_t kIds = 2;

/// From the second step on. The bounding discs may meet.
bool collideByPaper(const PosedPair& pair, KeptMask* kept, const CollideOptions& options) {
  if (kept != nullptr && (kept->size() < kIds || (*kept)[0] != pair.a.id || (*kept)[1] != pair.b.id))
    *kept = {pair.a.id, pair.b.id};
  // The mask, if any, was found outside every influence area, with the answer "free" (repair 1).
  const bool known = kept != nullptr && kept->size() > kIds;

  // Second step. Grown by the margin; rounded outwards, the areas by what the centroid is known to, as well.
  const IncludedPoint centroid = seenFromA(pair, pair.b.origin);
  const double length = (pair.b.reach + options.margin) * (1 + 2.1 * kLargestDefect);
  std::vector<EdgePosition> held;
  const std::vector<std::uint64_t> mask = influenceMask(pair.a, centroid, length, held);
  if (held.empty()) {
    // No edge of a touches b's bounding disc: the disc, all of b with it, lies where the centroid lies. An unchanged
    // mask is an unchanged zone, by exact signs (repair 7).
    if (known && std::equal(mask.begin(), mask.end(), kept->begin() + kIds, kept->end())) return false;
    const bool collides = locateInA(pair, pair.b.origin) != Location::Outside;
    if (kept != nullptr) {
      kept->resize(kIds);
      if (!collides) kept->insert(kept->end(), mask.begin(), mask.end());
    }
    return collides;
  }
  if (kept != nullptr) kept->resize(kIds);

  // Third step.
  return detailedTest(pair, held, options) || findContainment(pair).collides;
}

bool collideByPaper(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, KeptMask* kept,
                    const CollideOptions& options) {
  requireFiniteNotNegative(options.margin, "margin");
  requireFiniteNotNegative(options.tolerance, "tolerance");
  requireTouching(options.touching);
  requireRigid(pose_a, pose_b);
  const bool collides = inKernelOrder(
      detail::dataOf(a), pose_a, detail::dataOf(b), pose_b,
      [&](const auto&... operands) {
        if (gapOfDiscs(PosedPair(operands...), options.margin) >= 0) return false;
        return collideByPaper(PosedPair(operands...), kept, options);
      },
      [](bool) {});
  return collides &&
         (!asksForInteriors(options) || interiorsMeet(detail::dataOf(a), pose_a, detail::dataOf(b), pose_b));
}

}  // namespace
}  // namespace detail

namespace paper {

bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
             const CollideOptions& options) {
  return detail::collideByPaper(a, pose_a, b, pose_b, nullptr, options);
}

bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, MaskCache& cache,
             const CollideOptions& options) {
  return detail::collideByPaper(a, pose_a, b, pose_b, &detail::contentsOf(cache), options);
}

}  // namespace paper
}  // namespace tricover
