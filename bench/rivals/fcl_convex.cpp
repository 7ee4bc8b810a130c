// SPDX-License-Identifier: BSD-3-Clause
#include "fcl_convex.h"

namespace tricover::bench {
namespace {

Ring allVertices(const Polygon& polygon) {
  Ring all;
  for (const Ring& ring : polygon.rings()) all.insert(all.end(), ring.begin(), ring.end());
  return all;
}

}  // namespace

FclPieces::Box::Box(const Ring& ring) {
  Vec2 low = ring[0], high = ring[0];
  for (const Vec2& v : ring) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  center = (low + high) / 2;
  half = (high - low) / 2;
}

FclPieces::Pieces::Pieces(const Polygon& polygon, double half_height) : whole(allVertices(polygon)) {
  for (const Ring& ring : convexPieces(triangulate(polygon))) {
    prisms.push_back(makePrism(ring, half_height));
    boxes.emplace_back(ring);
  }
}

FclPieces::FclPieces(const Polygon& fixed, const Polygon& moving)
    : fixed_(fixed, kHalfHeight), moving_(moving, 2 * kHalfHeight) {}

void FclPieces::prepare(const std::vector<Pose>& poses) {
  poses_ = poses;
  transforms_ = toTransforms(poses);
}

std::size_t FclPieces::decidedByBoxes() {
  std::size_t count = 0;
  for (std::size_t i = 0; i < poses_.size(); ++i)
    count += anyPair(i, [](const Prism&, const Prism&) { return true; }) ? 0 : 1;
  return count;
}

}  // namespace tricover::bench
