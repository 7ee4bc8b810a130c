// SPDX-License-Identifier: BSD-3-Clause
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/convex.h>

#include <algorithm>

#include "shadow/shadow.h"
#include "shape/convex_hull.h"

namespace tricover_fcl {
namespace {

std::optional<Shadow> shadowOf(const SlabCut& cut, double rounding, const View& view) {
  if (cut.corners().empty()) return std::nullopt;
  return shadowOf(outlineOf(convexHull(cut.corners())), rounding, cut.heights(), view);
}

template <typename S>
std::optional<Shadow> shadowOf(const fcl::Box<S>& box, const View& view) {
  const Eigen::Vector3d half = 0.5 * box.side.template cast<double>();
  const double rounding = mappingError(view.to_polygon, half.lpNorm<1>());
  return shadowOf(cutBox(-half, half, "fcl::Box", view.to_polygon, grown(view.slab, rounding)), rounding, view);
}

template <typename S>
std::optional<Shadow> shadowOf(const fcl::Convex<S>& convex, const View& view) {
  double reach = 0;
  std::vector<Eigen::Vector3d> vertices;
  for (const fcl::Vector3<S>& vertex : convex.getVertices()) {
    vertices.push_back(vertex.template cast<double>());
    reach = std::max(reach, vertices.back().template lpNorm<1>());
  }
  const double rounding = mappingError(view.to_polygon, reach);

  SlabCut cut(grown(view.slab, rounding));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    vertices[i] = mapVertex(view.to_polygon, vertices[i], "fcl::Convex", i);
    cut.addVertex(vertices[i]);
  }
  // Each face is said as the number of its vertices and their indices.
  const std::vector<int>& faces = convex.getFaces();
  const auto vertexAt = [&](std::size_t i) { return vertices[static_cast<std::size_t>(faces[i])]; };
  for (std::size_t face = 0, next; face < faces.size(); face = next) {
    next = face + 1 + static_cast<std::size_t>(faces[face]);
    for (std::size_t i = face + 1; i < next; ++i) cut.addEdge(vertexAt(i), vertexAt(i + 1 < next ? i + 1 : face + 1));
  }
  return shadowOf(cut, rounding, view);
}

}  // namespace

template <typename S>
std::optional<Shadow> makeSolidShadow(const fcl::CollisionGeometry<S>& box_or_convex, const View& view) {
  if (box_or_convex.getNodeType() == fcl::GEOM_BOX)
    return shadowOf(static_cast<const fcl::Box<S>&>(box_or_convex), view);
  return shadowOf(static_cast<const fcl::Convex<S>&>(box_or_convex), view);
}

template std::optional<Shadow> makeSolidShadow(const fcl::CollisionGeometry<float>&, const View&);
template std::optional<Shadow> makeSolidShadow(const fcl::CollisionGeometry<double>&, const View&);

}  // namespace tricover_fcl
