// SPDX-License-Identifier: BSD-3-Clause
// What a fleet planner asks: three robots follow their plans through a hall; who comes too close to whom or what, when
// and where? The bodies are prisms with safety margins, the plans splines from knot to knot, each by times of its own,
// and FCL's continuous collision answers. Writes a recording, which a browser plays.
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/continuous_collision_object.h>
#include <fcl/narrowphase/distance.h>
#include <tricover/tricover.h>
#include <tricover_fcl/tricover_fcl.h>

#include <algorithm>
#include <iomanip>
#include <iostream>

#include "picture.h"

namespace {

constexpr double kEnd = 12, kMargin = 0.15, kQuarter = M_PI / 2;  // seconds, metres, radians

struct Body {
  std::string name;
  tricover::Trajectory plan;
  std::shared_ptr<tricover_fcl::PolygonShaped> shape;
  std::shared_ptr<tricover_fcl::TrajectoryMotiond> motion;  // FCL's time 0 and 1 are 0 s and kEnd

  Body(std::string name_, const tricover::Polygon& polygon, const tricover_fcl::PolygonOptions& options,
       const tricover::Trajectory& plan_)
      : name(std::move(name_)),
        plan(plan_),
        shape(std::make_shared<tricover_fcl::PolygonShaped>(polygon, options)),
        motion(std::make_shared<tricover_fcl::TrajectoryMotiond>(plan, 0, kEnd)) {}
};

struct Meeting {
  std::size_t who, with;
  double when;
  tricover::Vec2 where;
};

tricover::Polygon rectangle(double x0, double y0, double x1, double y1) {
  return tricover::Polygon({{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}});
}

/// The robots come first. Each keeps kMargin: two robots are in conflict within twice that.
std::vector<Body> hall() {
  using tricover::Trajectory;
  const Trajectory stands({{0, kEnd, tricover::Motion::still(tricover::Pose::Identity())}});
  const tricover::Polygon fork(
      {{{-0.5, -0.4}, {0.9, -0.4}, {0.9, -0.25}, {0, -0.25}, {0, 0.25}, {0.9, 0.25}, {0.9, 0.4}, {-0.5, 0.4}}}),
      walls({rectangle(-0.2, -0.2, 12.2, 8.2).rings()[0], rectangle(0, 0, 12, 8).rings()[0]});
  return {{"forklift",
           fork,
           {kMargin, 0, 2.1},  // too high for the bridge; time, x and y, heading, and their rates
           Trajectory::spline({{0, {{1, 3}, 0, {0.6, 0}, 0}},
                               {5, {{4.5, 3.6}, 0.5, {0.8, 0.3}, 0.1}},
                               {12, {{10.8, 6.6}, 0, {0.6, 0}, 0}}})},
          {"tug",
           rectangle(-0.6, -0.3, 0.6, 0.3),
           {kMargin, 0, 0.8},
           Trajectory::spline({{0, {{11, 1}, 2 * kQuarter, {-0.9, 0}, 0}},
                               {6, {{6.2, 2.2}, 1.2 * kQuarter, {-0.3, 0.9}, -0.3}},
                               {12, {{7, 7.2}, kQuarter, {0, 0.4}, 0}}})},
          {"shuttle",
           tricover::Polygon::point({0, 0}),
           {0.35 + kMargin, 0, 0.4},  // a disc
           Trajectory::spline({{0, {{1, 7}, -kQuarter, {0, -0.8}, 0}},
                               {4, {{1.6, 4.4}, -kQuarter / 2, {0.6, -0.4}, 0.4}},
                               {12, {{11, 1.2}, 0, {0.9, 0}, 0}}})},
          {"walls", walls, {0, 0, 3}, stands},
          {"rack", rectangle(2.5, 5.2, 6, 6.2), {0, 0, 3}, stands},
          {"bridge", rectangle(8.2, 0, 8.8, 8), {0, 1.6, 2}, stands}};  // overhead
}

std::vector<Meeting> meetings(const std::vector<Body>& bodies, std::size_t robots) {
  std::vector<Meeting> found;
  for (std::size_t i = 0; i < robots; ++i) {
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      const Body &who = bodies[i], &with = bodies[j];
      const fcl::ContinuousCollisionObjectd a(who.shape, who.motion), b(with.shape, with.motion);
      fcl::ContinuousCollisionRequestd request;
      request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
      request.toc_err = 1e-6;
      fcl::ContinuousCollisionResultd result;
      fcl::collide(&a, &b, request, result);
      if (!result.is_collide) continue;
      // Of shapes grown by their margins, which touch.
      const fcl::DistanceRequestd ask_points(true);
      fcl::DistanceResultd apart;
      fcl::distance(who.shape.get(), result.contact_tf1, with.shape.get(), result.contact_tf2, ask_points, apart);
      found.push_back({i, j, who.motion->clockAt(result.time_of_contact), apart.nearest_points[0].head<2>()});
    }
  }
  std::sort(found.begin(), found.end(), [](const Meeting& p, const Meeting& q) { return p.when < q.when; });
  return found;
}

/// The robots on their ways, with their margins, and where the library says that they meet.
tricover::SceneRecording recordingOf(const std::vector<Body>& bodies, std::size_t robots,
                                     const std::vector<Meeting>& found) {
  tricover::Scene scene;
  std::vector<tricover::Scene::Body> handles;
  std::vector<tricover::BodyTrajectory> plans;
  tricover::BodyOptions options;
  for (const Body& body : bodies) {
    options.margin = body.shape->options().margin;
    handles.push_back(scene.add(body.shape->polygon(), body.plan.at(0), options));
    if (handles.size() <= robots) plans.push_back({handles.back(), body.plan});
  }
  std::vector<tricover::PairImpact> impacts;
  for (const auto& [who, with, when, where] : found) {
    const Body &a = bodies[who], &b = bodies[with];
    const auto apart = tricover::distance(a.shape->polygon(), a.plan.at(when), b.shape->polygon(), b.plan.at(when));
    tricover::Impact impact{};
    impact.time = when;
    impact.point = where;
    impact.normal = (apart.point_b - apart.point_a).normalized();
    impacts.push_back({{handles[who], handles[with]}, impact});
  }
  tricover::SceneRecording recording("A hall");
  recording.trajectories(scene, plans);
  recording.impacts(impacts);
  for (std::size_t i = 0; i < bodies.size(); ++i) recording.name(handles[i], bodies[i].name);
  return recording;
}

}  // namespace

int main(int argc, char** argv) {
  return runExample(argc, argv, "usage: fleet [recording.html]\n", "fleet.html", 1, [](const auto& arguments) {
    tricover_fcl::registerNarrowphase();
    const std::vector<Body> bodies = hall();
    const std::vector<Meeting> found = meetings(bodies, 3);
    std::cout << "who       with      when     where\n" << std::fixed;
    for (const auto& [who, with, when, where] : found)
      std::cout << std::left << std::setw(10) << bodies[who].name << std::setw(10) << bodies[with].name << std::right
                << std::setprecision(3) << std::setw(6) << when << " s (" << std::setprecision(2) << where.x() << ", "
                << where.y() << ")\n";
    savePicture(recordingOf(bodies, 3, found), arguments[0]);
    return 0;
  });
}
