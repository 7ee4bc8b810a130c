// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/detail/convexity_based_algorithm/gjk.h>
#include <fcl/narrowphase/detail/gjk_solver_indep.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "fcl_geometry.h"
#include "prism.h"

/// FCL's solvers of convex shapes, called as FCL's own rows call them.
namespace tricover::bench {

using Prism = fcl::Convex<double>;

/// How polygons become prisms. FCL's MPR is wrong for prisms of equal height at equal z, so fixed prisms reach so far
/// up and down and moving ones twice as far.
struct Prisms {
  double half_height = 0.5;
  Pose fixed_pose = Pose::Identity();
  bool one_each = false;  ///< the first ring as it is; else one a convex piece
};

/// Pieces are culled by boxes before the solver sees them: first against the whole other polygon's box, then piece
/// against piece. Polygons of one piece go to the solver as they are. Boxes need the fixed polygon at the identity.
class FclPieces : public FclPosed {
 public:
  FclPieces(const Polygon& fixed, const Polygon& moving, const Prisms& prisms);

  void prepare(const std::vector<Pose>& poses) {
    poses_ = poses;
    FclPosed::prepare(poses);
  }
  /// How many of the poses the boxes tell or, of convex polygons, the first support, between the centres.
  std::size_t decidedAtOnce();

 protected:
  struct Box {
    Vec2 center, half;
    explicit Box(const Eigen::AlignedBox2d& box) : center(box.center()), half(box.sizes() / 2) {}
    Box(const Box& box, const Pose& pose, const Eigen::Matrix2d& size)
        : center(pose * box.center), half(size * box.half) {}
    bool meets(const Box& other) const {
      return ((center - other.center).cwiseAbs().array() <= (half + other.half).array()).all();
    }
  };

  struct Pieces {
    Pieces(const Polygon& polygon, double half_height, bool one);
    std::vector<std::shared_ptr<Prism>> prisms;
    std::vector<Box> boxes;
    Box whole;
  };

  /// `meet(fixed prism, moving prism)` decides a pair.
  template <class Meet>
  bool anyPair(std::size_t i, Meet meet) {
    if (fixed_.prisms.size() == 1 && moving_.prisms.size() == 1) return meet(*fixed_.prisms[0], *moving_.prisms[0]);
    const Pose& pose = poses_[i];
    const Eigen::Matrix2d size = pose.linear().cwiseAbs();
    const Box moved(moving_.whole, pose, size);
    near_fixed_.clear();
    for (std::size_t k = 0; k < fixed_.boxes.size(); ++k) {
      if (moved.meets(fixed_.boxes[k])) near_fixed_.push_back(k);
    }
    if (near_fixed_.empty()) return false;
    for (std::size_t j = 0; j < moving_.boxes.size(); ++j) {
      const Box box(moving_.boxes[j], pose, size);
      if (!box.meets(fixed_.whole)) continue;
      for (const std::size_t k : near_fixed_) {
        if (box.meets(fixed_.boxes[k]) && meet(*fixed_.prisms[k], *moving_.prisms[j])) return true;
      }
    }
    return false;
  }

 private:
  std::vector<Pose> poses_;
  Pieces fixed_, moving_;
  std::vector<std::size_t> near_fixed_;
};

/// libccd's MPR, which is what FCL runs for GST_LIBCCD.
class FclMpr : public FclPieces {
 public:
  FclMpr(const Polygon& fixed, const Polygon& moving, const Prisms& prisms = {},
         double tolerance = fcl::constants<double>::gjk_default_tolerance())
      : FclPieces(fixed, moving, prisms) {
    solver_.collision_tolerance = tolerance;
  }

  bool collide(std::size_t i) {
    return anyPair(i, [&](const Prism& a, const Prism& b) {
      return solver_.shapeIntersect(a, fixed_transform_, b, transforms_[i], nullptr);
    });
  }

