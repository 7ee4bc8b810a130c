// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/detail/convexity_based_algorithm/gjk.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include <memory>
#include <vector>

#include "fcl_geometry.h"

namespace tricover::bench {

/// Both polygons as prisms, one a convex piece. Convex polygons go to the solver as they are. Pieces are culled by
/// boxes before the solver sees them: first against the whole other polygon's box, then piece against piece.
class FclPieces {
 public:
  FclPieces(const Polygon& fixed, const Polygon& moving);

  void prepare(const std::vector<Pose>& poses);
  /// How many of the poses the boxes tell or, of convex polygons, the first support, between the centres.
  std::size_t decidedAtOnce();

 protected:
  struct Box {
    Vec2 center, half;
    explicit Box(const Ring& ring);
    Box(const Box& box, const Pose& pose, const Eigen::Matrix2d& size)
        : center(pose * box.center), half(size * box.half) {}
    bool meets(const Box& other) const {
      return ((center - other.center).cwiseAbs().array() <= (half + other.half).array()).all();
    }
  };

  struct Pieces {
    Pieces(const Polygon& polygon, double half_height);
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

  std::vector<Pose> poses_;
  std::vector<fcl::Transform3d> transforms_;
  fcl::Transform3d identity_ = fcl::Transform3d::Identity();

 private:
  Pieces fixed_, moving_;
  std::vector<std::size_t> near_fixed_;
};

/// libccd's MPR, which is what FCL runs for GST_LIBCCD, called as FCL's own rows call it.
class FclMpr : public FclPieces {
 public:
  using FclPieces::FclPieces;

  bool collide(std::size_t i) {
    return anyPair(i, [&](const Prism& a, const Prism& b) {
      return solver_.shapeIntersect(a, identity_, b, transforms_[i], nullptr);
    });
  }

 private:
  fcl::detail::GJKSolver_libccdd solver_;
};

/// FCL's own GJK (GST_INDEP), as its solver sets it up, but without the EPA that fcl::collide adds for a depth that
/// nobody asks for. With `coherent` it starts from its last simplex, which FCL calls the cached guess.
class FclGjk : public FclPieces {
 public:
  FclGjk(const Polygon& fixed, const Polygon& moving, bool coherent,
         double tolerance = fcl::constants<double>::gjk_default_tolerance())
      : FclPieces(fixed, moving), coherent_(coherent), gjk_(128, tolerance) {}

  bool collide(std::size_t i) {
    using Gjk = fcl::detail::GJK<double>;
    difference_.toshape1.noalias() = transforms_[i].linear().transpose();
    difference_.toshape0 = transforms_[i];
    return anyPair(i, [&](const Prism& a, const Prism& b) {
      difference_.shapes[0] = &a;
      difference_.shapes[1] = &b;
      const auto status = gjk_.evaluate(difference_, -guess_);
      if (coherent_) guess_ = gjk_.getGuessFromSimplex();
      return status == Gjk::Inside;
    });
  }

 private:
  bool coherent_;
  fcl::detail::GJK<double> gjk_;
  fcl::detail::MinkowskiDiff<double> difference_;
  fcl::Vector3d guess_ = fcl::Vector3d::UnitX();
};

}  // namespace tricover::bench
