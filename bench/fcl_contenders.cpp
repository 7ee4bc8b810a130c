// SPDX-License-Identifier: BSD-3-Clause
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include <algorithm>
#include <utility>

#include "contenders.h"
#include "fcl_geometry.h"
#include "tricover_fcl/tricover_fcl.h"

namespace tricover::bench {
namespace {

struct Box {
  Vec2 center, half;
  bool meets(const Box& other) const {
    return ((center - other.center).cwiseAbs().array() <= (half + other.half).array()).all();
  }
};

Box boxAround(const Ring& ring) {
  Vec2 low = ring[0], high = ring[0];
  for (const Vec2& v : ring) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  return {(low + high) / 2, (high - low) / 2};
}

Box posed(const Box& box, const Pose& pose, const Eigen::Matrix2d& size) {
  return {pose * box.center, size * box.half};
}

/// One prism a convex piece. Pairs are culled by boxes before GJK sees them: first against the common part of the two
/// whole boxes, then piece against piece.
class Pieces {
 public:
  Pieces(const std::vector<Triangle>& triangles, double half_height) {
    Ring all;
    for (const Ring& ring : convexPieces(triangles)) {
      prisms_.push_back(makePrism(ring, half_height));
      boxes_.push_back(boxAround(ring));
      all.insert(all.end(), ring.begin(), ring.end());
    }
    whole_ = boxAround(all);
  }

  /// `meet(fixed prism, moving prism)` decides a pair. Not to be used by two threads at once.
  template <class Meet>
  static bool collide(const Pieces& fixed, const Pieces& moving, const Pose& pose, Meet meet) {
    static std::vector<std::size_t> near_fixed;
    const Eigen::Matrix2d size = pose.linear().cwiseAbs();
    const Box moved = posed(moving.whole_, pose, size);
    near_fixed.clear();
    for (std::size_t i = 0; i < fixed.boxes_.size(); ++i) {
      if (moved.meets(fixed.boxes_[i])) near_fixed.push_back(i);
    }
    if (near_fixed.empty()) return false;
    for (std::size_t j = 0; j < moving.boxes_.size(); ++j) {
      const Box box = posed(moving.boxes_[j], pose, size);
      if (!box.meets(fixed.whole_)) continue;
      for (const std::size_t i : near_fixed) {
        if (box.meets(fixed.boxes_[i]) && meet(*fixed.prisms_[i], *moving.prisms_[j])) return true;
      }
    }
    return false;
  }

 private:
  std::vector<std::shared_ptr<Prism>> prisms_;
  std::vector<Box> boxes_;
  Box whole_;
};

/// Everything the FCL contenders share, built before any timing.
struct FclPassage {
  FclPassage(std::shared_ptr<const Passage> passage_, const std::vector<Triangle>& fixed_triangles,
             const std::vector<Triangle>& moving_triangles)
      : passage(std::move(passage_)),
        transforms(toTransforms(passage->poses)),
        fixed_pieces(fixed_triangles, kHalfHeight),
        moving_pieces(moving_triangles, 2 * kHalfHeight),
        fixed_mesh(makeFlatMesh(fixed_triangles)),
        moving_mesh(makeFlatMesh(moving_triangles)),
        fixed_shape(std::make_shared<tricover_fcl::PolygonShaped>(passage->fixed)),
        moving_shape(std::make_shared<tricover_fcl::PolygonShaped>(passage->moving)),
        fixed_sphere(std::make_shared<fcl::Sphered>(1)),
        moving_sphere(std::make_shared<fcl::Sphered>(1)) {}

  /// The same pre-check that tricover does, for rivals that have none.
  bool discsApart(const Pose& pose) const {
    const double reach = passage->fixed.radius() + passage->moving.radius();
    return (pose * passage->moving.origin() - passage->fixed.origin()).squaredNorm() > reach * reach;
  }

