// SPDX-License-Identifier: BSD-3-Clause
// Each of two plugins has a static tricover; plain fcl::collide and fcl::distance are asked about polygons of both.
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>
#include <tricover_fcl/tricover_fcl.h>

#include <cmath>
#include <cstdio>

namespace {

using tricover::Polygon;
using tricover_fcl::PolygonShaped;

Polygon square(double half) { return Polygon({{{-half, -half}, {half, -half}, {half, half}, {-half, half}}}); }

}  // namespace

/// A shape over the first polygon of this copy of tricover.
extern "C" __attribute__((visibility("default"))) const void* makeFirst(double half) {
  static const PolygonShaped first(square(half));
  return &first;
}

/// Squares of half sides 0.5 and 2, of either copy, beside one of this copy that only the large square meets. The poses
/// stay where they are, as those of two objects do.
extern "C" __attribute__((visibility("default"))) bool askAboutBoth(const void* of_one, const void* of_other) {
  tricover_fcl::registerNarrowphase();
  const PolygonShaped* const shapes[] = {static_cast<const PolygonShaped*>(of_one),
                                         static_cast<const PolygonShaped*>(of_other)};
  const PolygonShaped beside(square(0.5));
  const fcl::Transform3d here = fcl::Transform3d::Identity();
  // In reach of the discs around the squares, so that these don't decide.
  fcl::Transform3d there = here;
  there.translation() << 1.1, 0, 0;
  bool is_right = true;
  for (int i = 0; i < 6; ++i) {
    const bool is_large = i % 2 == 1;
    fcl::CollisionResultd collision;
    const bool is_hit = fcl::collide(shapes[i % 2], here, &beside, there, fcl::CollisionRequestd(), collision) > 0;
    fcl::DistanceResultd distance;
    fcl::distance(shapes[i % 2], here, &beside, there, fcl::DistanceRequestd(), distance);
    if (is_hit == is_large && (is_large ? distance.min_distance == -1 : std::abs(distance.min_distance - 0.1) < 1e-12))
      continue;
    std::printf("wrong of the %s square: %d, %g\n", is_large ? "large" : "small", is_hit, distance.min_distance);
    is_right = false;
  }
  return is_right;
}
