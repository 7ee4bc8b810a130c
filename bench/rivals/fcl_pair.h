// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/math/motion/interp_motion.h>
#include <fcl/math/motion/motion_base.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

/// Any two geometries, ours or FCL's, asked by FCL's unmodified entry points, in either order, with either solver.
namespace tricover::bench {

using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;
using Poses = std::vector<fcl::Transform3d>;  ///< of the moving body; the fixed one stays at the identity

/// Of both bodies; the one motion with the index i belongs to the other one.
struct Motions {
  std::vector<fcl::InterpMotion<double>> fixed, moving;
};

/// What FCL's conservative advancement of two shapes stops at, whatever toc_err it is asked for.
constexpr double kShapeTimeError = 1e-4;

/// FCL's solvers throw where they lose their way: that is a wrong answer, NaN.
template <class Ask>
double answered(Ask ask) {
  try {
    return ask();
  } catch (const std::exception&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

template <typename Request, typename Result>
class ObjectPair {
 public:
  ObjectPair(const Geometry& fixed, const Geometry& moving, std::shared_ptr<const Poses> poses,
             fcl::GJKSolverType solver, bool swapped)
      : poses_(std::move(poses)), fixed_(fixed), moving_(moving), swapped_(swapped) {
    request_.gjk_solver_type = solver;
  }

 protected:
  /// What `query` answers with the moving body at the i-th pose.
  template <typename Query>
  auto ask(std::size_t i, const Query& query) {
    moving_.setTransform((*poses_)[i]);
    result_.clear();
    return query(swapped_ ? &moving_ : &fixed_, swapped_ ? &fixed_ : &moving_, request_, result_);
  }

 private:
  std::shared_ptr<const Poses> poses_;
  fcl::CollisionObjectd fixed_, moving_;
  bool swapped_;
  Request request_;
  Result result_;
};

class PairCollide : ObjectPair<fcl::CollisionRequestd, fcl::CollisionResultd> {
 public:
  using ObjectPair::ObjectPair;
  bool collide(std::size_t i) {
    return ask(i, [](auto&&... query) { return fcl::collide(query...) > 0; });
  }
};

class PairDistance : ObjectPair<fcl::DistanceRequestd, fcl::DistanceResultd> {
 public:
  using ObjectPair::ObjectPair;
  double value(std::size_t i) {
    return ask(i, [](auto&&... query) { return answered([&] { return std::max(fcl::distance(query...), 0.0); }); });
  }
};

/// By conservative advancement; infinity where there is no contact.
class PairAdvance {
 public:
  PairAdvance(Geometry fixed, Geometry moving, std::shared_ptr<const Motions> motions, fcl::GJKSolverType solver,
              bool swapped)
      : fixed_(std::move(fixed)), moving_(std::move(moving)), motions_(std::move(motions)), swapped_(swapped) {
    request_.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    request_.toc_err = kShapeTimeError;
    request_.gjk_solver_type = solver;
  }
  double value(std::size_t i) {
    const fcl::MotionBased *of_fixed = &motions_->fixed[i], *of_moving = &motions_->moving[i];
    of_fixed->integrate(0);
    of_moving->integrate(0);
    return answered([&] {
      fcl::ContinuousCollisionResultd result;
      if (swapped_) {
        fcl::continuousCollide<double>(moving_.get(), of_moving, fixed_.get(), of_fixed, request_, result);
      } else {
        fcl::continuousCollide<double>(fixed_.get(), of_fixed, moving_.get(), of_moving, request_, result);
      }
      return result.is_collide ? result.time_of_contact : std::numeric_limits<double>::infinity();
    });
  }

 private:
  Geometry fixed_, moving_;
  std::shared_ptr<const Motions> motions_;
  fcl::ContinuousCollisionRequestd request_;
  bool swapped_;
};

}  // namespace tricover::bench
