// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/detail/convexity_based_algorithm/gjk.h>
#include <fcl/narrowphase/detail/gjk_solver_indep.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "rivals/fcl_geometry.h"
#include "tradeoff_scenes.h"

/// FCL's convex solvers with the tolerance that FCL lets its users choose, on one prism a polygon.
namespace tricover::bench {

class ConvexPair {
 public:
  /// Prisms of unequal heights, which suit MPR, and as high in proportion at every scale.
  explicit ConvexPair(const Scene& scene, double height = kHeight)
      : fixed_(makePrism(scene.fixed.rings()[0], height * scene.size)),
        moving_(makePrism(scene.moving.rings()[0], 2 * height * scene.size)),
        fixed_transform_(toTransform(scene.fixed_pose)) {}

  void prepare(const std::vector<Pose>& poses) { transforms_ = toTransforms(poses); }

 protected:
  /// Half the height, as a part of the polygons' size. Neither MPR nor GJK (libccd) minds; GJK (indep) is a fifth
  /// faster on prisms a tenth as high, but misses penetrations of up to a hundredth of the size there.
  static constexpr double kHeight = 0.05;

  std::shared_ptr<Prism> fixed_, moving_;
  fcl::Transform3d fixed_transform_;
  std::vector<fcl::Transform3d> transforms_;
};

/// GST_LIBCCD in fcl::collide: libccd's MPR.
class LibccdMpr : public ConvexPair {
 public:
  LibccdMpr(const Scene& scene, double tolerance) : ConvexPair(scene) { solver_.collision_tolerance = tolerance; }
  bool collide(std::size_t i) {
    return solver_.shapeIntersect(*fixed_, fixed_transform_, *moving_, transforms_[i], nullptr);
  }

 private:
  fcl::detail::GJKSolver_libccdd solver_;
};

/// What fcl::distance asks a solver, whose tolerance is that member.
template <class Solver, double Solver::*Tolerance>
class SolverDistance : public ConvexPair {
 public:
  SolverDistance(const Scene& scene, double tolerance) : ConvexPair(scene) { solver_.*Tolerance = tolerance; }
  /// 0 where they are said to meet.
  double value(std::size_t i) {
    double distance = 0;
    const bool apart = solver_.shapeDistance(*fixed_, fixed_transform_, *moving_, transforms_[i], &distance);
    return apart ? std::max(distance, 0.0) : 0;
  }
  bool collide(std::size_t i) { return value(i) <= 0; }

 private:
  Solver solver_;
};

/// GST_LIBCCD: FCL's own GJK on libccd's types.
using LibccdGjk = SolverDistance<fcl::detail::GJKSolver_libccdd, &fcl::detail::GJKSolver_libccdd::distance_tolerance>;
/// GST_INDEP.
using IndepDistance = SolverDistance<fcl::detail::GJKSolver_indepd, &fcl::detail::GJKSolver_indepd::gjk_tolerance>;

/// GST_INDEP in fcl::collide, without the EPA for a depth that nobody asks for.
class IndepGjk : public ConvexPair {
 public:
  IndepGjk(const Scene& scene, double tolerance) : ConvexPair(scene), gjk_(128, tolerance) {
    difference_.shapes[0] = fixed_.get();
    difference_.shapes[1] = moving_.get();
  }
  bool collide(std::size_t i) {
    using Gjk = fcl::detail::GJK<double>;
    difference_.toshape1.noalias() = transforms_[i].linear().transpose() * fixed_transform_.linear();
    difference_.toshape0 = fixed_transform_.inverse(Eigen::Isometry) * transforms_[i];
    return gjk_.evaluate(difference_, -fcl::Vector3d::UnitX()) == Gjk::Inside;
  }

 private:
  fcl::detail::GJK<double> gjk_;
  fcl::detail::MinkowskiDiff<double> difference_;
};

}  // namespace tricover::bench
