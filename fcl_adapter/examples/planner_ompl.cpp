// SPDX-License-Identifier: BSD-3-Clause
// OMPL plans a ship's way in SE(2); its validity checker is FCL's broadphase and FCL's callback as they are: on
// tricover's shapes, and on flat BVH meshes of the same polygons. Same seeds, same answers.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/RandomNumbers.h>
#include <tricover/svg.h>
#include <tricover_fcl/tricover_fcl.h>

#include <deque>
#include <iostream>

#include "baltic.h"
#include "picture.h"
#include "triangulate.h"

namespace {

namespace base = ompl::base;
using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;
using State = baltic::Berth;  // x, y, angle

Geometry shapeOf(const tricover::Polygon& polygon) { return std::make_shared<tricover_fcl::PolygonShaped>(polygon); }

State stateOf(const base::State* state) {
  const auto& se2 = *state->as<base::SE2StateSpace::StateType>();
  return {se2.getX(), se2.getY(), se2.getYaw()};
}

tricover::Pose poseOf(const State& s) { return Eigen::Translation2d(s.x, s.y) * Eigen::Rotation2Dd(s.angle); }

struct Plan {
  std::vector<bool> answers;  // whether what the planner asked about was free, in order
  std::vector<State> way;
};
/// Nothing but FCL and OMPL, which don't know which geometries they were given.
Plan plan(Geometry (*geometryOf)(const tricover::Polygon&), std::uint_fast32_t seed) {
  const Geometry hull = geometryOf(baltic::ship());
  fcl::CollisionObjectd ship(hull);
  const auto place = [](fcl::CollisionObjectd& object, const State& state) {
    object.setTransform(fcl::AngleAxisd(state.angle, fcl::Vector3d::UnitZ()).matrix(), {state.x, state.y, 0});
    object.computeAABB();
  };
  std::deque<fcl::CollisionObjectd> others;
  others.emplace_back(geometryOf(baltic::land()));
  for (const State& berth : baltic::anchored()) place(others.emplace_back(hull), berth);
  fcl::DynamicAABBTreeCollisionManagerd manager;
  for (fcl::CollisionObjectd& other : others) manager.registerObject(&other);
  manager.setup();

  Plan plan;
  ompl::RNG::setSeed(seed);
  const auto space = std::make_shared<base::SE2StateSpace>();
  base::RealVectorBounds bounds(2);
  bounds.setLow(-690), bounds.setHigh(770);
  space->setBounds(bounds);
  ompl::geometric::SimpleSetup setup(space);
  setup.setStateValidityChecker([&](const base::State* state) {
    place(ship, stateOf(state));
    fcl::DefaultCollisionData<double> data;
    manager.collide(&ship, &data, fcl::DefaultCollisionFunction);
    plan.answers.push_back(!data.result.isCollision());
    return !data.result.isCollision();
  });
  setup.getSpaceInformation()->setStateValidityCheckingResolution(0.002);
  base::ScopedState<base::SE2StateSpace> start(space), goal(space);
  start->setXY(340, 660), start->setYaw(-2.4);
  goal->setXY(-590, -560), goal->setYaw(1.5);
  setup.setStartAndGoalStates(start, goal);
  setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(setup.getSpaceInformation()));
  setup.solve(base::plannerNonTerminatingCondition());
  setup.simplifySolution(base::plannerNonTerminatingCondition());
  setup.getSolutionPath().interpolate(150);
  for (const base::State* state : setup.getSolutionPath().getStates()) plan.way.push_back(stateOf(state));
  return plan;
}

int run(const std::vector<std::string>& arguments) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  tricover::SvgDrawing drawing;
  drawing.polygon(baltic::land(), tricover::Pose::Identity(), "#e7e5e4");
  for (const State& berth : baltic::anchored()) drawing.polygon(baltic::ship(), poseOf(berth), "#a8a29e");
  for (std::uint_fast32_t seed = 1; seed <= 3; ++seed) {
    const Plan shapes = plan(shapeOf, seed), meshes = plan(mesh::meshOf, seed);
    std::cout << "seed " << seed << ": " << shapes.answers.size() << " states, on meshes "
              << (shapes.answers == meshes.answers ? "the same" : "OTHER") << " answers\n";
    for (const State& state : shapes.way) drawing.polygon(baltic::ship(), poseOf(state), "none", "#1d4ed8");
  }
  savePicture(drawing, arguments[0]);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return runExample(argc, argv, "usage: planner_ompl [picture.svg]\n", "planner_ompl.svg", 1, run);
}
