// SPDX-License-Identifier: BSD-3-Clause
#include "value_methods.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "rivals/boost_geometry.h"
#include "rivals/box2d.h"
#include "rivals/convex_pieces.h"
#include "rivals/fcl_advancement.h"
#include "rivals/fcl_distance.h"
#include "rivals/geos.h"
#include "tradeoff_fcl.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"
#include "tricover/time_of_impact.h"

namespace tricover::bench {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();

std::string exponential(int decade) { return "1e-" + std::to_string(decade); }

/// `make()` gives a shared pointer to what answers, once it is prepared for the queries.
template <class Query, class Make>
ValueMethod rival(const std::string& family, const std::string& setting, const std::vector<Query>& queries, Make make) {
  return {family, setting, kNothing, [=]() -> Asker {
            const auto method = make();
            method->prepare(queries);
            return [method](std::size_t i) { return method->value(i); };
          }};
}

/// What needs no preparation.
ValueMethod plain(const std::string& family, const std::string& setting, double promise, Asker answer) {
  return {family, setting, promise, [=] { return answer; }};
}

bool isSmall(const Scene& scene) {
  return std::max(scene.fixed.vertexCount(), scene.moving.vertexCount()) <= b2_maxPolygonVertices;
}

/// Collisions asked at so many equal steps, which is what FCL calls naive.
class Sampled {
 public:
  Sampled(const Scene& scene, const std::vector<Motion>& motions, int samples)
      : scene_(scene), motions_(motions), samples_(samples) {}
  double operator()(std::size_t i) const {
    for (int k = 0; k <= samples_; ++k) {
      const double time = static_cast<double>(k) / samples_;
      if (collide(scene_.fixed, scene_.fixed_pose, scene_.moving, motions_[i].at(time))) return time;
    }
    return kNoContact;
  }

 private:
  const Scene& scene_;
  std::vector<Motion> motions_;
  int samples_;
};

/// FCL's depth of two convex prisms, so high that they part sideways: by EPA or MPR.
template <class Solver>
class FclDepth : public ConvexPair {
 public:
  FclDepth(const Scene& scene, double none) : ConvexPair(scene, 4), none_(none) {}
  double value(std::size_t i) {
    std::vector<fcl::ContactPointd> contacts;
    if (!solver_.shapeIntersect(*fixed_, fixed_transform_, *moving_, transforms_[i], &contacts)) return none_;
    double deepest = 0;
    for (const fcl::ContactPointd& contact : contacts) deepest = std::max(deepest, std::abs(contact.penetration_depth));
    return deepest;
  }

 private:
  double none_;
  Solver solver_;
};

/// `none`: where they are said not to meet.
void addFclDepths(std::vector<ValueMethod>& to, const Scene& scene, const std::vector<Pose>& poses, double none) {
  to.push_back(rival("FCL EPA (indep)", "", poses,
                     [=, &scene] { return std::make_shared<FclDepth<fcl::detail::GJKSolver_indepd>>(scene, none); }));
  to.push_back(rival("FCL MPR (libccd)", "", poses,
                     [=, &scene] { return std::make_shared<FclDepth<fcl::detail::GJKSolver_libccdd>>(scene, none); }));
}

/// The deepest contact's depth.
Asker deepestContact(const Scene& scene, const std::vector<Pose>& poses, double none) {
  return [=, &scene](std::size_t i) {
    const auto all = contacts(scene.fixed, scene.fixed_pose, scene.moving, poses[i], {0, 1});
    return all.empty() ? none : all.front().depth;
  };
}

}  // namespace

bool isConvexPair(const Scene& scene) { return isConvex(scene.fixed) && isConvex(scene.moving); }

