// SPDX-License-Identifier: BSD-3-Clause
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "placed.h"
#include "rivals/box2d.h"
#include "rivals/box2d_scene.h"
#include "rivals/fcl_call.h"
#include "scene_studies.h"
#include "tricover/collide.h"
#include "tricover/scene.h"
#include "tricover_fcl/tricover_fcl.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

constexpr std::size_t kObjects = 2000, kFrames = 50;

/// Outlines that drive in circles and turn, each at speeds of its own.
struct Crowd {
  std::vector<Polygon> shapes;
  std::vector<std::vector<Pose>> poses;  ///< by frame, then object

  const Polygon& shapeOf(std::size_t object) const { return shapes[object % shapes.size()]; }
  std::size_t size() const { return poses.front().size(); }
  std::size_t frames() const { return poses.size(); }
};

/// Homes in rows, however many there are, so that all neighbours meet alike; with this much between them, orbits that
/// reach the neighbours: chosen so that about 5 % of the outlines collide. The density is the same for any number of
/// them.
constexpr std::size_t kCrowdRow = 50;
constexpr double kContourSpacing = 405;
constexpr double kConvexSpacing = 475;

constexpr std::size_t kShapes = 50;
constexpr double kOrbit = 480;

/// Irrational steps spread phases and speeds without a random generator.
double spread(std::size_t i, double step) { return std::fmod(static_cast<double>(i) * step, 1); }

/// Where they are in one frame.
std::vector<Pose> crowdPoses(double spacing, std::size_t objects, std::size_t frame) {
  const double turn = 2 * static_cast<double>(EIGEN_PI);
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < objects; ++i) {
    const double speed = 0.5 + spread(i, 0.7548776662466927);
    const double angle = turn * (spread(i, 0.6180339887498949) + speed * static_cast<double>(frame) / 1000);
    const Vec2 home(spacing * static_cast<double>(i % kCrowdRow), spacing * static_cast<double>(i / kCrowdRow));
    poses.push_back(poseAt(home + kOrbit * Vec2(std::cos(angle), std::sin(angle)), angle * (i % 2 != 0 ? 1.7 : -1.3)));
  }
  return poses;
}

Crowd makeCrowd(workloads::Kind kind, std::size_t vertices, double spacing, std::size_t objects, std::size_t frames) {
  Crowd crowd;
  for (std::size_t i = 0; i < kShapes; ++i) crowd.shapes.push_back(workloads::makePolygon(kind, vertices, i + 1));
  for (std::size_t frame = 0; frame < frames; ++frame) crowd.poses.push_back(crowdPoses(spacing, objects, frame));
  return crowd;
}

using SharedCrowd = std::shared_ptr<const Crowd>;

/// Walks forth and back in turn, so that no walk begins with a leap.
class FrameWalk {
 public:
  template <class Visit>
  void operator()(std::size_t frames, Visit visit) {
    for (std::size_t k = 0; k < frames; ++k) visit(backwards_ ? frames - 1 - k : k);
    backwards_ = !backwards_;
  }

 private:
  bool backwards_ = false;
};

std::uint32_t hitCode(std::size_t frame, std::size_t i, std::size_t j) {
  if (i > j) std::swap(i, j);
  return static_cast<std::uint32_t>((frame * kObjects + i) * kObjects + j);
}

class SceneFrames {
 public:
  explicit SceneFrames(SharedCrowd crowd) : crowd_(std::move(crowd)) {
    for (std::size_t i = 0; i < kObjects; ++i) scene_.add(crowd_->shapeOf(i), crowd_->poses[0][i]);
  }
  void walk(Hits& hits) {
    walk_(kFrames, [&](std::size_t frame) {
      const std::vector<Pose>& poses = crowd_->poses[frame];
      for (std::size_t i = 0; i < kObjects; ++i) scene_.move(static_cast<Scene::Body>(i), poses[i]);
      for (const BodyPair& pair : scene_.collisions()) hits.push_back(hitCode(frame, pair.first, pair.second));
    });
  }

 private:
  SharedCrowd crowd_;
  Scene scene_;
  FrameWalk walk_;
};

/// `Object` has a computeAABB() of its own.
template <class Object>
class FclFrames {
 public:
  template <class MakeGeometry>
  FclFrames(SharedCrowd crowd, FclManager manager, MakeGeometry make)
      : crowd_(std::move(crowd)), objects_(kObjects), manager_(std::move(manager)) {
    for (const std::vector<Pose>& poses : crowd_->poses) transforms_.push_back(toTransforms(poses));
    std::vector<decltype(make(crowd_->shapes.front()))> geometries;
    for (const Polygon& shape : crowd_->shapes) geometries.push_back(make(shape));
    std::vector<fcl::CollisionObjectd*> all;
    for (std::size_t i = 0; i < kObjects; ++i) {
      objects_[i] = std::make_unique<Object>(geometries[i % geometries.size()]);
      objects_[i]->setUserData(&objects_[i]);
      place(i, 0);
      all.push_back(objects_[i].get());
    }
    manager_->registerObjects(all);
    manager_->setup();
  }

