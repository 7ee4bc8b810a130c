// SPDX-License-Identifier: BSD-3-Clause
#include "drive_study.h"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/narrowphase/collision.h>

#include <cmath>
#include <limits>
#include <utility>

#include "rivals/fcl_geometry.h"
#include "tricover/collide.h"
#include "tricover_fcl/tricover_fcl.h"

namespace tricover::bench {
namespace {

using Geometries = std::vector<std::shared_ptr<fcl::CollisionGeometryd>>;
using MakeGeometries = Geometries (*)(const Polygon& polygon, bool moves);

struct Drive {
  std::shared_ptr<const Countries> countries;
  std::size_t mover;  ///< its country, which is not among the fixed ones
  Polygon moving;
  std::vector<Pose> poses;
  std::vector<fcl::Transform3d> transforms;
};

/// One object a shape, under FCL's broadphase. User data of a fixed object is its country's element of `last_hit_`,
/// and null for the moving ones.
class FclScene {
 public:
  FclScene(std::shared_ptr<const Drive> drive, MakeGeometries make) : drive_(std::move(drive)) {
    const Countries& countries = *drive_->countries;
    last_hit_.assign(countries.size(), kNever);
    for (std::size_t i = 0; i < countries.size(); ++i) {
      const bool moves = i == drive_->mover;
      for (const auto& geometry : make(moves ? drive_->moving : countries[i].polygon, moves)) {
        auto& objects = moves ? moving_ : fixed_;
        objects.push_back(std::make_unique<fcl::CollisionObjectd>(geometry));
        if (moves) continue;
        objects.back()->setUserData(&last_hit_[i]);
        manager_.registerObject(objects.back().get());
      }
    }
    manager_.setup();
  }

  void walk(const Sampling& sampling, Hits& hits) {
    hits_ = &hits;
    last_hit_.assign(last_hit_.size(), kNever);
    forEachSample(sampling, drive_->transforms.size(), [&](std::size_t position) {
      position_ = position;
      for (const auto& object : moving_) {
        object->setTransform(drive_->transforms[position]);
        object->computeAABB();
        manager_.collide(object.get(), this, meet);
      }
    });
  }

 private:
  static constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

  static bool meet(fcl::CollisionObjectd* o1, fcl::CollisionObjectd* o2, void* data) {
    auto& scene = *static_cast<FclScene*>(data);
    auto* last_hit = static_cast<std::size_t*>(o1->getUserData() ? o1->getUserData() : o2->getUserData());
    if (*last_hit == scene.position_) return false;  // another piece of it is hit already
    static const fcl::CollisionRequestd request;
    scene.result_.clear();
    if (fcl::collide(o1, o2, request, scene.result_) == 0) return false;
    *last_hit = scene.position_;
    const auto country = static_cast<std::size_t>(last_hit - scene.last_hit_.data());
    scene.hits_->push_back(static_cast<std::uint32_t>(scene.position_ * scene.last_hit_.size() + country));
    return false;
  }

  std::shared_ptr<const Drive> drive_;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> fixed_, moving_;
  fcl::DynamicAABBTreeCollisionManagerd manager_;
  fcl::CollisionResultd result_;
  std::vector<std::size_t> last_hit_;  ///< the last position at which each country was hit
  std::size_t position_ = 0;
  Hits* hits_ = nullptr;
};

Contender fclContender(const std::string& name, Role role, bool coherent, std::shared_ptr<const Drive> drive,
                       MakeGeometries make) {
  const auto scene = std::make_shared<FclScene>(std::move(drive), make);
  return {name, role, coherent, [=](const Sampling& sampling, Hits& hits) { scene->walk(sampling, hits); }};
}

/// Every country asked, without a broadphase.
Contender coreContender(const std::string& name, bool coherent, std::shared_ptr<const Drive> drive) {
  return {name, Role::Ours, coherent, [=](const Sampling& sampling, Hits& hits) {
            const Countries& countries = *drive->countries;
            const Pose identity = Pose::Identity();
            std::vector<PairCache> caches(countries.size());
            forEachSample(sampling, drive->poses.size(), [&](std::size_t i) {
              for (std::size_t k = 0; k < countries.size(); ++k) {
                if (k == drive->mover) continue;
                const Polygon& fixed = countries[k].polygon;
                const bool hit = coherent ? collide(fixed, identity, drive->moving, drive->poses[i], caches[k])
                                          : collide(fixed, identity, drive->moving, drive->poses[i]);
                if (hit) hits.push_back(static_cast<std::uint32_t>(i * countries.size() + k));
              }
            });
          }};
}

Geometries polygonShape(const Polygon& polygon, bool) {
  return {std::make_shared<tricover_fcl::PolygonShaped>(polygon)};
}

Geometries flatMesh(const Polygon& polygon, bool) { return {makeFlatMesh(triangulate(polygon))}; }

Geometries prisms(const Polygon& polygon, bool moves) {
  Geometries geometries;
  for (const Ring& ring : convexPieces(triangulate(polygon))) {
    geometries.push_back(makePrism(ring, moves ? 2 * kHalfHeight : kHalfHeight));
  }
  return geometries;
}

}  // namespace

std::vector<Pose> circularDrive(std::size_t positions) {
  const Vec2 center(-20, 15);
  const double radius = 45;
  std::vector<Pose> poses(positions, Pose::Identity());
  for (std::size_t i = 0; i < positions; ++i) {
    const double angle = 2 * static_cast<double>(EIGEN_PI) * static_cast<double>(i) / static_cast<double>(positions);
    poses[i].linear() = Eigen::Rotation2Dd(angle).toRotationMatrix();
    poses[i].translation() = center + radius * Vec2(std::cos(angle), std::sin(angle));
  }
  return poses;
}

std::vector<Pose> linearDrive(std::size_t positions) {
  const Vec2 from(-50, 42), to(160, 25);
  std::vector<Pose> poses(positions, Pose::Identity());
  for (std::size_t i = 0; i < positions; ++i) {
    poses[i].translation() = from + static_cast<double>(i) / static_cast<double>(positions - 1) * (to - from);
  }
  return poses;
}

Result measureDrive(std::shared_ptr<const Countries> countries, const std::string& mover, const std::string& trajectory,
                    const Settings& settings) {
  const std::size_t index = findCountry(*countries, mover);
  const Polygon moving = centred((*countries)[index].polygon);
  auto poses = trajectory == "circular" ? circularDrive() : linearDrive();
  auto transforms = toTransforms(poses);
  const auto shared =
      std::make_shared<const Drive>(Drive{countries, index, moving, std::move(poses), std::move(transforms)});
  std::size_t vertices = 0;
  for (const auto& country : *countries) vertices += country.polygon.vertexCount();
  const Workload workload{
      "countries",      mover, trajectory, vertices - moving.vertexCount(), moving.vertexCount(), shared->poses.size(),
      countries->size()};
  return measure(workload,
                 {coreContender("cold", false, shared), coreContender("cached", true, shared),
                  fclContender("via FCL", Role::Ours, true, shared, polygonShape),
                  fclContender("FCL MPR", Role::Rival, false, shared, prisms),
                  fclContender("FCL BVH", Role::Rival, false, shared, flatMesh)},
                 settings);
}

}  // namespace tricover::bench
