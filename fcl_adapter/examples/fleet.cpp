// SPDX-License-Identifier: BSD-3-Clause
// What a fleet planner asks: three robots follow cubic splines through a hall; who comes too close to whom or what,
// when and where? The bodies are prisms with safety margins, the motions fcl::SplineMotion, and FCL's continuous
// collision answers. Draws the last seconds before the first conflict.
#include <fcl/math/motion/spline_motion.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/continuous_collision_object.h>
#include <fcl/narrowphase/distance.h>
#include <tricover/segment.h>
#include <tricover/svg.h>
#include <tricover_fcl/tricover_fcl.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "picture.h"

namespace {

constexpr double kStart = 0, kEnd = 12;  // seconds

/// A moment of a plan: x, y and heading, and their rates per second.
struct Knot {
  double time;
  Eigen::Vector3d at, rates;
};

/// Metres and radians; it begins at kStart, ends at kEnd, and is a cubic Hermite spline from knot to knot.
using Plan = std::vector<Knot>;

struct Body {
  std::string name;
  std::shared_ptr<tricover_fcl::PolygonShaped> shape;
  Plan plan;
};

struct Conflict {
  const Body *who, *with;
  double when;
  tricover::Vec2 where;
};

Body body(std::string name, tricover::Polygon polygon, const tricover_fcl::PolygonOptions& options, Plan plan) {
  return {std::move(name), std::make_shared<tricover_fcl::PolygonShaped>(std::move(polygon), options), std::move(plan)};
}

Plan standing() {
  return {{kStart, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()},
          {kEnd, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()}};
}

tricover::Ring rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

std::vector<Body> hall() {
  return {body("walls", tricover::Polygon({rectangle(-0.2, -0.2, 12.2, 8.2), rectangle(0, 0, 12, 8)}), {0, 0, 3},
               standing()),
          body("rack", tricover::Polygon({rectangle(2.5, 5.2, 6, 6.2)}), {0, 0, 3}, standing()),
          body("bridge", tricover::Polygon({rectangle(8.2, 0, 8.8, 8)}), {0, 1.6, 2}, standing())};  // overhead
}

/// Each keeps 0.15 m: two robots are in conflict within 0.3 m of each other, a robot and a wall within 0.15 m.
std::vector<Body> fleet() {
  constexpr double kMargin = 0.15, kQuarter = static_cast<double>(EIGEN_PI) / 2;
  const tricover::Ring fork = {{-0.5, -0.4}, {0.9, -0.4}, {0.9, -0.25}, {0, -0.25},
                               {0, 0.25},    {0.9, 0.25}, {0.9, 0.4},   {-0.5, 0.4}};
  return {body("forklift", tricover::Polygon({fork}), {kMargin, 0, 2.1},  // too high for the bridge
               {{0, {1, 3, 0}, {0.6, 0, 0}}, {5, {4.5, 3.6, 0.5}, {0.8, 0.3, 0.1}}, {12, {10.8, 6.6, 0}, {0.6, 0, 0}}}),
          body("tug", tricover::Polygon({rectangle(-0.6, -0.3, 0.6, 0.3)}), {kMargin, 0, 0.8},
               {{0, {11, 1, 2 * kQuarter}, {-0.9, 0, 0}},
                {6, {6.2, 2.2, 1.2 * kQuarter}, {-0.3, 0.9, -0.3}},
                {12, {7, 7.2, kQuarter}, {0, 0.4, 0}}}),
          body("shuttle", tricover::point({0, 0}), {0.35 + kMargin, 0, 0.4},  // a disc
               {{0, {1, 7, -kQuarter}, {0, -0.8, 0}},
                {4, {1.6, 4.4, -kQuarter / 2}, {0.6, -0.4, 0.4}},
                {12, {11, 1.2, 0}, {0.9, 0, 0}}})};
}

/// The moment at `time` of the cubic from a to b.
Knot between(const Knot& a, const Knot& b, double time) {
  const double length = b.time - a.time, s = (time - a.time) / length;
  const Eigen::Vector3d way = b.at - a.at, v = length * a.rates, w = length * b.rates;
  const Eigen::Vector3d squared = 3 * way - 2 * v - w, cubed = v + w - 2 * way;
  return {time, a.at + s * (v + s * (squared + s * cubed)), (v + s * (2 * squared + 3 * s * cubed)) / length};
}

Knot moment(const Plan& plan, double time) {
  std::size_t next = 1;
  while (next + 1 < plan.size() && plan[next].time < time) ++next;
  return between(plan[next - 1], plan[next], time);
}

/// The same cubic as FCL has it: one segment of a uniform B-spline, which takes one unit of time. FCL's turns are
/// vectors, here along z.
std::shared_ptr<fcl::MotionBased> motion(const Knot& a, const Knot& b) {
  const double length = b.time - a.time;
  const Eigen::Vector3d v = length * a.rates, w = length * b.rates;
  const Eigen::Vector3d p1 = 2 * a.at - b.at + (2 * v + w) / 3, p2 = 2 * b.at - a.at - (v + 2 * w) / 3;
  const Eigen::Vector3d p0 = p2 - 2 * v, p3 = p1 + 2 * w;
  const auto shift = [](const Eigen::Vector3d& p) { return fcl::Vector3d(p.x(), p.y(), 0); };
  const auto turn = [](const Eigen::Vector3d& p) { return fcl::Vector3d(0, 0, p.z()); };
  return std::make_shared<fcl::SplineMotion<double>>(shift(p0), shift(p1), shift(p2), shift(p3), turn(p0), turn(p1),
                                                     turn(p2), turn(p3));
}

/// Where two bodies touch that are as near as their margins: between the nearest points of their polygons.
tricover::Vec2 touchingPoint(const Body& a, const fcl::Transform3d& pose_a, const Body& b,
                             const fcl::Transform3d& pose_b) {
  fcl::DistanceRequestd request;
  request.enable_nearest_points = true;
  fcl::DistanceResultd result;
  fcl::distance(a.shape.get(), pose_a, b.shape.get(), pose_b, request, result);
  const double margin_a = a.shape->options().margin, margin_b = b.shape->options().margin;
  const fcl::Vector3d way = result.nearest_points[1] - result.nearest_points[0];
  return (result.nearest_points[0] + way * (margin_a / (margin_a + margin_b))).head<2>();
}

std::optional<Conflict> firstConflict(const Body& a, const Body& b) {
  // Between two knots of either plan, both bodies move along one cubic.
  std::set<double> times;
  for (const Plan* plan : {&a.plan, &b.plan}) {
    for (const Knot& knot : *plan) times.insert(knot.time);
  }
  for (auto begin = times.begin(), end = std::next(begin); end != times.end(); ++begin, ++end) {
    const auto object = [&](const Body& body) {
      return fcl::ContinuousCollisionObjectd(body.shape, motion(moment(body.plan, *begin), moment(body.plan, *end)));
    };
    const fcl::ContinuousCollisionObjectd object_a = object(a), object_b = object(b);
    fcl::ContinuousCollisionRequestd request;
    request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    request.toc_err = 1e-6;
    fcl::ContinuousCollisionResultd result;
    fcl::collide(&object_a, &object_b, request, result);
    if (!result.is_collide) continue;
    return Conflict{&a, &b, *begin + result.time_of_contact * (*end - *begin),
                    touchingPoint(a, result.contact_tf1, b, result.contact_tf2)};
  }
  return {};
}

std::vector<Conflict> allConflicts(const std::vector<Body>& robots, const std::vector<Body>& obstacles) {
  std::vector<Conflict> conflicts;
  const auto ask = [&](const Body& who, const Body& with) {
    if (const auto conflict = firstConflict(who, with)) conflicts.push_back(*conflict);
  };
  for (std::size_t i = 0; i < robots.size(); ++i) {
    for (std::size_t j = i + 1; j < robots.size(); ++j) ask(robots[i], robots[j]);
    for (const Body& obstacle : obstacles) ask(robots[i], obstacle);
  }
  std::sort(conflicts.begin(), conflicts.end(), [](const Conflict& p, const Conflict& q) { return p.when < q.when; });
  return conflicts;
}

void print(const std::vector<Conflict>& conflicts) {
  std::cout << std::fixed << std::left << std::setw(10) << "who" << std::setw(10) << "with"
            << "when     where\n";
  for (const Conflict& conflict : conflicts) {
    std::cout << std::setw(10) << conflict.who->name << std::setw(10) << conflict.with->name << std::right
              << std::setprecision(3) << std::setw(6) << conflict.when << " s (" << std::setprecision(2)
              << conflict.where.x() << ", " << conflict.where.y() << ")\n"
              << std::left;
  }
}

/// A disc of the margin about every vertex, and what it sweeps along every edge.
tricover::Polygon marginOf(const tricover_fcl::PolygonShaped& shape) {
  const double margin = shape.options().margin;
  std::vector<tricover::Ring> rings;
  for (const tricover::Ring& ring : shape.polygon().rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const tricover::Vec2 p = ring[i], edge = ring[(i + 1) % ring.size()] - p;
      tricover::Ring disc;
      for (int k = 0; k < 32; ++k) {
        disc.push_back(p + Eigen::Rotation2Dd(k * static_cast<double>(EIGEN_PI) / 16) * tricover::Vec2(margin, 0));
      }
      rings.push_back(disc);
      if (edge.isZero()) continue;
      const tricover::Vec2 aside = margin * tricover::Vec2(edge.y(), -edge.x()).normalized();
      rings.push_back({p + aside, p + edge + aside, p + edge - aside, p - aside});
    }
  }
  return tricover::Polygon(rings, tricover::FillRule::NonZero);
}

