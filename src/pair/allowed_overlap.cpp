// SPDX-License-Identifier: BSD-3-Clause
#include "pair/allowed_overlap.h"

#include <algorithm>

#include "pair/discs.h"
#include "polygon/convexity.h"
#include "tricover/penetration.h"

namespace tricover::detail {
namespace {

/// A search for the shortest translation would take too long beyond.
constexpr std::size_t kMostVertices = 4096;

}  // namespace

/// The local depth of a component is at least the width of its hull: where it is small, the overlap is thin. Where it
/// is large, as of a crate in a room's corner, a short translation may still separate the regions.
std::vector<Contact> allowedOverlap(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                                    double allowed, double error) {
  ContactOptions options;
  options.detail = ContactDetail::LocalDepth;
  std::vector<Contact> found = contacts(a, pose_a, b, pose_b, options);
  if (found.empty() || found.front().depth < allowed - error) return found;
  const PosedPair pair(a.data(), pose_a, b.data(), pose_b);
  if (cornersOf(pair.a) != nullptr && cornersOf(pair.b) != nullptr) return found;
  if (pair.a.fill.is_complement || pair.b.fill.is_complement) return found;
  if (pair.a.path.size() + pair.b.path.size() > kMostVertices) return found;
  Contact& deepest = found.front();
  if (const double least = depthOfDiscs(pair, 0); least > allowed) {
    deepest.depth = std::min(deepest.depth, least);
    return found;
  }
  const std::optional<Penetration> way = penetration(a, pose_a, b, pose_b);
  if (!way || !(way->depth < deepest.depth)) return found;
  deepest.point = way->point_a / 2 + way->point_b / 2;
  deepest.normal = way->normal;
  deepest.depth = way->depth;
  deepest.edge_a = way->edge_a;
  deepest.edge_b = way->edge_b;
  return {deepest};
}

}  // namespace tricover::detail
