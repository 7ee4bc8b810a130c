// SPDX-License-Identifier: BSD-3-Clause
// OMPL plans a ship's way, its validity checker being FCL's broadphase and FCL's callback as they are. Once the
// geometries are tricover's shapes, once flat BVH meshes of the same polygons: same seeds, same answers. `planner_ompl
// [picture.svg]`
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/RandomNumbers.h>
#include <tricover/svg.h>
#include <tricover_fcl/tricover_fcl.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <vector>

#include "baltic.h"
#include "picture.h"
#include "triangulate.h"

namespace {

namespace base = ompl::base;
using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;
using State = baltic::Berth;  // x, y, angle

Geometry shapeOf(const tricover::Polygon& polygon) { return std::make_shared<tricover_fcl::PolygonShaped>(polygon); }

Geometry meshOf(const tricover::Polygon& polygon) {
  auto mesh = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  mesh->beginModel();
  for (const mesh::Triangle& t : mesh::triangulate(polygon)) {
    mesh->addTriangle({t[0].x(), t[0].y(), 0}, {t[1].x(), t[1].y(), 0}, {t[2].x(), t[2].y(), 0});
  }
  mesh->endModel();
  return mesh;
}

/// Nothing but FCL: it doesn't know which geometries it was given.
class Harbour {
 public:
  explicit Harbour(Geometry (*geometryOf)(const tricover::Polygon&)) : hull_(geometryOf(baltic::ship())), ship_(hull_) {
    add(geometryOf(baltic::land()), {0, 0, 0});
    for (const baltic::Berth& berth : baltic::anchored()) add(hull_, berth);
    manager_.setup();
  }

  bool isFree(const State& state) {
    place(ship_, state);
    fcl::DefaultCollisionData<double> data;
    manager_.collide(&ship_, &data, fcl::DefaultCollisionFunction);
    return !data.result.isCollision();
  }

 private:
  static void place(fcl::CollisionObjectd& object, const State& state) {
    object.setRotation(Eigen::AngleAxisd(state.angle, fcl::Vector3d::UnitZ()).toRotationMatrix());
    object.setTranslation(fcl::Vector3d(state.x, state.y, 0));
    object.computeAABB();
  }

  void add(const Geometry& geometry, const State& state) {
    objects_.push_back(std::make_unique<fcl::CollisionObjectd>(geometry));
    place(*objects_.back(), state);
    manager_.registerObject(objects_.back().get());
  }

  Geometry hull_;
  fcl::CollisionObjectd ship_;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
  fcl::DynamicAABBTreeCollisionManagerd manager_;
};

double secondsSince(std::clock_t start) { return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC; }

struct Run {
  double seconds;             // of planning, all told
  std::vector<State> asked;   // by the planner, in order
  std::vector<bool> answers;  // whether they were free
  std::vector<State> path;
};

Run plan(Harbour& harbour, std::uint_fast32_t seed) {
  // All random numbers of what is made from here on. OMPL warns that others were made before: those of earlier runs.
  ompl::RNG::setSeed(seed);
  Run run{};
  auto space = std::make_shared<base::SE2StateSpace>();
  base::RealVectorBounds bounds(2);
  bounds.setLow(-690);
  bounds.setHigh(770);
  space->setBounds(bounds);
  ompl::geometric::SimpleSetup setup(space);
  setup.setStateValidityChecker([&](const base::State* state) {
    const auto* se2 = state->as<base::SE2StateSpace::StateType>();
    run.asked.push_back({se2->getX(), se2->getY(), se2->getYaw()});
    run.answers.push_back(harbour.isFree(run.asked.back()));
    return static_cast<bool>(run.answers.back());
  });
  setup.getSpaceInformation()->setStateValidityCheckingResolution(0.002);
  base::ScopedState<base::SE2StateSpace> start(space), goal(space);
  start->setX(340);
  start->setY(660);
  start->setYaw(-2.4);
  goal->setX(-590);
  goal->setY(-560);
  goal->setYaw(1.5);
  setup.setStartAndGoalStates(start, goal);
  setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(setup.getSpaceInformation()));