  static bool askNothing(FclFrames&, std::size_t, std::size_t) { return false; }

  static bool askCore(FclFrames& frames, std::size_t i, std::size_t j) {
    const Crowd& crowd = *frames.crowd_;
    const std::vector<Pose>& poses = crowd.poses[frames.frame_];
    return tricover::collide(crowd.shapeOf(i), poses[i], crowd.shapeOf(j), poses[j]);
  }

  static bool askFcl(FclFrames& frames, std::size_t i, std::size_t j) {
    static const fcl::CollisionRequestd request;
    frames.result_.clear();
    return fcl::collide(frames.objects_[i].get(), frames.objects_[j].get(), request, frames.result_) > 0;
  }

  /// `ask(frames, i, j)` decides a pair of objects.
  template <bool ask(FclFrames&, std::size_t, std::size_t) = askFcl>
  void walk(Hits& hits) {
    hits_ = &hits;
    walk_(kFrames, [&](std::size_t frame) {
      frame_ = frame;
      for (std::size_t i = 0; i < kObjects; ++i) place(i, frame);
      manager_->update();
      manager_->collide(this, meet<ask>);
    });
  }

 private:
  void place(std::size_t i, std::size_t frame) {
    objects_[i]->setTransform(transforms_[frame][i]);
    objects_[i]->computeAABB();
  }

  template <bool ask(FclFrames&, std::size_t, std::size_t)>
  static bool meet(fcl::CollisionObjectd* o1, fcl::CollisionObjectd* o2, void* data) {
    auto& frames = *static_cast<FclFrames*>(data);
    const auto index = [&](const fcl::CollisionObjectd* object) {
      return static_cast<std::size_t>(static_cast<const std::unique_ptr<Object>*>(object->getUserData()) -
                                      frames.objects_.data());
    };
    const std::size_t i = index(o1), j = index(o2);
    if (ask(frames, i, j)) frames.hits_->push_back(hitCode(frames.frame_, i, j));
    return false;
  }

  SharedCrowd crowd_;
  std::vector<std::vector<fcl::Transform3d>> transforms_;
  std::vector<std::unique_ptr<Object>> objects_;
  FclManager manager_;
  fcl::CollisionResultd result_;
  FrameWalk walk_;
  std::size_t frame_ = 0;
  Hits* hits_ = nullptr;
};

class Box2dFrames {
 public:
  Box2dFrames(const Crowd& crowd, float scale) : bodies_(crowd.shapes, crowd.poses[0], scale) {
    for (const std::vector<Pose>& poses : crowd.poses) transforms_.push_back(bodies_.transforms(poses));
  }
  void walk(Hits& hits) {
    walk_(kFrames, [&](std::size_t frame) {
      for (std::size_t i = 0; i < kObjects; ++i) bodies_.move(i, transforms_[frame][i]);
      bodies_.forEachTouching([&](std::uint32_t i, std::uint32_t j) { hits.push_back(hitCode(frame, i, j)); });
    });
  }

 private:
  Box2dCrowd bodies_;
  std::vector<std::vector<b2Transform>> transforms_;
  FrameWalk walk_;
};

/// All frames are walked, as coherent ones are.
template <class Walk>
Contender framesContender(const std::string& name, Role role, Walk walk) {
  return {name, role, true, [=](const Sampling&, Hits& hits) { walk(hits); }};
}

using Objects = FclFrames<fcl::CollisionObjectd>;
using TightObjects = FclFrames<tricover_fcl::PolygonObjectd>;

template <class Frames>
Contender ownContender(const std::string& name, Role role, std::shared_ptr<Frames> frames) {
  return framesContender(name, role, [=](Hits& hits) { frames->walk(hits); });
}

