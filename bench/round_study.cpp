// SPDX-License-Identifier: BSD-3-Clause
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>

#include <cmath>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "prism.h"
#include "random.h"
#include "rivals/fcl_pair.h"
#include "studies.h"
#include "tricover/segment.h"
#include "tricover_fcl/tricover_fcl.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

/// Answers of FCL's solvers and ours: lengths of things a hundred units long.
constexpr Agreement kDistances = {0, {1e-6, 1e-6}, {1e-4, 1e-4}};

/// Half the height of polygons: all that is round lies between, so that FCL's answers in space are the plane's.
constexpr double kUp = 60;

/// One body in several forms: ours, and what FCL has for it: "FCL" is a Convex for a polygon, a Sphere for a disc.
struct Form {
  std::string name;
  Geometry geometry;
};
struct Body {
  std::string name;
  std::size_t vertices;
  double radius;
  Geometry ours;
  std::vector<Form> theirs;
  fcl::Matrix3d tilt = fcl::Matrix3d::Identity();
};

Geometry shape(const Polygon& polygon, double up, double margin = 0) {
  return std::make_shared<tricover_fcl::PolygonShaped>(polygon, tricover_fcl::PolygonOptions{margin, -up, up});
}

Body polygonBody(std::size_t vertices) {
  const Polygon polygon = vertices == 4 ? Polygon({{{-50, -30}, {50, -30}, {50, 30}, {-50, 30}}})
                                        : workloads::makePolygon(workloads::Kind::Convex, vertices, 1);
  Body body{"polygon", vertices, polygon.radius(), shape(polygon, kUp), {}};
  if (vertices == 4) body.theirs.push_back({"FCL Box", std::make_shared<fcl::Boxd>(100, 60, 2 * kUp)});
  body.theirs.push_back({"FCL", support::makePrism(polygon.rings().front(), kUp)});
  return body;
}

Body discBody(double radius) {
  return {"disc", 1, radius, shape(point({0, 0}), radius, radius), {{"FCL", std::make_shared<fcl::Sphered>(radius)}}};
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

constexpr std::size_t kPositions = 250;

/// Where the round body is, its centre `low` .. `high` times the sum of both radii from the fixed one's.
std::vector<fcl::Transform3d> randomPoses(double reach, const fcl::Matrix3d& tilt, double low, double high) {
  support::Random random(11);
  std::vector<fcl::Transform3d> poses;
  for (std::size_t i = 0; i < kPositions; ++i) {
    const double direction = random.real(-3.15, 3.15), away = reach * random.real(low, high);
    fcl::Transform3d pose = fcl::Transform3d::Identity();
    pose.linear() = Eigen::AngleAxisd(random.real(-3.15, 3.15), fcl::Vector3d::UnitZ()).toRotationMatrix() * tilt;
    pose.translation() = fcl::Vector3d(away * std::cos(direction), away * std::sin(direction), 0);
    poses.push_back(pose);
  }
  return poses;
}

/// Ours and FCL's solvers, each in both orders. `Query` is one of rivals/fcl_pair.h.
template <class Query>
auto contenders(const Body& fixed, const Body& moving, const std::shared_ptr<const Poses>& inputs) {
  using Answers = std::conditional_t<std::is_same_v<Query, PairCollide>, Hits, Values>;
  std::vector<ContenderFor<Answers>> all;
  const auto add = [&](const std::string& name, Role role, const Geometry& a, const Geometry& b,
                       fcl::GJKSolverType solver) {
    for (const bool swapped : {false, true}) {
      auto query = std::make_shared<Query>(a, b, inputs, solver, swapped);
      all.push_back(contender<Answers>(swapped ? name + ", swapped" : name, role, false, query, kPositions));
    }
  };
  add("via FCL", Role::Ours, fixed.ours, moving.ours, fcl::GST_LIBCCD);
  for (const Form& form : fixed.theirs) {
    const Geometry& other = moving.theirs.front().geometry;
    add(form.name + " (libccd)", Role::Rival, form.geometry, other, fcl::GST_LIBCCD);
    add(form.name + " (indep)", Role::Rival, form.geometry, other, fcl::GST_INDEP);
  }
  return all;
}

void measurePair(const Body& fixed, const Body& moving, const Settings& settings, std::vector<Result>& results) {
  const double reach = fixed.radius + moving.radius;
  const auto workload = [&](const char* query) {
    return Workload{"round", moving.name, query, fixed.vertices, moving.vertices, kPositions, 1};
  };
  const auto poses = [&](double low, double high) {
    return std::make_shared<const Poses>(randomPoses(reach, moving.tilt, low, high));
  };
  results.push_back(measure(workload("collide"), contenders<PairCollide>(fixed, moving, poses(0.4, 1.2)), settings));
  results.push_back(
      measure(workload("distance"), contenders<PairDistance>(fixed, moving, poses(1.03, 2)), kDistances, settings));
}

}  // namespace

std::vector<Result> measureRounds(const Settings& settings) {
  std::vector<Result> results;
  std::vector<Body> fixed_bodies;
  for (const std::size_t vertices : {4, 8, 64}) fixed_bodies.push_back(polygonBody(vertices));
  for (const Body& moving : roundBodies()) {
    for (const Body& fixed : fixed_bodies) measurePair(fixed, moving, settings, results);
    if (moving.name == "disc") measurePair(discBody(30), moving, settings, results);
  }
  return results;
}

}  // namespace tricover::bench