  const std::clock_t begin = std::clock();
  const base::PlannerStatus status = setup.solve(base::plannerNonTerminatingCondition());
  if (status != base::PlannerStatus::EXACT_SOLUTION)
    throw std::runtime_error("OMPL found no way: " + status.asString());
  ompl::geometric::PathGeometric path = setup.getSolutionPath();
  setup.getPathSimplifier()->simplify(path, base::plannerNonTerminatingCondition());
  run.seconds = secondsSince(begin);
  path.interpolate(150);
  for (const base::State* state : path.getStates()) {
    const auto* se2 = state->as<base::SE2StateSpace::StateType>();
    run.path.push_back({se2->getX(), se2->getY(), se2->getYaw()});
  }
  return run;
}

/// Seconds that the checks alone take, all asked once more.
double timeOfChecks(Harbour& harbour, const Run& run) {
  const std::clock_t begin = std::clock();
  std::size_t changed = 0;
  for (std::size_t i = 0; i < run.asked.size(); ++i) changed += harbour.isFree(run.asked[i]) != run.answers[i];
  const double seconds = secondsSince(begin);
  if (changed > 0) throw std::logic_error("the checker changed its mind");
  return seconds;
}

void draw(const std::vector<State>& path, const std::string& file) {
  const auto poseOf = [](const State& state) {
    tricover::Pose pose = tricover::Pose::Identity();
    pose.linear() = Eigen::Rotation2Dd(state.angle).toRotationMatrix();
    pose.translation() = tricover::Vec2(state.x, state.y);
    return pose;
  };
  tricover::SvgDrawing drawing;
  drawing.polygon(baltic::land(), tricover::Pose::Identity(), "#e7e5e4");
  for (const baltic::Berth& berth : baltic::anchored()) drawing.polygon(baltic::ship(), poseOf(berth), "#a8a29e");
  std::vector<tricover::Vec2> line;
  for (const State& state : path) line.emplace_back(state.x, state.y);
  for (std::size_t i = 0; i < path.size(); i += 3) drawing.polygon(baltic::ship(), poseOf(path[i]), "#16a34a");
  drawing.polyline(line, "#1d4ed8");
  savePicture(drawing, file);
}

int compare(const std::string& picture) {
  tricover_fcl::registerNarrowphase();
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  Harbour shapes(shapeOf), meshes(meshOf);
  std::size_t states = 0, disagreements = 0;
  std::vector<double> planning, checking;
  for (std::uint_fast32_t seed = 1; seed <= 3; ++seed) {
    const Run ours = plan(shapes, seed), theirs = plan(meshes, seed);
    // With equal answers the planner's random numbers lead it through equal states.
    const std::size_t asked = std::min(ours.asked.size(), theirs.asked.size());
    for (std::size_t i = 0; i < asked; ++i) {
      const State &u = ours.asked[i], &v = theirs.asked[i];
      if (u.x != v.x || u.y != v.y || u.angle != v.angle) throw std::logic_error("the planner took another way");
      disagreements += ours.answers[i] != theirs.answers[i];
    }
    disagreements += std::max(ours.asked.size(), theirs.asked.size()) - asked;
    states += asked;
    planning.push_back(theirs.seconds / ours.seconds);
    checking.push_back(timeOfChecks(meshes, theirs) / timeOfChecks(shapes, ours));
    std::cout << "seed " << seed << ": " << ours.asked.size() << " states, " << std::lround(1e3 * ours.seconds)
              << " ms; on meshes " << std::lround(1e3 * theirs.seconds) << " ms\n";
    if (seed == 1) draw(ours.path, picture);
  }
  std::sort(planning.begin(), planning.end());
  std::sort(checking.begin(), checking.end());
  std::cout << "meshes / shapes, median: planning " << planning[1] << ", the checks alone " << checking[1] << ": "
            << disagreements << " disagreements in " << states << " states\n";
  return disagreements == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return runExample(argc, argv, "usage: planner_ompl [picture.svg]\n", "planner_ompl.svg", 1,
                    [](const std::vector<std::string>& arguments) { return compare(arguments[0]); });
}
