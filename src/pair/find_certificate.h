// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "pair/certificate.h"
#include "pair/outcome.h"
#include "polygon/polygon_data.h"
#include "tricover/collide.h"

namespace tricover::detail {

/// What finding a certificate is to look for.
struct CertificateWish {
  double lookahead;                         ///< the clearance, beyond the margin, that is of use
  bool wants_clearance;                     ///< false: a clearance would be of no use
  std::ptrdiff_t edge_a = -1, edge_b = -1;  ///< tried first, unless -1
};

/// Finds what a Certificate says of these poses: an Outcome whose clearance is a world length, 0 of a hit by the
/// margin or the tolerance alone. Operands in the kernel's order, all arguments checked.
Outcome findCertificate(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                        const CollideOptions& options, const CertificateWish& wish);

/// After recall(): keeps a new certificate if one may be of use, and returns its answer.
std::optional<bool> renewCertificate(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                                     Certificate& cache, const Recollection& recollection,
                                     const CollideOptions& options);

}  // namespace tricover::detail
