// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "layout.h"
#include "maps.h"
#include "matrix.h"
#include "rivals/boost.h"
#include "rivals/fcl_call.h"
#include "rivals/geos.h"
#include "scene_studies.h"
#include "tricover_fcl/tricover_fcl.h"

namespace tricover::bench {
namespace {

/// Bodies at rest as `Bodies` keeps them, asked whether a polygon meets any. See rivals/ for the others' ways.
template <class Bodies>
class Asker {
 public:
  Asker(Bodies bodies, Polygon moving) : bodies_(std::move(bodies)), moving_(std::move(moving)) {}
  void prepare(std::vector<Pose> poses) { poses_ = std::move(poses); }
  bool collide(std::size_t i) const { return bodies_.collides(moving_, poses_[i]); }

 private:
  Bodies bodies_;
  Polygon moving_;
  std::vector<Pose> poses_;
};
struct ScanAsker : Asker<CoreScan> {
  ScanAsker(const Placement& bodies, const Polygon& moving) : Asker(CoreScan(bodies), moving) {}
};
struct SceneAsker : Asker<Scene> {
  SceneAsker(const Placement& bodies, const Polygon& moving) : Asker(sceneOf(bodies), moving) {}
};

/// Our shapes under one of FCL's managers, by unmodified fcl::collide.
class FclAsker : public FclPosed {
 public:
  FclAsker(const Placement& placement, const Polygon& moving, bool array_tree)
      : moving_(std::make_shared<tricover_fcl::PolygonShaped>(moving)), manager_(makeFclManager(array_tree)) {
    std::map<std::uint64_t, Geometry> shapes;  // one for all copies of a polygon
    std::vector<fcl::CollisionObjectd*> all;
    for (const auto& [polygon, pose] : placement) {
      Geometry& shape = shapes[polygon.id()];
      if (!shape) shape = std::make_shared<tricover_fcl::PolygonShaped>(polygon);
      still_.push_back(std::make_unique<fcl::CollisionObjectd>(shape, toTransform(pose)));
      still_.back()->computeAABB();
      all.push_back(still_.back().get());
    }
    manager_->registerObjects(all);
    manager_->setup();
  }

  bool collide(std::size_t i) {
    moving_.setTransform(transforms_[i]);
    moving_.computeAABB();
    fcl::CollisionResultd result;
    manager_->collide(&moving_, &result, meet);
    return result.isCollision();
  }

 private:
  static bool meet(fcl::CollisionObjectd* o1, fcl::CollisionObjectd* o2, void* data) {
    static const fcl::CollisionRequestd request;
    return fcl::collide(o1, o2, request, *static_cast<fcl::CollisionResultd*>(data)) > 0;
  }

  std::vector<std::unique_ptr<fcl::CollisionObjectd>> still_;
  fcl::CollisionObjectd moving_;
  FclManager manager_;
};

/// A polygon that asks, and the bodies around it.
using Question = std::pair<Placement, Polygon>;

/// Asks the questions in turn: position i is of question i % n.
template <class Asker>
class InTurn {
 public:
  template <class... Arguments>
  explicit InTurn(const std::vector<Question>& questions, const Arguments&... arguments) {
    for (const auto& [bodies, moving] : questions)
      askers_.push_back(std::make_unique<Asker>(bodies, moving, arguments...));
  }
  void prepare(const std::vector<Pose>& poses) {
    for (std::size_t k = 0; k < askers_.size(); ++k) {
      std::vector<Pose> own;
      for (std::size_t i = k; i < poses.size(); i += askers_.size()) own.push_back(poses[i]);
      askers_[k]->prepare(own);
    }
  }
  bool collide(std::size_t i) { return askers_[i % askers_.size()]->collide(i / askers_.size()); }

 private:
  std::vector<std::unique_ptr<Asker>> askers_;
};

MethodTable<Hits> methodsOn(const std::vector<Question>& questions) {
  MethodTable<Hits> table;
  table.add<InTurn<ScanAsker>>("cold", Role::Ours, false, kAny, questions);
  table.add<InTurn<SceneAsker>>("scene", Role::Ours, false, kAny, questions);
  table.add<InTurn<FclAsker>>("via FCL", Role::Ours, false, kAny, questions, false);
  table.add<InTurn<FclAsker>>("via FCL, array tree", Role::Ours, false, kAny, questions, true);
  table.add<InTurn<GeosTree>>("GEOS STRtree", Role::Rival, false, kAny, questions);
  table.add<InTurn<BoostTree>>("Boost rtree", Role::Rival, false, kAny, questions);
  return table;
}

}  // namespace

std::vector<Result> measureLayouts(const Settings& settings) {
  const std::pair<int, std::size_t> classes[] = {{5, 8}, {12, 20}, {40, 64}, {120, 200}};
  const std::pair<Placing, const char*> ways[] = {
      {Placing::Free, "free"}, {Placing::Local, "local"}, {Placing::Uniform, "uniform"}};
  std::vector<Result> results;
  for (const auto& [least, most] : classes) {
    const Placement layout = makeLayout(80, least, static_cast<int>(most), 7);
    const std::vector<Lifted> all = liftedParts(layout);
    std::vector<Question> questions;
    for (const Lifted& lifted : all) questions.emplace_back(lifted.others, lifted.part.polygon);
    const MethodTable<Hits> methods = methodsOn(questions);
    for (const auto& [placing, name] : ways) {
      std::vector<Pose> poses(all.size() * kPlacings);
      for (std::size_t k = 0; k < all.size(); ++k) {
        const std::vector<Pose> own = placings(all[k], placing, kPlacings, all[k].index);
        for (std::size_t i = 0; i < kPlacings; ++i) poses[i * all.size() + k] = own[i];
      }
      const std::string scene = std::to_string(least) + " to " + std::to_string(most) + " vertices";
      results.push_back(
          measure({"layout", scene, name, vertexCount(layout), most, poses.size()}, methods.on(poses), settings));
    }
  }
  return results;
}

std::vector<Result> measureMaps(const Countries& countries, const Settings& settings) {
  constexpr std::size_t kPoses = 10000;
  const Polygon robot = forkLift();
  std::vector<Result> results;
  for (const auto& [name, bodies] : allMaps(countries)) {
    const MethodTable<Hits> methods = methodsOn({{bodies, robot}});
    const std::pair<const char*, std::vector<Pose>> ways[] = {
        {"random poses", randomPoses(bodies, kPoses, 3)}, {"a planner's path", plannerPath(bodies, robot, kPoses, 4)}};
    for (const auto& [way, poses] : ways)
      results.push_back(measure({"map", name, way, vertexCount(bodies), robot.vertexCount(), poses.size()},
                                methods.on(poses), settings));
  }
  return results;
}

}  // namespace tricover::bench