std::vector<ValueMethod> distanceMethods(const Scene& scene, const std::vector<Pose>& poses, bool convex) {
  std::vector<ValueMethod> methods;
  const auto add = [&](const std::string& name, double promise, const DistanceOptions& options) {
    methods.push_back(plain("tricover", name, promise, [=, &scene](std::size_t i) {
      return distance(scene.fixed, scene.fixed_pose, scene.moving, poses[i], options).distance;
    }));
  };
  for (const int decade : {1, 2, 3, 4, 6, 9}) {
    DistanceOptions options;
    options.relative_error = std::pow(10, -decade);
    add("relative_error " + exponential(decade), options.relative_error, options);
  }
  add("exact", 1e-12, {});
  if (convex) {
    for (const int decade : {2, 4, 6, 8, 10}) {
      // In proportion: polygons are about 100 units long, and at the extremes of scale any other length.
      const double tolerance = std::pow(10, -decade) * (scene.size / 128);
      methods.push_back(rival("FCL GJK (libccd)", exponential(decade), poses,
                              [=, &scene] { return std::make_shared<LibccdGjk>(scene, tolerance); }));
      methods.push_back(rival("FCL GJK (indep)", exponential(decade), poses,
                              [=, &scene] { return std::make_shared<IndepDistance>(scene, tolerance); }));
    }
  }
  methods.push_back(rival("FCL BVH (RSS)", "", poses, [&scene] {
    return std::make_shared<FclRssDistance>(scene.fixed, scene.moving, scene.fixed_pose);
  }));
  methods.push_back(rival("GEOS", "", poses,
                          [&scene] { return std::make_shared<GeosDistance>(inWorld(scene), scene.moving, true); }));
  methods.push_back(rival("Boost.Geometry", "", poses,
                          [&scene] { return std::make_shared<BoostGeometry>(inWorld(scene), scene.moving); }));
  if (convex && isSmall(scene))
    methods.push_back(rival("Box2D (float)", "", poses, [&scene] {
      return std::make_shared<Box2dDistance>(scene.fixed, scene.moving, false, scene.fixed_pose);
    }));
  return methods;
}

std::vector<ValueMethod> impactMethods(const Scene& scene, const std::vector<Motion>& motions, bool convex,
                                       int most_samples) {
  std::vector<ValueMethod> methods;
  const Motion still = Motion::still(scene.fixed_pose);
  for (const int decade : {1, 2, 3, 4, 6, 9, 12}) {
    ImpactOptions options;
    options.time_error = std::pow(10, -decade);
    methods.push_back(
        plain("tricover", "time_error " + exponential(decade), options.time_error, [=, &scene](std::size_t i) {
          const auto impact = timeOfImpact(scene.fixed, still, scene.moving, motions[i], options);
          return impact ? impact->time : kNoContact;
        }));
  }
  for (int samples = 10; samples <= most_samples; samples *= 10)
    methods.push_back(
        plain("collide() at samples", std::to_string(samples), kNothing, Sampled(scene, motions, samples)));
  methods.push_back(rival("FCL advancement (RSS)", "", motions, [&scene] {
    return std::make_shared<FclAdvancement>(makeFlatMesh<fcl::RSSd>(triangulate(scene.fixed)),
                                            makeFlatMesh<fcl::RSSd>(triangulate(scene.moving)),
                                            toTransform(scene.fixed_pose));
  }));
  if (convex && isSmall(scene))
    methods.push_back(rival("Box2D (float)", "", motions, [&scene] {
      return std::make_shared<Box2dImpact>(scene.fixed, scene.moving, scene.fixed_pose);
    }));
  return methods;
}

std::vector<ValueMethod> penetrationMethods(const Scene& scene, const std::vector<Pose>& poses, bool convex) {
  std::vector<ValueMethod> methods;
  methods.push_back(plain("tricover", "", 1e-11, [=, &scene](std::size_t i) {
    const auto found = penetration(scene.fixed, scene.fixed_pose, scene.moving, poses[i]);
    return found ? found->depth : 0;
  }));
  methods.push_back(plain("deepest of contacts()", "", kNothing, deepestContact(scene, poses, 0)));
  if (convex) addFclDepths(methods, scene, poses, 0);
  return methods;
}

std::vector<ValueMethod> contactMethods(const Scene& scene, const std::vector<Pose>& poses, bool convex) {
  std::vector<ValueMethod> methods = {plain("tricover", "", kNothing, deepestContact(scene, poses, kNoContact))};
  if (convex) addFclDepths(methods, scene, poses, kNoContact);
  if (convex && isSmall(scene))
    methods.push_back(rival("Box2D manifold (float)", "", poses, [&scene] {
      return std::make_shared<Box2dManifold>(scene.fixed, scene.moving, scene.fixed_pose);
    }));
  return methods;
}

}  // namespace tricover::bench
