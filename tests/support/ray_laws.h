// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

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

}  // namespace tricover::support
