// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree_array.h>
#include <fcl/math/motion/interp_motion.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "fcl_geometry.h"
#include "tricover/motion.h"

/// Any two geometries, ours or FCL's, asked by FCL's unmodified entry points, as their users do.
namespace tricover::bench {

/// fcl::collide and fcl::distance, in either order of the operands, with either solver.
class FclCall : public FclPosed {
 public:
  FclCall(const Geometry& fixed, const Geometry& moving, fcl::GJKSolverType solver = fcl::GST_LIBCCD,
          bool swapped = false)
      : fixed_(fixed), moving_(moving), first_(swapped ? &moving_ : &fixed_), second_(swapped ? &fixed_ : &moving_) {
    request_.gjk_solver_type = distance_request_.gjk_solver_type = solver;
  }
  FclCall(const FclCall&) = delete;
  FclCall& operator=(const FclCall&) = delete;

  bool collide(std::size_t i) {
    result_.clear();
    moving_.setTransform(transforms_[i]);
    return fcl::collide(first_, second_, request_, result_) > 0;
  }
  /// FCL's solvers throw where they lose their way: that is a wrong answer, NaN.
  double value(std::size_t i) {
    distance_result_.clear();
    moving_.setTransform(transforms_[i]);
    try {
      return std::max(fcl::distance(first_, second_, distance_request_, distance_result_), 0.0);
    } catch (const std::exception&) {
      return std::numeric_limits<double>::quiet_NaN();
    }
  }

 private:
  fcl::CollisionObjectd fixed_, moving_, *first_, *second_;
  fcl::CollisionRequestd request_;
  fcl::CollisionResultd result_;
  fcl::DistanceRequestd distance_request_;
  fcl::DistanceResultd distance_result_;
};

/// FCL's conservative advancement of meshes stops at this, whatever toc_err it is asked for.
constexpr double kTimeError = 1e-5;

/// fcl::continuousCollide by conservative advancement; the fixed one stays where it is.
class FclAdvancement {
 public:
  FclAdvancement(Geometry fixed, Geometry moving, const fcl::Transform3d& at = fcl::Transform3d::Identity())
      : fixed_(std::move(fixed)),
        moving_(std::move(moving)),
        still_(at.linear(), at.translation(), at.linear(), at.translation(), fcl::Vector3d::Zero()) {
    request_.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    request_.toc_err = kTimeError;
    request_.num_max_iterations = 100000;
  }

  void prepare(const std::vector<Motion>& motions) {
    motions_.clear();
    for (const Motion& motion : motions) {
      const fcl::Transform3d start = toTransform(motion.start), end = toTransform(motion.at(1));
      motions_.emplace_back(start.linear(), start.translation(), end.linear(), end.translation(),
                            fcl::Vector3d(motion.pivot.x(), motion.pivot.y(), 0));
    }
  }

  /// Infinity where they don't meet.
  double value(std::size_t i) {
    still_.integrate(0);
    motions_[i].integrate(0);
    fcl::ContinuousCollisionResultd result;
    fcl::continuousCollide<double>(fixed_.get(), &still_, moving_.get(), &motions_[i], request_, result);
    return result.is_collide ? result.time_of_contact : std::numeric_limits<double>::infinity();
  }

 private:
  Geometry fixed_, moving_;
  fcl::InterpMotion<double> still_;
  std::vector<fcl::InterpMotion<double>> motions_;
  fcl::ContinuousCollisionRequestd request_;
};

using FclManager = std::unique_ptr<fcl::BroadPhaseCollisionManagerd>;

/// FCL's two fastest managers. (SSaP, the interval tree and the hash took 1.1 to 260 times as long, wherever they were
/// timed; SaP loses pairs or hangs after rotations.)
inline FclManager makeFclManager(bool array_tree) {
  if (array_tree) return std::make_unique<fcl::DynamicAABBTreeCollisionManager_Arrayd>();
  return std::make_unique<fcl::DynamicAABBTreeCollisionManagerd>();
}

}  // namespace tricover::bench
