// SPDX-License-Identifier: BSD-3-Clause
#include "shadow/slab_cut.h"

#include <algorithm>
#include <string>

#include "shape/errors.h"

namespace tricover_fcl {

using tricover::Ring;
using tricover::Vec2;

Ring convexHull(const std::vector<Vec2>& points) {
  // Seen from the first point and scaled to 1, because products of the coordinates themselves may over- or underflow.
  struct Seen {
    Vec2 at;
    const Vec2* point;
  };
  std::vector<Seen> seen;
  double size = 0;
  for (const Vec2& p : points) {
    seen.push_back({0.25 * p - 0.25 * points.front(), &p});
    size = std::max(size, seen.back().at.lpNorm<Eigen::Infinity>());
  }
  if (size == 0) return Ring(3, points.front());
  for (Seen& s : seen) s.at /= size;
  std::sort(seen.begin(), seen.end(), [](const Seen& s, const Seen& t) {
    return s.at.x() != t.at.x() ? s.at.x() < t.at.x() : s.at.y() < t.at.y();
  });

  // Andrew's monotone chain: the lower half from left to right, then the upper one back.
  const auto turnsLeft = [](const Seen& p, const Seen& q, const Seen& r) {
    const Vec2 u = q.at - p.at, v = r.at - p.at;
    return u.x() * v.y() - u.y() * v.x() > 0;
  };
  std::vector<Seen> chain;
  const auto addHalf = [&](auto first, auto last) {
    const std::size_t start = chain.size();
    for (; first != last; ++first) {
      while (chain.size() >= start + 2 && !turnsLeft(chain[chain.size() - 2], chain.back(), *first)) chain.pop_back();
      chain.push_back(*first);
    }
    chain.pop_back();  // the other half starts with it
  };
  addHalf(seen.begin(), seen.end());
  addHalf(seen.rbegin(), seen.rend());

  Ring ring;
  for (const Seen& s : chain) ring.push_back(*s.point);
  while (ring.size() < 3) ring.push_back(ring.back());
  return ring;
}

void SlabCut::addCrossing(const Eigen::Vector3d& p, const Eigen::Vector3d& q, double z) {
  if ((p.z() < z) == (q.z() < z) || p.z() == z || q.z() == z) return;  // an end in the plane is a vertex already
  const double share = (z - p.z()) / (q.z() - p.z());
  corners_.push_back(p.head<2>() + share * (q - p).head<2>());
}

Eigen::Vector3d mapVertex(const Eigen::Affine3d& to_polygon, const Eigen::Vector3d& vertex, const char* geometry,
                          std::size_t index) {
  const Eigen::Vector3d mapped = to_polygon * vertex;
  if (!mapped.allFinite()) {
    refuse(geometry + (": vertex " + std::to_string(index)), "it is not finite, or not where the poses put it");
  }
  return mapped;
}

std::vector<Vec2> cutBox(const Eigen::Vector3d& low, const Eigen::Vector3d& high, const char* geometry,
                         const Eigen::Affine3d& to_polygon, const Slab& slab) {
  Eigen::Vector3d corners[8];
  SlabCut cut(slab);
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner((i & 1 ? high : low).x(), (i & 2 ? high : low).y(), (i & 4 ? high : low).z());
    corners[i] = mapVertex(to_polygon, corner, geometry, static_cast<std::size_t>(i));
    cut.addVertex(corners[i]);
    for (const int axis : {1, 2, 4}) {
      if (i & axis) cut.addEdge(corners[i - axis], corners[i]);
    }
  }
  return cut.corners();
}

}  // namespace tricover_fcl
