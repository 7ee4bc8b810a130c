// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "exact_reference.h"
#include "random.h"
#include "tricover/ray.h"

/// Rays where signs vanish, and what castRay() promises of them.
namespace tricover::support {

struct Ray {
  Vec2 from, to;
};

/// Through the region, along an edge, past a vertex, or anyhow; mostly from outside.
Ray anyRay(Random& random, const Polygon& polygon, const Pose& pose);

/// The edge that results name for this one: itself or, if it has no length, the next one of its ring that has a length.
EdgeIndex namedEdge(const Polygon& polygon, EdgeIndex edge);

/// What is wrong with a hit where there is one; empty if it is right.
std::string wrongHit(const Polygon& polygon, const Pose& pose, const Ray& ray, const RayHit& hit,
                     const exact::FirstHit& truth);

/// What is wrong with the intervals in the region; empty if they are right. Beside the truth, the first one begins with
/// castRay()'s hit, and the way back meets the same edges.
std::string wrongIntervals(const Polygon& polygon, const Pose& pose, const Ray& ray,
                           const std::vector<RayInterval>& intervals, const std::vector<exact::RayPart>& truth);

}  // namespace tricover::support