Result measureKind(workloads::Kind kind, std::size_t vertices, double spacing, const Settings& settings) {
  const auto crowd = std::make_shared<const Crowd>(makeCrowd(kind, vertices, spacing, kObjects, kFrames));
  const auto shape = [](const Polygon& polygon) { return std::make_shared<tricover_fcl::PolygonShaped>(polygon); };
  const auto mesh = [](const Polygon& polygon) { return makeFlatMesh(triangulate(polygon)); };
  const auto tree = [] { return makeFclManager(false); };
  const auto shapes = std::make_shared<Objects>(crowd, tree(), shape);
  std::vector<Contender> contenders = {
      framesContender("cold", Role::Ours, [=](Hits& hits) { shapes->walk<Objects::askCore>(hits); }),
      ownContender("scene", Role::Ours, std::make_shared<SceneFrames>(crowd)),
      ownContender("SceneManager", Role::Ours,
                   std::make_shared<TightObjects>(crowd, std::make_unique<tricover_fcl::SceneManagerd>(), shape)),
      ownContender("via FCL", Role::Ours, shapes),
      ownContender("tight boxes", Role::Ours, std::make_shared<TightObjects>(crowd, tree(), shape)),
      ownContender("FCL BVH", Role::Rival, std::make_shared<Objects>(crowd, tree(), mesh)),
      framesContender("manager alone", Role::Floor, [=](Hits& hits) { shapes->walk<Objects::askNothing>(hits); })};
  // Box2D is asked at several scales: where its skin of 0.02 is small to the bodies, so is what it grows their boxes
  // by.
  if (kind == workloads::Kind::Convex)
    for (const auto& [name, scale] : {std::pair("Box2D", 1.F), {"Box2D, x 0.01", 0.01F}, {"Box2D, x 0.1", 0.1F}})
      contenders.push_back(ownContender(name, Role::Box2d, std::make_shared<Box2dFrames>(*crowd, scale)));
  const Workload workload{"frames", name(kind), "2000 moving", vertices, vertices, kFrames, kObjects * kObjects};
  return measure(workload, contenders, settings);
}

Scene sceneOf(const Crowd& crowd) {
  Placement bodies;
  for (std::size_t i = 0; i < crowd.size(); ++i) bodies.push_back({crowd.shapeOf(i), crowd.poses[0][i]});
  return sceneOf(bodies);
}

/// Frames in which every `step`th body moves: on one thread by CPU time, then on one and on two by wall time.
/// Nanoseconds a moving body.
Result costOfFrames(std::size_t bodies, std::size_t step) {
  constexpr std::size_t kWarmUp = 6, kTimed = 9;
  const Crowd crowd = makeCrowd(workloads::Kind::Contour, 64, kContourSpacing, bodies, 1);
  Scene one = sceneOf(crowd), other = sceneOf(crowd);
  tbb::task_arena arena(2);
  const Parallel on_threads = [&arena](std::size_t n, const std::function<void(std::size_t)>& task) {
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, n, task); });
  };
  std::vector<double> cpu, serial, threads;
  for (std::size_t frame = 1; frame <= kWarmUp + kTimed; ++frame) {
    const std::vector<Pose> poses = crowdPoses(kContourSpacing, bodies, frame);
    std::vector<BodyPose> moves;
    for (std::size_t i = 0; i < bodies; i += step) moves.push_back({static_cast<Scene::Body>(i), poses[i]});
    const double cpu_start = threadSeconds(), start = wallSeconds();
    one.move(moves);
    one.collisions();
    const double cpu_end = threadSeconds(), middle = wallSeconds();
    other.move(moves, on_threads);
    other.collisions(on_threads);
    const double end = wallSeconds();
    if (one.collisions() != other.collisions()) throw std::logic_error("crowds: threads change the answer");
    if (frame <= kWarmUp) continue;
    cpu.push_back(cpu_end - cpu_start);
    serial.push_back(middle - start);
    threads.push_back(end - middle);
  }
  const double ns = 1e9 * static_cast<double>(step) / static_cast<double>(bodies);
  const std::string name = step == 1 ? "all moving" : "one in " + std::to_string(step) + " moving";
  return {{"crowd", std::to_string(bodies) + " bodies", name, 64, 64},
          {{"scene", Role::Ours, ns * medianOf(cpu)},
           {"wall time", Role::Floor, ns * medianOf(serial)},
           {"wall time, two threads", Role::Floor, ns * medianOf(threads)}}};
}

}  // namespace

std::vector<Result> measureFrames(const Settings& settings) {
  return {measureKind(workloads::Kind::Contour, 64, kContourSpacing, settings),
          measureKind(workloads::Kind::Convex, 8, kConvexSpacing, settings)};
}

std::vector<Result> measureCrowds() {
  std::vector<Result> results;
  for (std::size_t bodies = 1000; bodies <= 100000U; bodies *= 10)
    for (const std::size_t step : {1u, 100u}) results.push_back(costOfFrames(bodies, step));
  return results;
}

}  // namespace tricover::bench
