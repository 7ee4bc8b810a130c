// SPDX-License-Identifier: BSD-3-Clause
#include <fcl/narrowphase/collision.h>

#include "fcl_call.h"

namespace tricover::bench {
namespace {

using Solver = fcl::detail::GJKSolver_libccdd;

class EmptyGeometry : public fcl::CollisionGeometryd {
 public:
  fcl::OBJECT_TYPE getObjectType() const override { return fcl::OT_GEOM; }
  void computeLocalAABB() override {
    aabb_local = fcl::AABBd(fcl::Vector3d::Zero());
    aabb_center.setZero();
    aabb_radius = 0;
  }
};

std::size_t answerNothing(const fcl::CollisionGeometryd*, const fcl::Transform3d&, const fcl::CollisionGeometryd*,
                          const fcl::Transform3d&, const Solver*, const fcl::CollisionRequestd&,
                          fcl::CollisionResultd&) {
  return 0;
}

}  // namespace

std::shared_ptr<fcl::CollisionGeometryd> emptyGeometry() {
  // A slot that neither FCL nor tricover uses.
  fcl::getCollisionFunctionLookTable<Solver>().collision_matrix[fcl::BV_UNKNOWN][fcl::BV_UNKNOWN] = answerNothing;
  return std::make_shared<EmptyGeometry>();
}

}  // namespace tricover::bench
