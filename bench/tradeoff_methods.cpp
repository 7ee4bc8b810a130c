// SPDX-License-Identifier: BSD-3-Clause
#include "tradeoff_methods.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "plain_core.h"
#include "rivals/boost.h"
#include "rivals/box2d.h"
#include "rivals/fcl_call.h"
#include "rivals/fcl_meshes.h"
#include "rivals/fcl_prisms.h"
#include "rivals/geos.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/locate.h"
#include "tricover/paper.h"
#include "tricover/penetration.h"
#include "tricover/time_of_impact.h"

namespace tricover::bench {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();

std::string exponential(int decade) { return "1e-" + std::to_string(decade); }

bool isSmall(const KnownScene& scene) {
  return std::max(scene.fixed.vertexCount(), scene.moving.vertexCount()) <= b2_maxPolygonVertices;
}

/// Half the prisms' height is this part of the polygons' size. Neither MPR nor GJK (libccd) minds; GJK (indep) is a
/// fifth faster on prisms a tenth as high, but misses penetrations of up to a hundredth of the size there.
Prisms prismsOf(const KnownScene& scene, double height = 0.05) { return {height * scene.size, scene.fixed_pose, true}; }

/// Methods on the same queries.
template <class Answers, class Query = Pose>
class Methods {
 public:
  explicit Methods(std::vector<Query> queries) : queries_(std::move(queries)) {}

  /// `answer(query)` needs no preparation.
  template <class Answer>
  void ours(const std::string& family, const std::string& setting, double promise, Answer answer) {
    all.push_back({family, setting, promise, [=, queries = queries_] {
                     return contender<Answers>("", Role::Rival, false, queries.size(),
                                               [=](std::size_t i) { return answer(queries[i]); });
                   }});
  }

  /// `make()` gives a shared pointer to what answers, once it is prepared for the queries.
  template <class Make>
  void made(const std::string& family, const std::string& setting, Make make) {
    all.push_back({family, setting, kNothing, [=, queries = queries_] {
                     const auto method = make();
                     method->prepare(queries);
                     return contenderOf<Answers>("", Role::Rival, false, queries.size(), method);
                   }});
  }
  template <class Method, class... Arguments>
  void rival(const std::string& family, const std::string& setting, const Arguments&... arguments) {
    made(family, setting, [=] { return std::make_shared<Method>(arguments...); });
  }

  std::vector<MethodFor<Answers>> all;

 private:
  std::vector<Query> queries_;
};

/// `none`: where they are said not to meet.
void addFclDepths(Methods<Values>& to, const KnownScene& scene, double none) {
  const Prisms high = prismsOf(scene, 4);
  to.rival<FclDepth<fcl::detail::GJKSolver_indepd>>("FCL EPA (indep)", "", scene.fixed, scene.moving, high, none);
  to.rival<FclDepth<fcl::detail::GJKSolver_libccdd>>("FCL MPR (libccd)", "", scene.fixed, scene.moving, high, none);
}

/// The deepest contact's depth.
auto deepestContact(const KnownScene& scene, double none) {
  return [=, &scene](const Pose& pose) {
    const auto all = contacts(scene.fixed, scene.fixed_pose, scene.moving, pose, {0, 1, ContactDetail::GlobalDepth});
    return all.empty() ? none : all.front().depth;
  };
}

/// Algorithm 3 without its detailed test: "they collide if the moving centroid is in the fixed polygon or in one of its
/// influence areas, as long as the moving radius".
auto influenceAreas(const KnownScene& scene) {
  return [&scene, inverse = Pose(scene.fixed_pose.inverse(Eigen::Isometry))](const Pose& pose) {
    const Vec2 centroid = inverse * (pose * scene.moving.coveringOrigin());
    const auto mask = paper::influenceMask(scene.fixed, centroid, scene.moving.radius());
    return std::any_of(mask.begin(), mask.end(), [](std::uint64_t word) { return word != 0; }) ||
           locate(scene.fixed, centroid) != Location::Outside;
  };
}

}  // namespace

bool isConvexPair(const KnownScene& scene) { return scene.fixed.isConvex() && scene.moving.isConvex(); }