  std::shared_ptr<const Passage> passage;
  std::vector<fcl::Transform3d> transforms;
  Pieces fixed_pieces, moving_pieces;
  fcl::CollisionObjectd fixed_mesh, moving_mesh, fixed_shape, moving_shape, fixed_sphere, moving_sphere;
};

/// `collides(scene, position)` answers one query.
template <class Collides>
Contender contender(const std::string& name, Role role, bool coherent, std::shared_ptr<FclPassage> scene,
                    Collides collides) {
  return {name, role, coherent, [=](const Sampling& sampling, Hits& hits) {
            forEachSample(sampling, scene->transforms.size(), [&](std::size_t i) {
              if (collides(*scene, i)) hits.push_back(static_cast<std::uint32_t>(i));
            });
          }};
}

/// The public entry point, unmodified.
bool collideByFcl(const fcl::CollisionObjectd& fixed, fcl::CollisionObjectd& moving,
                  const fcl::Transform3d& transform) {
  static const fcl::CollisionRequestd request;
  static fcl::CollisionResultd result;
  result.clear();
  moving.setTransform(transform);
  return fcl::collide(&fixed, &moving, request, result) > 0;
}

/// libccd's MPR, called as FCL's own rows call it.
bool collideByLibccd(const FclPassage& scene, std::size_t i) {
  static const fcl::detail::GJKSolver_libccdd solver;
  static const fcl::Transform3d identity = fcl::Transform3d::Identity();
  const Pose& pose = scene.passage->poses[i];
  return !scene.discsApart(pose) &&
         Pieces::collide(scene.fixed_pieces, scene.moving_pieces, pose, [&](const Prism& a, const Prism& b) {
           return solver.shapeIntersect(a, identity, b, scene.transforms[i], nullptr);
         });
}

/// FCL's own GJK without the EPA that its rows run for a depth nobody asked for.
bool collideByIndep(const FclPassage& scene, std::size_t i) {
  using fcl::detail::GJK;
  const Pose& pose = scene.passage->poses[i];
  return !scene.discsApart(pose) &&
         Pieces::collide(scene.fixed_pieces, scene.moving_pieces, pose, [&](const Prism& a, const Prism& b) {
           fcl::detail::MinkowskiDiff<double> difference;
           difference.shapes[0] = &a;
           difference.shapes[1] = &b;
           difference.toshape1.noalias() = scene.transforms[i].linear().transpose();
           difference.toshape0 = scene.transforms[i];
           GJK<double> gjk(128, fcl::constants<double>::gjk_default_tolerance());  // as in GJKSolver_indep
           return gjk.evaluate(difference, -fcl::Vector3d::UnitX()) == GJK<double>::Inside;
         });
}

}  // namespace

std::vector<Contender> fclContenders(std::shared_ptr<const Passage> passage) {
  const auto fixed = triangulate(passage->fixed), moving = triangulate(passage->moving);
  const auto scene = std::make_shared<FclPassage>(std::move(passage), fixed, moving);
  const auto tricover = [](FclPassage& s, std::size_t i) {
    return collideByFcl(s.fixed_shape, s.moving_shape, s.transforms[i]);
  };
  const auto mesh = [](FclPassage& s, std::size_t i) {
    return !s.discsApart(s.passage->poses[i]) && collideByFcl(s.fixed_mesh, s.moving_mesh, s.transforms[i]);
  };
  const auto nothing = [](FclPassage& s, std::size_t i) {
    return collideByFcl(s.fixed_sphere, s.moving_sphere, s.transforms[i]);
  };
  return {contender("via FCL", Role::Ours, true, scene, tricover),
          contender("GJK ccd", Role::Rival, false, scene, collideByLibccd),
          contender("GJK indep", Role::Rival, false, scene, collideByIndep),
          contender("BVH", Role::Rival, false, scene, mesh), contender("floor", Role::Floor, false, scene, nothing)};
}

}  // namespace tricover::bench
