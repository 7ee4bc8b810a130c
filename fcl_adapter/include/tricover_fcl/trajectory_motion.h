// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/math/motion/motion_base.h>

#include <memory>
#include <vector>

#include "tricover/export.h"
#include "tricover/trajectory.h"

namespace tricover_fcl {

/// One of FCL's own motions, and when it is.
template <typename S>
struct TimedMotion {
  double begin;  ///< When it begins,
  double end;    ///< and when it ends, which is later.
  std::shared_ptr<const fcl::MotionBase<S>>
      motion;  ///< A SplineMotion, InterpMotion, ScrewMotion or TranslationMotion.
};

/// A body's way of many legs as one motion of FCL's, for fcl::continuousCollide and fcl::ContinuousCollisionObject:
/// beside polygons, and of a polygon beside all else, each leg is followed as FCL's motions are, and who has plans of
/// many knots needs no intervals by hand. It keeps its height and turns about z.
///
/// FCL's time runs from 0 to 1, which is from `begin` to `end` by the caller's clock: the same for both bodies, whose
/// legs need not begin or end together. Before its first leg and after the last one a body rests, unless its trajectory
/// appears() or vanishes(): it meets nothing then. toc_err is by FCL's time, of which 1 is end - begin.
///
/// FCL's own pairs know nothing of it: they refuse it unless CCDC_NAIVE is asked for, which samples its
/// poses, and unless the body is there from time 0 to 1.
///
/// \snippet fcl.cpp fcl trajectory
template <typename S>
class TRICOVER_EXPORT TrajectoryMotion final : public fcl::MotionBase<S> {
 public:
  /// A trajectory in the plane at height z.
  /// \throws std::invalid_argument unless `begin` is before `end`, both finite, and z is finite
  TrajectoryMotion(const tricover::Trajectory& trajectory, double begin, double end, double z = 0);
  /// Motions one after the other, as legs of a Trajectory, which appears() or vanishes().
  /// \throws std::invalid_argument as above and as Trajectory does; and for another class of motion, one that leaves
  /// its plane, and one at another height, or the other way up, than the first. The text has the leg.
  TrajectoryMotion(const std::vector<TimedMotion<S>>& legs, double begin, double end, bool appears = false,
                   bool vanishes = false);

  /// By the clock, what FCL's time stands for.
  double clockAt(S time) const { return begin_ + static_cast<double>(time) * length_; }
  /// By FCL's time, in the plane at height z(): from 0 to 1, or as long as the body is there.
  /// The trajectory of a body that is never there between begin and end is one leg after time 1.
  const tricover::Trajectory& trajectory() const { return trajectory_; }
  double z() const { return z_; }  ///< The height that it keeps.

  /// Goes to a time. As with FCL's motions, one thread at a time.
  bool integrate(S time) const override;
  /// Where it is since.
  void getCurrentTransform(fcl::Transform3<S>& pose) const override;

  /// For FCL's own pairs, which it refuses.
  /// \throws std::logic_error in any case
  S computeMotionBound(const fcl::BVMotionBoundVisitor<S>&) const override;
  /// Likewise.
  /// \throws std::logic_error in any case
  S computeMotionBound(const fcl::TriangleMotionBoundVisitor<S>&) const override;
  /// For FCL's boxes around motions, which it refuses.
  /// \throws std::logic_error in any case
  void getTaylorModel(fcl::TMatrix3<S>&, fcl::TVector3<S>&) const override;

 private:
  double begin_, length_, z_;
  tricover::Trajectory trajectory_;
  mutable S time_ = 0;
};

using TrajectoryMotionf = TrajectoryMotion<float>;   ///< For FCL's float types.
using TrajectoryMotiond = TrajectoryMotion<double>;  ///< For FCL's double types.

extern template class TrajectoryMotion<float>;
extern template class TrajectoryMotion<double>;

}  // namespace tricover_fcl
