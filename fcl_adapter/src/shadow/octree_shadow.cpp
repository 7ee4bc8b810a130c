// SPDX-License-Identifier: BSD-3-Clause
#include <fcl/config.h>

#include "shadow/shadow.h"
#include "shape/convex_hull.h"
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
class CellCollector {
 public:
  CellCollector(const fcl::OcTree<S>& tree, const View& view)
      : tree_(tree),
        to_polygon_(view.to_polygon),
        rounding_(mappingError(view.to_polygon, tree.getRootBV().max_.template cast<double>().template lpNorm<1>())),
        polygon_slab_(view.slab),
        slab_(grown(view.slab, rounding_)),
        around_(view.around.min().array() - 2 * rounding_, view.around.max().array() + 2 * rounding_),
        only_there_(view.only_there) {}

  std::optional<Shadow> collect() {
    const typename fcl::OcTree<S>::OcTreeNode* root = tree_.getRoot();
    if (root != nullptr) visit(root, tree_.getRootBV());
    if (rings_.empty()) return std::nullopt;
    return Shadow(tricover::Polygon(std::move(rings_), tricover::FillRule::NonZero), rounding_,
                  heights_.sharedWith(polygon_slab_), std::move(parts_));
  }

 private:
  void visit(const typename fcl::OcTree<S>::OcTreeNode* node, const fcl::AABB<S>& cell) {
    if (!tree_.isNodeOccupied(node)) return;
    const SlabCut cut =
        cutBox(cell.min_.template cast<double>(), cell.max_.template cast<double>(), "fcl::OcTree", to_polygon_, slab_);
    const std::vector<tricover::Vec2>& corners = cut.corners();
    if (corners.empty()) return;
    Eigen::AlignedBox2d box;
    for (const tricover::Vec2& corner : corners) box.extend(corner);
    if (only_there_ && !around_.intersects(box)) return;

    if (!tree_.nodeHasChildren(node)) {
      rings_.push_back(convexHull(corners));
      heights_ = united(heights_, cut.heights());
      parts_.push_back({static_cast<int>(node - tree_.getRoot()), rings_.back().size()});
      return;
    }
    for (unsigned int i = 0; i < 8; ++i) {
      if (!tree_.nodeChildExists(node, i)) continue;
      fcl::AABB<S> child;
      fcl::computeChildBV(cell, i, child);
      visit(tree_.getNodeChild(node, i), child);
    }
  }

  const fcl::OcTree<S>& tree_;
  Eigen::Affine3d to_polygon_;
  double rounding_;
  Slab polygon_slab_, slab_, heights_ = kNoHeights;
  Eigen::AlignedBox2d around_;
  bool only_there_;
  std::vector<tricover::Ring> rings_;
  std::vector<Shadow::Part> parts_;
};

}  // namespace

template <typename S>
std::optional<Shadow> makeOctreeShadow(const fcl::CollisionGeometry<S>& octree, const View& view) {
  return CellCollector<S>(static_cast<const fcl::OcTree<S>&>(octree), view).collect();
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
