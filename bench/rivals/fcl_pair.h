// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/collision.h>
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

}  // namespace tricover::bench
