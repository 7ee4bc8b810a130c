// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "measure.h"
#include "tricover/polygon.h"

namespace tricover::bench {

/// A moving polygon's way past a fixed one, which stays at the identity.
struct Passage {
  Polygon fixed, moving;
  std::vector<Pose> poses;
};

/// tricover's core: without coherence (the reference), with a PairCache, and the paper's Algorithm 3.
std::vector<Contender> coreContenders(std::shared_ptr<const Passage> passage);

/// The same polygons inside FCL: tricover and an empty call through fcl::collide, and FCL's own ways: GJK of either
/// solver on convex pieces, and a BVH of triangles.
std::vector<Contender> fclContenders(std::shared_ptr<const Passage> passage);

}  // namespace tricover::bench
