// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "numbers/double2.h"
#include "pair/outcome.h"
#include "polygon/cache_contents.h"
#include "polygon/polygon_data.h"
#include "tricover/collide.h"

namespace tricover::detail {

/// What a cache's certificate says of a query.
struct Recollection {
  bool certain;  ///< `collides` is the answer
  bool collides;
  bool known;  ///< the cache is this pair's
  /// Whether the next certificate is likely to be of use: the polygons have not jumped since.
  bool coherent;
  double lookahead;  ///< the clearance, beyond the margin, that would pay for a good many steps like the last ones
};

inline bool sameAs(const double (&kept)[6], const Pose& pose) {
  const double* m = pose.data();
  const Double2 difference = absolute(load2(m) - load2(kept)) + absolute(load2(m + 3) - load2(kept + 2)) +
                             absolute(load2(m + 6) - load2(kept + 4));
  return difference[0] + difference[1] == 0;
}

/// Keeps a pose with a certificate.
void store(double (&kept)[6], const Pose& pose);

/// How far any point of a polygon's bounding disc is at most, in the world, from where it was at the kept pose; 0 if
/// that is the same pose.
double displacement(const PolygonData& polygon, const double (&kept)[6], const Pose& pose);

/// Throws for a pose that isn't rigid. One that equals the certificate's pose to the last bit, has been checked.
Recollection recall(Certificate& cache, const PolygonData& a, const Pose& pose_a, const PolygonData& b,
                    const Pose& pose_b, double margin);

/// Makes the cache one of these two polygons; empties it if it was another pair's.
void claim(Certificate& cache, const PolygonData& first, const PolygonData& second);

/// Keeps a new certificate of these poses.
void remember(Certificate& cache, const PolygonData& first, const Pose& first_pose, const PolygonData& second,
              const Pose& second_pose, bool overlapping, double clearance);
/// Keeps the poses alone: the next query then knows how far the polygons have moved.
void rememberPoses(Certificate& cache, const PolygonData& first, const Pose& first_pose, const PolygonData& second,
                   const Pose& second_pose);

/// Counts a query during a back-off. The last one keeps its poses.
inline void countDown(Certificate& cache, const PolygonData& first, const Pose& first_pose, const PolygonData& second,
                      const Pose& second_pose) {
  if (--cache.back_off.left == 0) rememberPoses(cache, first, first_pose, second, second_pose);
}

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