/// Pictures side by side: the hall, the robots with their margins, and the ways that they have gone.
tricover::SvgDrawing strip(const std::vector<Body>& robots, const std::vector<Body>& obstacles,
                           const Conflict& conflict) {
  constexpr int kPictures = 4;
  constexpr double kApart = 13, kSeconds = 1.5;
  tricover::SvgDrawing drawing(1600);
  for (int i = 0; i < kPictures; ++i) {
    const double now = conflict.when - kSeconds * (kPictures - 1 - i);
    const auto poseAt = [&](const Body& body, double time) {
      const Eigen::Vector3d at = moment(body.plan, time).at;
      tricover::Pose pose = tricover::Pose::Identity();
      pose.linear() = Eigen::Rotation2Dd(at.z()).toRotationMatrix();
      pose.translation() = at.head<2>() + tricover::Vec2(kApart * i, 0);
      return pose;
    };
    for (const Body& obstacle : obstacles) {
      const bool overhead = obstacle.shape->options().z_low > 0;
      drawing.polygon(obstacle.shape->polygon(), poseAt(obstacle, now), overhead ? "#fef3c7" : "#d6d3d1");
    }
    for (const Body& robot : robots) {
      const bool involved = &robot == conflict.who || &robot == conflict.with;
      std::vector<tricover::Vec2> way;
      for (double time = kStart; time < now; time += 0.1) way.push_back(poseAt(robot, time).translation());
      way.push_back(poseAt(robot, now).translation());
      drawing.polyline(way, "#1d4ed8");
      const char* const around = involved && i + 1 == kPictures ? "#fecaca" : "#bbf7d0";
      drawing.polygon(marginOf(*robot.shape), poseAt(robot, now), around, around);
      drawing.polygon(robot.shape->polygon(), poseAt(robot, now),
                      involved && i + 1 == kPictures ? "#dc2626" : "#16a34a");
    }
    std::ostringstream caption;
    caption << std::fixed << std::setprecision(2) << now << " s";
    drawing.text(tricover::Vec2(kApart * i + 6, -1), caption.str());
  }
  return drawing;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string usage = "usage: fleet [picture.svg]\n";
  return runExample(argc, argv, usage, "fleet.svg", 1, [](const std::vector<std::string>& arguments) {
    tricover_fcl::registerNarrowphase();
    const std::vector<Body> robots = fleet(), obstacles = hall();
    const std::vector<Conflict> conflicts = allConflicts(robots, obstacles);
    print(conflicts);
    if (!conflicts.empty()) savePicture(strip(robots, obstacles, conflicts[0]), arguments[0]);
    return 0;
  });
}
