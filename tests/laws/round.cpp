// SPDX-License-Identifier: BSD-3-Clause
// Polygons at all heights and FCL's round bodies, between what an outline within the body's shadow and one around it
// say.
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <cmath>
#include <memory>
#include <string>

#include "law.h"
#include "pairs.h"
#include "reference.h"
#include "reproduction.h"
#include "shapes.h"
#include "spatial.h"
#include "tricover_fcl/tricover_fcl.h"

namespace tricover::laws {
namespace {

using namespace support;

using Vec3 = fcl::Vector3<double>;

struct Body {
  const char* name;
  std::shared_ptr<fcl::ShapeBase<double>> geometry;
  double radius, half_length;
  Vec3 radii;  ///< an ellipsoid's

  /// Its support point along a direction of its own frame.
  Vec3 supportVertex(const Vec3& d) const {
    const double across = std::hypot(d.x(), d.y());
    const Vec3 rim = across > 0 ? Vec3(radius * d.x() / across, radius * d.y() / across, 0) : Vec3(Vec3::Zero());
    const Vec3 top(0, 0, half_length), end = d.z() < 0 ? Vec3(-top) : top;
    switch (name[1]) {
      case 'a':  // capsule
        return end + radius * d.normalized();
      case 'y':  // cylinder
        return end + rim;
      case 'o':  // cone
        return d.dot(top) > d.dot(rim - top) ? top : Vec3(rim - top);
      case 'l':  // ellipsoid
        return radii.cwiseAbs2().cwiseProduct(d) / radii.cwiseProduct(d).norm();
      default:  // sphere
        return radius * d.normalized();
    }
  }
};

Body anyBody(Random& random, int kind, double size) {
  const double radius = size * random.real(0.1, 1), length = size * random.real(0.1, 2);
  const Vec3 radii = size * Vec3(random.real(0.1, 1), random.real(0.1, 1), random.real(0.1, 1));
  switch (kind) {
    case 0:
      return {"sphere", std::make_shared<fcl::Sphered>(radius), radius, 0, radii};
    case 1:
      return {"capsule", std::make_shared<fcl::Capsuled>(radius, length), radius, length / 2, radii};
    case 2:
      return {"cylinder", std::make_shared<fcl::Cylinderd>(radius, length), radius, length / 2, radii};
    case 3:
      return {"cone", std::make_shared<fcl::Coned>(radius, length), radius, length / 2, radii};
    default:
      return {"ellipsoid", std::make_shared<fcl::Ellipsoidd>(radii), radius, 0, radii};
  }
}

/// Outlines within and around what a body's shadow on the plane is: of its points and of its tangents in many
/// directions.
struct Outlines {
  Ring within, around;
};

Outlines outlinesOf(const Body& body, const fcl::Transform3d& pose) {
  constexpr int kDirections = 96;
  const auto normal = [](int i) { return direction(6.283185307179586 * i / kDirections); };
  Outlines outlines;
  for (int i = 0; i < kDirections; ++i) {
    const Vec2 n = normal(i);
    const Vec3 p = pose * body.supportVertex(pose.linear().transpose() * Vec3(n.x(), n.y(), 0));
    outlines.within.emplace_back(p.x(), p.y());
  }
  for (int i = 0; i < kDirections; ++i) {
    // Where the tangents at two neighbours meet.
    const Vec2 n = normal(i), m = normal(i + 1), &p = outlines.within[static_cast<std::size_t>(i)],
               &q = outlines.within[static_cast<std::size_t>((i + 1) % kDirections)];
    const double along = n.dot(p), beside = m.dot(q), sine = n.x() * m.y() - n.y() * m.x();
    outlines.around.emplace_back((along * m.y() - beside * n.y()) / sine, (beside * n.x() - along * m.x()) / sine);
  }
  return outlines;
}

/// Whether they overlap wherever b is moved to by so much, as its vertices' rounding may.
bool overlapsBy(double length, const Case& c) {
  for (const Vec2& way : {Vec2(length, 0), Vec2(-length, 0), Vec2(0, length), Vec2(0, -length)}) {
    Case moved = c;
    moved.pose_b.translation() += way;
    if (!Reference(moved).collide()) return false;
  }
  return true;
}

std::string told(const Body& body, const fcl::Transform3d& pose, const Case& within) {
  std::string text = std::string("\n// ") + body.name + ", radius " + hex(body.radius) + ", half its length " +
                     hex(body.half_length) + ", radii " + hex(body.radii.x()) + " " + hex(body.radii.y()) + " " +
                     hex(body.radii.z()) + ", pose";
  for (int i = 0; i < 12; ++i) text += " " + hex(pose.matrix()(i / 4, i % 4));
  return text + "\n// b is an outline within its shadow\n" + reproduction(within);
}

std::string wrongOf(int kind, Random& random, Tally& tally) {
  Limits limits;
  limits.most_exponent = 5;
  const Case c = anyCase(random, limits);
  const Body body = anyBody(random, kind, c.b.radius() > 1e-100 ? c.b.radius() : 1);  // a point's is denormal
  fcl::Transform3d pose = lifted<double>(c.pose_b);
  const Vec3 axis(random.real(-1, 1), random.real(-1, 1), random.real(0.1, 1));
  pose.linear() = Eigen::AngleAxisd(random.oneIn(4) ? 0 : random.real(-3, 3), axis.normalized()).toRotationMatrix();
  const Outlines outlines = outlinesOf(body, pose);
  const Case within{c.a, c.pose_a, Polygon({outlines.within}), Pose::Identity()};
  const Case around{c.a, c.pose_a, Polygon({outlines.around}), Pose::Identity()};
  const auto nearest = static_cast<double>(Reference(around).distance().low),
             farthest = static_cast<double>(Reference(within).distance().high);

  // Lengths are those of the polygon's frame, which its pose may stretch.
  const double stretch = (c.pose_a.linear().transpose() * c.pose_a.linear() - Eigen::Matrix2d::Identity()).norm();
  const double size = body.radius + body.half_length + body.radii.norm();
  const double rounding = (body.name[0] == 's' ? 0 : 1e-9) * size + stretch * farthest +
                          1e-13 * (size + farthest + c.a.radius() + c.pose_a.translation().lpNorm<1>() +
                                   c.pose_b.translation().lpNorm<1>());
  // Cylinders, cones and ellipsoids are polygons around them: they collide too early, and never too late.
  const bool is_outlined = body.name[0] == 'e' || (body.name[0] == 'c' && body.name[1] != 'a');
  const double early = rounding + (is_outlined ? 1e-4 * size : 0);
  tricover_fcl::PolygonShaped shape(c.a, tricover_fcl::PolygonOptions::atAllHeights());
  fcl::CollisionResultd hit;
  const bool found = fcl::collide<double>(&shape, lifted<double>(c.pose_a), body.geometry.get(), pose,
                                          fcl::CollisionRequestd(), hit) > 0;
  fcl::DistanceResultd apart;
  fcl::distance<double>(&shape, lifted<double>(c.pose_a), body.geometry.get(), pose, fcl::DistanceRequestd(), apart);

  tally.count("hits", found);
  std::string problem;
  if (found && nearest > early) problem = "collide, though it is apart";
  if (!found && farthest == 0 && overlapsBy(2 * rounding, within)) problem = "no collision, though they overlap";
  if (!found && (apart.min_distance < nearest - early || apart.min_distance > farthest + rounding))
    problem = "distance " + hex(apart.min_distance) + ", which is from " + hex(nearest) + " to " + hex(farthest);

  return problem.empty() ? problem : problem + told(body, pose, within);
}

Laws roundLaws() {
  tricover_fcl::registerNarrowphase();
  constexpr const char* kNames[] = {"spheres", "capsules", "cylinders", "cones", "ellipsoids"};
  Laws laws;
  for (int kind = 0; kind < 5; ++kind)
    laws.push_back({kNames[kind], 400, [kind](Random& random, Tally& tally) { return wrongOf(kind, random, tally); }});
  return laws;
}

const Register registered("round", roundLaws);

}  // namespace
}  // namespace tricover::laws
