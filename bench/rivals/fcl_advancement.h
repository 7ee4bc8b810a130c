// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/math/motion/interp_motion.h>
#include <fcl/narrowphase/continuous_collision.h>

#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "fcl_geometry.h"
#include "tricover/motion.h"

namespace tricover::bench {

/// What FCL's conservative advancement of meshes stops at, whatever toc_err it is asked for.
constexpr double kTimeError = 1e-5;

/// No contact, in place of a time.
constexpr double kNever = std::numeric_limits<double>::infinity();

/// fcl::continuousCollide by conservative advancement on any two geometries; the fixed one stays where it is.
class FclAdvancement {
 public:
  using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;

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

  double value(std::size_t i) {
    still_.integrate(0);
    motions_[i].integrate(0);
    fcl::ContinuousCollisionResultd result;
    fcl::continuousCollide<double>(fixed_.get(), &still_, moving_.get(), &motions_[i], request_, result);
    return result.is_collide ? result.time_of_contact : kNever;
  }

 private:
  Geometry fixed_, moving_;
  fcl::InterpMotion<double> still_;
  std::vector<fcl::InterpMotion<double>> motions_;
  fcl::ContinuousCollisionRequestd request_;
};

}  // namespace tricover::bench