 private:
  fcl::detail::GJKSolver_libccdd solver_;
};

/// FCL's own GJK (GST_INDEP), as its solver sets it up, but without the EPA that fcl::collide adds for a depth that
/// nobody asks for. With `coherent` it starts from its last simplex, which FCL calls the cached guess.
class FclGjk : public FclPieces {
 public:
  FclGjk(const Polygon& fixed, const Polygon& moving, bool coherent, const Prisms& prisms = {},
         double tolerance = fcl::constants<double>::gjk_default_tolerance())
      : FclPieces(fixed, moving, prisms),
        is_at_origin_(prisms.fixed_pose.matrix().isIdentity(0)),
        coherent_(coherent),
        gjk_(128, tolerance) {}

  bool collide(std::size_t i) {
    using Gjk = fcl::detail::GJK<double>;
    difference_.toshape1.noalias() = transforms_[i].linear().transpose();
    difference_.toshape0 = transforms_[i];
    if (!is_at_origin_) {
      difference_.toshape1 *= fixed_transform_.linear();
      difference_.toshape0 = fixed_transform_.inverse(Eigen::Isometry) * transforms_[i];
    }
    return anyPair(i, [&](const Prism& a, const Prism& b) {
      difference_.shapes[0] = &a;
      difference_.shapes[1] = &b;
      const auto status = gjk_.evaluate(difference_, -guess_);
      if (coherent_) guess_ = gjk_.getGuessFromSimplex();
      return status == Gjk::Inside;
    });
  }

 private:
  bool is_at_origin_, coherent_;
  fcl::detail::GJK<double> gjk_;
  fcl::detail::MinkowskiDiff<double> difference_;
  fcl::Vector3d guess_ = fcl::Vector3d::UnitX();
};

/// The distance as fcl::distance asks a solver for it, of two convex polygons; `coherent` starts from the last answer
/// (GST_INDEP only).
template <class Solver, double Solver::*Tolerance>
class FclGjkDistance : public FclPieces {
 public:
  FclGjkDistance(const Polygon& fixed, const Polygon& moving, bool coherent) : FclPieces(fixed, moving, {}) {
    solver_.enableCachedGuess(coherent);
  }
  FclGjkDistance(const Polygon& fixed, const Polygon& moving, const Prisms& prisms, double tolerance)
      : FclPieces(fixed, moving, prisms) {
    solver_.*Tolerance = tolerance;
  }

  /// 0 where they are said to meet.
  double value(std::size_t i) {
    double distance = 0;
    const bool meet = anyPair(i, [&](const Prism& a, const Prism& b) {
      return !solver_.shapeDistance(a, fixed_transform_, b, transforms_[i], &distance);
    });
    return meet ? 0 : std::max(distance, 0.0);
  }
  bool collide(std::size_t i) { return value(i) <= 0; }

 private:
  Solver solver_;
};

/// GST_LIBCCD: FCL's own GJK on libccd's types. GST_INDEP.
using LibccdDistance =
    FclGjkDistance<fcl::detail::GJKSolver_libccdd, &fcl::detail::GJKSolver_libccdd::distance_tolerance>;
using IndepDistance = FclGjkDistance<fcl::detail::GJKSolver_indepd, &fcl::detail::GJKSolver_indepd::gjk_tolerance>;

/// The depth of two convex prisms, so high that they part sideways: by EPA or MPR. `none`: where they are said to be
/// apart.
template <class Solver>
class FclDepth : public FclPieces {
 public:
  FclDepth(const Polygon& fixed, const Polygon& moving, const Prisms& prisms, double none)
      : FclPieces(fixed, moving, prisms), none_(none) {}

  double value(std::size_t i) {
    std::vector<fcl::ContactPointd> contacts;
    const bool meet = anyPair(i, [&](const Prism& a, const Prism& b) {
      return solver_.shapeIntersect(a, fixed_transform_, b, transforms_[i], &contacts);
    });
    double deepest = meet ? 0 : none_;
    if (meet)
      for (const fcl::ContactPointd& contact : contacts)
        deepest = std::max(deepest, std::abs(contact.penetration_depth));
    return deepest;
  }

 private:
  double none_;
  Solver solver_;
};

}  // namespace tricover::bench
