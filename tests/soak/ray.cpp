// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/ray.h"

#include <optional>
#include <string>

#include "cases.h"
#include "exact_reference.h"
#include "ray_laws.h"
#include "reproduction.h"
#include "soak.h"
#include "tricover/segment.h"

namespace tricover::soak {

/// castRay() and castRayAll() against the exact first point and the exact intervals: rays through vertices, along
/// edges, from far away, that end where they hit.
void soakRay(Run& run) {
  while (run.next()) {
    Random& random = run.random();
    const Drawn drawn = anyCase(random);
    for (const bool at_a : {true, false}) {
      const Polygon& polygon = at_a ? drawn.c.a : drawn.c.b;
      const Pose& pose = at_a ? drawn.c.pose_a : drawn.c.pose_b;
      const support::Ray ray = support::anyRay(random, polygon, pose);
      if (!ray.from.allFinite() || !ray.to.allFinite()) continue;
      const std::optional<exact::FirstHit> truth = exact::castRay(polygon, pose, ray.from, ray.to);
      const std::optional<RayHit> hit = castRay(polygon, pose, ray.from, ray.to);
      run.count(drawn.family, truth.has_value());
      std::string problem = hit.has_value() != truth.has_value() ? "hit or not"
                            : hit                                ? support::wrongHit(polygon, pose, ray, *hit, *truth)
                                                                 : "";
      if (problem.empty())
        problem = support::wrongIntervals(polygon, pose, ray, castRayAll(polygon, pose, ray.from, ray.to),
                                          exact::castRayAll(polygon, pose, ray.from, ray.to));
      if (!problem.empty())
        run.fail(drawn.family, problem + ", the ray is b's edge 0",
                 support::reproduction({polygon, pose, segment(ray.from, ray.to), Pose::Identity()}));
    }
  }
}

}  // namespace tricover::soak