std::vector<CollisionMethod> collisionMethods(const KnownScene& scene, bool convex) {
  const Polygon &fixed = scene.fixed, &moving = scene.moving;
  std::vector<Pose> poses;
  for (const KnownPose& known : scene.poses) poses.push_back(known.pose);
  Methods<Hits> methods(poses);
  const Vec2 center = scene.fixed_pose * fixed.coveringOrigin();
  const double reach = fixed.radius() + moving.radius();
  methods.ours("bounding discs", "", kNothing, [=, &moving](const Pose& pose) {
    return (pose * moving.coveringOrigin() - center).squaredNorm() <= reach * reach;
  });
  methods.ours("influence areas", "", kNothing, influenceAreas(scene));
  const auto core = [&scene](double tolerance) {
    return [&scene, options = CollideOptions{0, tolerance * scene.size}](const Pose& pose) {
      return collide(scene.fixed, scene.fixed_pose, scene.moving, pose, options);
    };
  };
  for (int decade = 1; decade <= 12; ++decade)
    methods.ours(kTolerance, exponential(decade), kNothing, core(std::pow(10, -decade)));
  // The kernel without filter and exact stage, which is compiled in a namespace of its own.
  const auto addPlainSigns = [&](const std::string& family, decltype(&tricover_plain_double::plainWalk) plain_walk) {
    methods.all.push_back({family, "", kNothing, [=, &scene] {
                             const auto walk = plain_walk(scene.fixed.rings(), scene.moving.rings(), scene.fixed_pose);
                             return Contender{"", Role::Rival, false, [=](const Sampling& sampling, Hits& hits) {
                                                walk(poses.data(), poses.size(), sampling.period, sampling.run,
                                                     sampling.first, hits);
                                              }};
                           }});
  };
  addPlainSigns("tricover, plain float", tricover_plain_float::plainWalk);
  addPlainSigns("tricover, plain double", tricover_plain_double::plainWalk);
  methods.ours(kExact, "", 0, core(0));
  const auto addTolerances = [&](auto add) {
    for (int decade = 2; decade <= 12; decade += 2) add(exponential(decade), std::pow(10, -decade));
  };
  if (convex) {
    const Prisms prisms = prismsOf(scene);
    addTolerances([&](const std::string& setting, double tolerance) {
      methods.rival<FclMpr>("FCL MPR (libccd)", setting, fixed, moving, prisms, tolerance);
    });
    addTolerances([&](const std::string& setting, double tolerance) {
      methods.rival<LibccdDistance>("FCL GJK (libccd)", setting, fixed, moving, prisms, tolerance);
    });
    addTolerances([&](const std::string& setting, double tolerance) {
      methods.rival<FclGjk>("FCL GJK (indep)", setting, fixed, moving, false, prisms, tolerance);
    });
  }
  methods.rival<FclBvh>("FCL BVH", "", fixed, moving, scene.fixed_pose);
  methods.rival<Geos>("GEOS", "", posed(fixed, scene.fixed_pose), moving);
  methods.rival<BoostGeometry>("Boost.Geometry", "", posed(fixed, scene.fixed_pose), moving);
  if (convex && isSmall(scene)) {
    methods.rival<Box2dOverlap>("Box2D overlap", "", fixed, moving, scene.fixed_pose);
    methods.rival<Box2dManifold>("Box2D manifold", "", fixed, moving, scene.fixed_pose);
  }
  return methods.all;
}

