// SPDX-License-Identifier: BSD-3-Clause
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "matrix.h"
#include "prism.h"
#include "random.h"
#include "rivals/fcl_call.h"
#include "studies.h"
#include "tricover/polygon.h"
#include "tricover_fcl/tricover_fcl.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

using Transforms = std::vector<fcl::Transform3d>;

/// Half the height of polygons: all that is round lies between, so that FCL's answers in space are the plane's.
constexpr double kUp = 60;

/// One body in several forms: ours, and what FCL has for it: "FCL" is a Convex for a polygon, a Sphere for a disc.
struct Body {
  std::string name;
  std::size_t vertices;
  double radius;
  Geometry ours;
  std::vector<std::pair<std::string, Geometry>> theirs;
  fcl::Matrix3d tilt = fcl::Matrix3d::Identity();
};

Geometry shape(const Polygon& polygon, double up, double margin = 0) {
  return std::make_shared<tricover_fcl::PolygonShaped>(polygon, tricover_fcl::PolygonOptions{margin, -up, up});
}

Body polygonBody(std::size_t vertices) {
  const Polygon polygon = vertices == 4 ? Polygon({{{-50, -30}, {50, -30}, {50, 30}, {-50, 30}}})
                                        : workloads::makePolygon(workloads::Kind::Convex, vertices, 1);
  Body body{"polygon", vertices, polygon.radius(), shape(polygon, kUp), {}};
  if (vertices == 4) body.theirs.emplace_back("FCL Box", std::make_shared<fcl::Boxd>(100, 60, 2 * kUp));
  body.theirs.emplace_back("FCL", support::makePrism(polygon.rings().front(), kUp));
  return body;
}

Body discBody(double radius) {
  return {"disc",
          1,
          radius,
          shape(Polygon::point({0, 0}), radius, radius),
          {{"FCL", std::make_shared<fcl::Sphered>(radius)}}};
}

/// One of FCL's geometries, which is the same in ours and in FCL's pairs.
Body fclBody(const std::string& name, double radius, const Geometry& geometry, const fcl::Matrix3d& tilt) {
  return {name, 1, radius, geometry, {{"", geometry}}, tilt};
}

std::vector<Body> roundBodies() {
  const fcl::Matrix3d upright = fcl::Matrix3d::Identity(),
                      lying = Eigen::AngleAxisd(static_cast<double>(EIGEN_PI) / 2, fcl::Vector3d::UnitY()).matrix();
  return {discBody(20), fclBody("sphere", 20, std::make_shared<fcl::Sphered>(20), upright),
          fclBody("cylinder", 20, std::make_shared<fcl::Cylinderd>(20, 40), upright),
          fclBody("capsule", 35, std::make_shared<fcl::Capsuled>(15, 40), lying)};
}

/// Where the round body is, its centre `low` .. `high` times the sum of both radii from the fixed one's.
Transforms randomPoses(const Body& fixed, const Body& moving, double low, double high) {
  support::Random random(11);
  Transforms poses(250, fcl::Transform3d::Identity());
  for (fcl::Transform3d& pose : poses) {
    const double direction = random.real(-3.15, 3.15), away = (fixed.radius + moving.radius) * random.real(low, high);
    pose.linear() =
        Eigen::AngleAxisd(random.real(-3.15, 3.15), fcl::Vector3d::UnitZ()).toRotationMatrix() * moving.tilt;
    pose.translation() = fcl::Vector3d(away * std::cos(direction), away * std::sin(direction), 0);
  }
  return poses;
}

/// Ours and FCL's solvers, each in both orders.
template <class Answers>
Result measured(const char* query, const Body& fixed, const Body& moving, const Transforms& poses,
                const Settings& settings) {
  MethodTable<Answers, fcl::Transform3d> table;
  const auto add = [&](const std::string& name, Role role, const Geometry& a, const Geometry& b,
                       fcl::GJKSolverType solver) {
    for (const bool swapped : {false, true})
      table.template add<FclCall>(swapped ? name + ", swapped" : name, role, false, kAny, a, b, solver, swapped);
  };
  add("via FCL", Role::Ours, fixed.ours, moving.ours, fcl::GST_LIBCCD);
  for (const auto& [name, geometry] : fixed.theirs) {
    const Geometry& other = moving.theirs.front().second;
    add(name + " (libccd)", Role::Rival, geometry, other, fcl::GST_LIBCCD);
    add(name + " (indep)", Role::Rival, geometry, other, fcl::GST_INDEP);
  }
  return measure({"round", moving.name, query, fixed.vertices, moving.vertices, poses.size()}, table.on(poses),
                 settings);
}

}  // namespace

std::vector<Result> measureRounds(Settings settings) {
  // Answers of FCL's solvers and ours: lengths of things a hundred units long.
  settings.agreement = {0, {1e-6, 1e-6}, {1e-4, 1e-4}};
  std::vector<Result> results;
  for (const Body& moving : roundBodies()) {
    std::vector<Body> fixed_bodies = {polygonBody(4), polygonBody(8), polygonBody(64)};
    if (moving.name == "disc") fixed_bodies.push_back(discBody(30));
    for (const Body& fixed : fixed_bodies) {
      results.push_back(measured<Hits>("collide", fixed, moving, randomPoses(fixed, moving, 0.4, 1.2), settings));
      results.push_back(measured<Values>("distance", fixed, moving, randomPoses(fixed, moving, 1.03, 2), settings));
    }
  }
  return results;
}

}  // namespace tricover::bench
