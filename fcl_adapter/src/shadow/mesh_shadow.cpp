// SPDX-License-Identifier: BSD-3-Clause
#include <fcl/geometry/bvh/BVH_model.h>

#include <algorithm>

#include "shadow/shadow.h"
#include "shape/errors.h"

namespace tricover_fcl {
namespace {

/// A mesh is the surface that its triangles make, without an inside, as for FCL. Linear in the mesh: one pass maps the
/// vertices, one looks at each triangle's box.
template <typename BV, typename S = typename BV::S>
std::optional<Shadow> shadowOf(const fcl::CollisionGeometry<S>& geometry, const View& view) {
  const auto& mesh = static_cast<const fcl::BVHModel<BV>&>(geometry);
  if (mesh.num_tris == 0) refuse("fcl::BVHModel", "a mesh without triangles has no surface");

  double reach = 0;
  std::vector<Eigen::Vector3d> vertices(static_cast<std::size_t>(mesh.num_vertices));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Eigen::Vector3d vertex = mesh.vertices[i].template cast<double>();
    reach = std::max(reach, vertex.template lpNorm<1>());
    vertices[i] = mapVertex(view.to_polygon, vertex, "fcl::BVHModel", i);
  }
  PartShadows shadows(view, mappingError(view.to_polygon, reach));
  for (int i = 0; i < mesh.num_tris; ++i) {
    const fcl::Triangle& triangle = mesh.tri_indices[i];
    const Eigen::Vector3d corners[] = {vertices[triangle[0]], vertices[triangle[1]], vertices[triangle[2]]};
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& corner : corners) box.extend(corner);
    if (box.min().z() > shadows.slab.high || box.max().z() < shadows.slab.low) continue;
    if (!shadows.isWanted({box.min().head<2>(), box.max().head<2>()})) continue;

    SlabCut cut(shadows.slab);
    for (int k = 0; k < 3; ++k) {
      cut.addVertex(corners[k]);
      cut.addEdge(corners[k], corners[(k + 1) % 3]);
    }
    shadows.add(i, cut);
  }
  std::optional<Shadow> shadow = shadows.all();
  if (shadow) shadow->is_surface = true;
  return shadow;
}

}  // namespace

template <typename S>
std::optional<Shadow> makeMeshShadow(const fcl::CollisionGeometry<S>& mesh, const View& view) {
  switch (mesh.getNodeType()) {
    case fcl::BV_AABB:
      return shadowOf<fcl::AABB<S>>(mesh, view);
    case fcl::BV_OBB:
      return shadowOf<fcl::OBB<S>>(mesh, view);
    case fcl::BV_RSS:
      return shadowOf<fcl::RSS<S>>(mesh, view);
    case fcl::BV_kIOS:
      return shadowOf<fcl::kIOS<S>>(mesh, view);
    case fcl::BV_OBBRSS:
      return shadowOf<fcl::OBBRSS<S>>(mesh, view);
    case fcl::BV_KDOP16:
      return shadowOf<fcl::KDOP<S, 16>>(mesh, view);
    case fcl::BV_KDOP18:
      return shadowOf<fcl::KDOP<S, 18>>(mesh, view);
    default:
      return shadowOf<fcl::KDOP<S, 24>>(mesh, view);
  }
}

template std::optional<Shadow> makeMeshShadow(const fcl::CollisionGeometry<float>&, const View&);
template std::optional<Shadow> makeMeshShadow(const fcl::CollisionGeometry<double>&, const View&);

}  // namespace tricover_fcl