std::vector<ValueMethod> distanceMethods(const KnownScene& scene, const std::vector<Pose>& poses, bool convex) {
  Methods<Values> methods(poses);
  const auto add = [&](const std::string& name, double promise, double relative_error) {
    DistanceOptions options;
    options.relative_error = relative_error;
    methods.ours("tricover", name, promise, [=, &scene](const Pose& pose) {
      return distance(scene.fixed, scene.fixed_pose, scene.moving, pose, options).distance;
    });
  };
  for (const int decade : {1, 2, 3, 4, 6, 9})
    add("relative_error " + exponential(decade), std::pow(10, -decade), std::pow(10, -decade));
  add("exact", 1e-12, 0);
  if (convex) {
    for (const int decade : {2, 4, 6, 8, 10}) {
      // In proportion: polygons are about 100 units long, and at the extremes of scale any other length.
      const double tolerance = std::pow(10, -decade) * (scene.size / 128);
      const Prisms prisms = prismsOf(scene);
      methods.rival<LibccdDistance>("FCL GJK (libccd)", exponential(decade), scene.fixed, scene.moving, prisms,
                                    tolerance);
      methods.rival<IndepDistance>("FCL GJK (indep)", exponential(decade), scene.fixed, scene.moving, prisms,
                                   tolerance);
    }
  }
  methods.rival<FclRssDistance>("FCL BVH (RSS)", "", scene.fixed, scene.moving, scene.fixed_pose);
  methods.rival<Geos>("GEOS", "", posed(scene.fixed, scene.fixed_pose), scene.moving);
  methods.rival<BoostGeometry>("Boost.Geometry", "", posed(scene.fixed, scene.fixed_pose), scene.moving);
  if (convex && isSmall(scene))
    methods.rival<Box2dDistance>("Box2D (float)", "", scene.fixed, scene.moving, false, scene.fixed_pose);
  return methods.all;
}

std::vector<ValueMethod> impactMethods(const KnownScene& scene, const std::vector<Motion>& motions, bool convex,
                                       int most_samples) {
  Methods<Values, Motion> methods(motions);
  const Motion still = Motion::still(scene.fixed_pose);
  for (const int decade : {1, 2, 3, 4, 6, 9, 12}) {
    ImpactOptions options;
    options.time_error = std::pow(10, -decade);
    methods.ours("tricover", "time_error " + exponential(decade), options.time_error,
                 [=, &scene](const Motion& motion) {
                   const auto impact = timeOfImpact(scene.fixed, still, scene.moving, motion, options);
                   return impact ? impact->time : kNoContact;
                 });
  }
  // Collisions asked at so many equal steps, which is what FCL calls naive.
  for (int samples = 10; samples <= most_samples; samples *= 10)
    methods.ours("collide() at samples", std::to_string(samples), kNothing, [=, &scene](const Motion& motion) {
      for (int k = 0; k <= samples; ++k) {
        const double time = static_cast<double>(k) / samples;
        if (collide(scene.fixed, scene.fixed_pose, scene.moving, motion.at(time))) return time;
      }
      return kNoContact;
    });
  methods.made("FCL advancement (RSS)", "", [&scene] {
    return std::make_shared<FclAdvancement>(makeFlatMesh<fcl::RSSd>(triangulate(scene.fixed)),
                                            makeFlatMesh<fcl::RSSd>(triangulate(scene.moving)),
                                            toTransform(scene.fixed_pose));
  });
  if (convex && isSmall(scene))
    methods.rival<Box2dImpact>("Box2D (float)", "", scene.fixed, scene.moving, scene.fixed_pose);
  return methods.all;
}

std::vector<ValueMethod> penetrationMethods(const KnownScene& scene, const std::vector<Pose>& poses, bool convex) {
  Methods<Values> methods(poses);
  methods.ours("tricover", "", 1e-11, [&scene](const Pose& pose) {
    const auto found = penetration(scene.fixed, scene.fixed_pose, scene.moving, pose);
    return found ? found->depth : 0;
  });
  methods.ours("deepest of contacts()", "", kNothing, deepestContact(scene, 0));
  if (convex) addFclDepths(methods, scene, 0);
  return methods.all;
}

std::vector<ValueMethod> contactMethods(const KnownScene& scene, const std::vector<Pose>& poses, bool convex) {
  Methods<Values> methods(poses);
  methods.ours("tricover", "", kNothing, deepestContact(scene, kNoContact));
  if (convex) addFclDepths(methods, scene, kNoContact);
  if (convex && isSmall(scene))
    methods.rival<Box2dManifold>("Box2D manifold (float)", "", scene.fixed, scene.moving, scene.fixed_pose);
  return methods.all;
}

}  // namespace tricover::bench
