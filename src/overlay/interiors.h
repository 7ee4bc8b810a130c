// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "overlay/edge_sides.h"
#include "pair/certificate.h"
#include "pair/collide.h"
#include "polygon/polygon_data.h"
#include "tricover/collide_options.h"

namespace tricover::detail {

/// Whether a point of one of the posed regions is in the interior of the other one. Exact, in whatever order the
/// operands are.
bool interiorsMeet(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b);

/// Whether an operand's edge, of a ring that is a point, is in the interior of the other region. The other's edges that
/// it is on are seams then. Exact.
bool isInInterior(const PosedPair& pair, EdgeSides::Operand operand, EdgePosition edge, KnownSides& sides);

/// Whether that is what a query asks. With a margin it asks for a distance below it, edge by edge. With a tolerance
/// touching is within it, and may collide.
inline bool asksForInteriors(const CollideOptions& options) {
  return options.touching == Touching::Allowed && options.margin == 0 && options.tolerance == 0;
}

/// collide() with a margin of 0 or more, for operands and options that have been checked. `defect` is defectOf() the
/// poses. The cache may be null.
inline bool regionsCollide(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                           double defect, Certificate* cache, const CollideOptions& options) {
  if (!asksForInteriors(options)) return collide(a, pose_a, b, pose_b, defect, cache, options);
  return collide(a, pose_a, b, pose_b, defect, cache, {}) && interiorsMeet(a, pose_a, b, pose_b);
}

/// findCertificate(), where touching may be allowed.
Outcome findCertificateOf(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                          double defect, const CollideOptions& options, const CertificateWish& wish);

}  // namespace tricover::detail
