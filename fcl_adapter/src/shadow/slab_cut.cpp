// SPDX-License-Identifier: BSD-3-Clause
#include "shadow/slab_cut.h"

#include <string>

#include "shape/errors.h"

namespace tricover_fcl {

void SlabCut::addCrossing(const Eigen::Vector3d& p, const Eigen::Vector3d& q, double z) {
  if ((p.z() < z) == (q.z() < z) || p.z() == z || q.z() == z) return;  // an end in the plane is a vertex already
  const double share = (z - p.z()) / (q.z() - p.z());
  add(p.head<2>() + share * (q - p).head<2>(), z);
}

Eigen::Vector3d mapVertex(const Eigen::Affine3d& to_polygon, const Eigen::Vector3d& vertex, const char* geometry,
                          std::size_t index) {
  const Eigen::Vector3d mapped = to_polygon * vertex;
  if (!mapped.allFinite()) {
    refuse(geometry + (": vertex " + std::to_string(index)), "it is not finite, or not where the poses put it");
  }
  return mapped;
}

SlabCut cutBox(const Eigen::Vector3d& low, const Eigen::Vector3d& high, const char* geometry,
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
  return cut;
}

}  // namespace tricover_fcl
