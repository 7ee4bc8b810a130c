// SPDX-License-Identifier: BSD-3-Clause
#include "crowd.h"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/narrowphase/collision.h>

#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "rivals/fcl_geometry.h"
#include "tricover/collide.h"
#include "tricover_fcl/tricover_fcl.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

constexpr std::size_t kObjects = 2000, kShapes = 50, kVertices = 64, kFrames = 50;
/// Homes in rows of 50, orbits that reach their neighbours: chosen so that about 5 % of the outlines collide.
constexpr double kSpacing = 405, kOrbit = 480;

/// Where every object is in every frame, and its shape.
struct Crowd {
  std::vector<Polygon> shapes;
  std::vector<std::vector<Pose>> poses;  ///< by frame, then object
  std::vector<std::vector<fcl::Transform3d>> transforms;

  const Polygon& shapeOf(std::size_t object) const { return shapes[object % shapes.size()]; }
};

/// Irrational steps spread phases and speeds without a random generator.
double spread(std::size_t i, double step) { return std::fmod(static_cast<double>(i) * step, 1); }

std::shared_ptr<const Crowd> makeCrowd() {
  auto crowd = std::make_shared<Crowd>();
  for (std::size_t i = 0; i < kShapes; ++i) {
    crowd->shapes.push_back(workloads::makePolygon(workloads::Kind::Contour, kVertices, i + 1));
  }
  const double turn = 2 * static_cast<double>(EIGEN_PI);
  for (std::size_t frame = 0; frame < kFrames; ++frame) {
    std::vector<Pose> poses(kObjects, Pose::Identity());
    for (std::size_t i = 0; i < kObjects; ++i) {
      const double speed = 0.5 + spread(i, 0.7548776662466927);
      const double angle = turn * (spread(i, 0.6180339887498949) + speed * static_cast<double>(frame) / 1000);
      const Vec2 home(kSpacing * static_cast<double>(i % 50), kSpacing * static_cast<double>(i / 50));
      poses[i].linear() = Eigen::Rotation2Dd(angle * (i % 2 ? 1.7 : -1.3)).toRotationMatrix();
      poses[i].translation() = home + kOrbit * Vec2(std::cos(angle), std::sin(angle));
    }
    crowd->transforms.push_back(toTransforms(poses));
    crowd->poses.push_back(std::move(poses));
  }
  return crowd;
}

class CrowdScene {
 public:
  template <class MakeGeometry>
  CrowdScene(std::shared_ptr<const Crowd> crowd, MakeGeometry make) : crowd_(std::move(crowd)), objects_(kObjects) {
    std::vector<std::shared_ptr<fcl::CollisionGeometryd>> geometries;
    for (const Polygon& shape : crowd_->shapes) geometries.push_back(make(shape));
    std::vector<fcl::CollisionObjectd*> all;
    for (std::size_t i = 0; i < kObjects; ++i) {
      objects_[i] = std::make_unique<fcl::CollisionObjectd>(geometries[i % geometries.size()]);
      objects_[i]->setUserData(&objects_[i]);
      place(i, 0);
      all.push_back(objects_[i].get());
    }
    manager_.registerObjects(all);
    manager_.setup();
  }

  /// `ask(scene, i, j)` decides a pair of objects.
  template <bool ask(CrowdScene&, std::size_t, std::size_t)>
  void walk(const Sampling& sampling, Hits& hits) {
    hits_ = &hits;
    forEachSample(sampling, kFrames, [&](std::size_t frame) {
      frame_ = frame;
      for (std::size_t i = 0; i < kObjects; ++i) place(i, frame);
      manager_.update();
      manager_.collide(this, meet<ask>);
    });
  }

  static bool askNothing(CrowdScene&, std::size_t, std::size_t) { return false; }

  static bool askCore(CrowdScene& scene, std::size_t i, std::size_t j) {
    const Crowd& crowd = *scene.crowd_;
    const std::vector<Pose>& poses = crowd.poses[scene.frame_];
    return tricover::collide(crowd.shapeOf(i), poses[i], crowd.shapeOf(j), poses[j]);
  }

  static bool askFcl(CrowdScene& scene, std::size_t i, std::size_t j) {
    static const fcl::CollisionRequestd request;
    scene.result_.clear();
    return fcl::collide(scene.objects_[i].get(), scene.objects_[j].get(), request, scene.result_) > 0;
  }

 private:
  void place(std::size_t i, std::size_t frame) {
    objects_[i]->setTransform(crowd_->transforms[frame][i]);
    objects_[i]->computeAABB();
  }

  template <bool ask(CrowdScene&, std::size_t, std::size_t)>
  static bool meet(fcl::CollisionObjectd* o1, fcl::CollisionObjectd* o2, void* data) {
    auto& scene = *static_cast<CrowdScene*>(data);
    const auto index = [&](const fcl::CollisionObjectd* object) {
      return static_cast<std::size_t>(static_cast<const Object*>(object->getUserData()) - scene.objects_.data());
    };
    std::size_t i = index(o1), j = index(o2);
    if (i > j) std::swap(i, j);
    if (ask(scene, i, j)) {
      scene.hits_->push_back(static_cast<std::uint32_t>((scene.frame_ * kObjects + i) * kObjects + j));
    }
    return false;
  }

  using Object = std::unique_ptr<fcl::CollisionObjectd>;

  std::shared_ptr<const Crowd> crowd_;
  std::vector<Object> objects_;
  fcl::DynamicAABBTreeCollisionManagerd manager_;
  fcl::CollisionResultd result_;
  std::size_t frame_ = 0;
  Hits* hits_ = nullptr;
};

template <bool ask(CrowdScene&, std::size_t, std::size_t)>
Contender crowdContender(const std::string& name, Role role, std::shared_ptr<CrowdScene> scene) {
  return {name, role, true, [=](const Sampling& sampling, Hits& hits) { scene->walk<ask>(sampling, hits); }};
}

double collidingShare(CrowdScene& scene) {
  Hits hits;
  scene.walk<CrowdScene::askCore>(Sampling{}, hits);
  std::set<std::size_t> colliding;  // frame * kObjects + object
  for (const std::uint32_t hit : hits) {
    const std::size_t frame_and_i = hit / kObjects;
    colliding.insert({frame_and_i, frame_and_i / kObjects * kObjects + hit % kObjects});
  }
  return static_cast<double>(colliding.size()) / (kObjects * kFrames);
}

}  // namespace

CrowdResult measureCrowd(const Settings& settings) {
  const auto crowd = makeCrowd();
  const auto shapes = std::make_shared<CrowdScene>(
      crowd, [](const Polygon& polygon) { return std::make_shared<tricover_fcl::PolygonShaped>(polygon); });
  const auto meshes =
      std::make_shared<CrowdScene>(crowd, [](const Polygon& polygon) { return makeFlatMesh(triangulate(polygon)); });
  const Workload workload{"crowd", "contour", "crowd", kVertices, kVertices, kFrames, kObjects * kObjects};
  return {measure(workload,
                  {crowdContender<CrowdScene::askCore>("cold", Role::Ours, shapes),
                   crowdContender<CrowdScene::askFcl>("via FCL", Role::Ours, shapes),
                   crowdContender<CrowdScene::askFcl>("FCL BVH", Role::Rival, meshes),
                   crowdContender<CrowdScene::askNothing>("manager alone", Role::Floor, shapes)},
                  settings),
          collidingShare(*shapes)};
}

}  // namespace tricover::bench
