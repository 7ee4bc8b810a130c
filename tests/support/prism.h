// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/shape/convex.h>

#include <memory>
#include <vector>

#include "tricover/polygon.h"

namespace tricover::support {

/// A convex ring as FCL's solvers want it: a body from -half_height to half_height, its faces seen from outside.
inline std::shared_ptr<fcl::Convexd> makePrism(const Ring& convex_ring, double half_height) {
  const int n = static_cast<int>(convex_ring.size());
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const double z : {-half_height, half_height}) {
    for (const Vec2& v : convex_ring) vertices->emplace_back(v.x(), v.y(), z);
  }
  auto faces = std::make_shared<std::vector<int>>();
  faces->push_back(n);
  for (int i = n; i-- > 0;) faces->push_back(i);
  faces->push_back(n);
  for (int i = 0; i < n; ++i) faces->push_back(n + i);
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    faces->insert(faces->end(), {4, i, next, n + next, n + i});
  }
  auto prism = std::make_shared<fcl::Convexd>(vertices, n + 2, faces);
  prism->computeLocalAABB();
  return prism;
}

}  // namespace tricover::support
