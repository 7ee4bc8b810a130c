// SPDX-License-Identifier: BSD-3-Clause
#include "fcl_convex.h"

#include <algorithm>
#include <limits>

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

std::size_t FclPieces::decidedAtOnce() {
  const auto reach = [](const Prism& prism, const Vec2& way) {
    double most = -std::numeric_limits<double>::infinity();
    for (const fcl::Vector3d& v : prism.getVertices()) most = std::max(most, way.dot(v.head<2>()));
    return most;
  };
  const bool is_one_pair = fixed_.prisms.size() * moving_.prisms.size() == 1;
  std::size_t count = 0;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const Vec2 way = poses_[i] * moving_.whole.center - fixed_.whole.center,
               back = -poses_[i].linear().transpose() * way;
    const auto meet = [&](const Prism& a, const Prism& b) {
      return !is_one_pair || reach(a, way) + reach(b, back) >= way.dot(poses_[i].translation());
    };
    if (!anyPair(i, meet)) ++count;
  }
  return count;
}

}  // namespace tricover::bench
