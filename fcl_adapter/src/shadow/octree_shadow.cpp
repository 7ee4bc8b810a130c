// SPDX-License-Identifier: BSD-3-Clause
#include <fcl/config.h>

#include "shadow/shadow.h"
#include "shape/errors.h"

#if FCL_HAVE_OCTOMAP
#include <fcl/geometry/octree/octree.h>
#endif

namespace tricover_fcl {

#if FCL_HAVE_OCTOMAP
namespace {

/// Gathers the shadows of a tree's occupied leaves, as FCL's own queries do: inner nodes below the threshold have no
/// occupied leaves, and what the tree doesn't know isn't there.
template <typename S>
void addCells(const fcl::OcTree<S>& tree, const typename fcl::OcTree<S>::OcTreeNode* node, const fcl::AABB<S>& cell,
              const Eigen::Affine3d& to_polygon, PartShadows& shadows) {
  if (!tree.isNodeOccupied(node)) return;
  const SlabCut cut = cutBox(cell.min_.template cast<double>(), cell.max_.template cast<double>(), "fcl::OcTree",
                             to_polygon, shadows.slab);
  if (cut.corners().empty()) return;
  Eigen::AlignedBox2d box;
  for (const tricover::Vec2& corner : cut.corners()) box.extend(corner);
  if (!shadows.isWanted(box)) return;
  if (!tree.nodeHasChildren(node)) shadows.add(static_cast<int>(node - tree.getRoot()), cut);
  for (unsigned int i = 0; i < 8; ++i) {
    if (!tree.nodeHasChildren(node) || !tree.nodeChildExists(node, i)) continue;
    fcl::AABB<S> child;
    fcl::computeChildBV(cell, i, child);
    addCells(tree, tree.getNodeChild(node, i), child, to_polygon, shadows);
  }
}

}  // namespace

template <typename S>
std::optional<Shadow> makeOctreeShadow(const fcl::CollisionGeometry<S>& octree, const View& view) {
  const auto& tree = static_cast<const fcl::OcTree<S>&>(octree);
  const fcl::AABB<S> all = tree.getRootBV();
  PartShadows shadows(view, mappingError(view.to_polygon, all.max_.template cast<double>().template lpNorm<1>()));
  if (tree.getRoot() != nullptr) addCells(tree, tree.getRoot(), all, view.to_polygon, shadows);
  return shadows.all();
}
#else
template <typename S>
std::optional<Shadow> makeOctreeShadow(const fcl::CollisionGeometry<S>&, const View&) {
  refuseQuestion("fcl::OcTree", "this FCL was built without octomap", "build FCL with it");
}
#endif

template std::optional<Shadow> makeOctreeShadow(const fcl::CollisionGeometry<float>&, const View&);
template std::optional<Shadow> makeOctreeShadow(const fcl::CollisionGeometry<double>&, const View&);

}  // namespace tricover_fcl
