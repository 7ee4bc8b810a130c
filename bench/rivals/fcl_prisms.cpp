// SPDX-License-Identifier: BSD-3-Clause
#include "fcl_prisms.h"

#include <algorithm>
#include <limits>

namespace tricover::bench {

FclPieces::Pieces::Pieces(const Polygon& polygon, double half_height, bool one) : whole(polygon.bounds()) {
  for (const Ring& ring : one ? std::vector<Ring>{polygon.rings()[0]} : convexPieces(triangulate(polygon))) {
    Eigen::AlignedBox2d box;
    for (const Vec2& v : ring) box.extend(v);
    prisms.push_back(support::makePrism(ring, half_height));
    boxes.emplace_back(box);
  }
}

FclPieces::FclPieces(const Polygon& fixed, const Polygon& moving, const Prisms& prisms)
    : FclPosed(prisms.fixed_pose),
      fixed_(fixed, prisms.half_height, prisms.one_each),
      moving_(moving, 2 * prisms.half_height, prisms.one_each) {}

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
