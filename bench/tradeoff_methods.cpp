// SPDX-License-Identifier: BSD-3-Clause
#include "tradeoff_methods.h"

#include <box2d/b2_settings.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "plain_core.h"
#include "rivals/boost_geometry.h"
#include "rivals/box2d.h"
#include "rivals/fcl_bvh.h"
#include "rivals/geos.h"
#include "tradeoff_fcl.h"
#include "tricover/collide.h"
#include "tricover/locate.h"
#include "tricover/paper.h"

namespace tricover::bench {
namespace {

/// What all of ours know of a scene.
class OnScene {
 public:
  explicit OnScene(const Scene& scene) : scene_(scene) {}
  void prepare(const std::vector<Pose>& poses) { poses_ = poses; }

 protected:
  const Scene& scene_;
  std::vector<Pose> poses_;
};

class Core : public OnScene {
 public:
  Core(const Scene& scene, double tolerance) : OnScene(scene) { options_.tolerance = tolerance * scene.size; }
  bool collide(std::size_t i) {
    return tricover::collide(scene_.fixed, scene_.fixed_pose, scene_.moving, poses_[i], options_);
  }

 private:
  CollideOptions options_;
};

/// "They collide if the bounding discs do."
class Discs : public OnScene {
 public:
  explicit Discs(const Scene& scene)
      : OnScene(scene),
        center_(scene.fixed_pose * scene.fixed.origin()),
        reach_(scene.fixed.radius() + scene.moving.radius()) {}
  bool collide(std::size_t i) {
    return (poses_[i] * scene_.moving.origin() - center_).squaredNorm() <= reach_ * reach_;
  }

 private:
  Vec2 center_;
  double reach_;
};

/// Algorithm 3 without its detailed test: "they collide if the moving centroid is in the fixed polygon or in one of its
/// influence areas, as long as the moving radius".
class InfluenceAreas : public OnScene {
 public:
  explicit InfluenceAreas(const Scene& scene) : OnScene(scene), inverse_(scene.fixed_pose.inverse(Eigen::Isometry)) {}
  bool collide(std::size_t i) {
    const Vec2 centroid = inverse_ * (poses_[i] * scene_.moving.origin());
    const auto mask = paper::influenceMask(scene_.fixed, centroid, scene_.moving.radius());
    return std::any_of(mask.begin(), mask.end(), [](std::uint64_t word) { return word != 0; }) ||
           locate(scene_.fixed, centroid) != Location::Outside;
  }

 private:
  Pose inverse_;
};

bool anything(const Scene&) { return true; }

bool convex(const Polygon& polygon) {
  const auto& rings = polygon.rings();
  if (rings.size() > 1) return false;
  const std::size_t n = rings[0].size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &p = rings[0][i], &q = rings[0][(i + 1) % n], &r = rings[0][(i + 2) % n];
    if ((q - p).x() * (r - q).y() - (q - p).y() * (r - q).x() <= 0) return false;
  }
  return true;
}

bool convexPair(const Scene& scene) { return convex(scene.fixed) && convex(scene.moving); }

bool smallConvexPair(const Scene& scene) {
  return convexPair(scene) && std::max(scene.fixed.vertexCount(), scene.moving.vertexCount()) <= b2_maxPolygonVertices;
}

std::vector<Pose> posesOf(const Scene& scene) {
  std::vector<Pose> poses;
  for (const Placement& placement : scene.placements) poses.push_back(placement.pose);
  return poses;
}

std::string exponential(int decade) { return "1e-" + std::to_string(decade); }

class Methods {
 public:
  /// `make(scene)` gives a shared pointer to what answers.
  template <class Make>
  void add(const std::string& family, const std::string& setting, bool (*takes)(const Scene&), Make make) {
    Method method{family, setting, takes, {}};
    method.make = [name = method.name(), make](const Scene& scene) {
      const auto answerer = make(scene);
      const std::vector<Pose> poses = posesOf(scene);
      answerer->prepare(poses);
      return contender<Hits>(name, Role::Rival, false, answerer, poses.size());
    };
    all.push_back(std::move(method));
  }

  template <class Answerer>
  void addUntuned(const std::string& family, bool (*takes)(const Scene&)) {
    add(family, "", takes, [](const Scene& scene) { return std::make_shared<Answerer>(scene); });
  }

  template <class Answerer>
  void addPosed(const std::string& family, bool (*takes)(const Scene&)) {
    add(family, "", takes,
        [](const Scene& scene) { return std::make_shared<Answerer>(scene.fixed, scene.moving, scene.fixed_pose); });
  }

  template <class Answerer>
  void addTolerances(const std::string& family, bool (*takes)(const Scene&), const std::vector<int>& decades) {
    for (const int decade : decades) {
      add(family, exponential(decade), takes,
          [=](const Scene& scene) { return std::make_shared<Answerer>(scene, std::pow(10, -decade)); });
    }
  }

  /// The kernel without filter and exact stage, which is compiled in a namespace of its own.
  void addPlainSigns(const std::string& family, decltype(&tricover_plain_double::plainWalk) plain_walk) {
    all.push_back({family, "", anything, [=](const Scene& scene) {
                     const auto walk = plain_walk(scene.fixed.rings(), scene.moving.rings(), scene.fixed_pose);
                     return Contender{family, Role::Rival, false,
                                      [=, poses = posesOf(scene)](const Sampling& sampling, Hits& hits) {
                                        walk(poses.data(), poses.size(), sampling.period, sampling.run, hits);
                                      }};
                   }});
  }

  std::vector<Method> all;
};

}  // namespace

const std::vector<Method>& tradeoffMethods() {
  static const std::vector<Method> methods = [] {
    Methods m;
    m.addUntuned<Discs>("bounding discs", anything);
    m.addUntuned<InfluenceAreas>("influence areas", anything);
    m.addTolerances<Core>(kTolerance, anything, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
    m.addPlainSigns("tricover, plain float", tricover_plain_float::plainWalk);
    m.addPlainSigns("tricover, plain double", tricover_plain_double::plainWalk);
    m.add(kExact, "", anything, [](const Scene& scene) { return std::make_shared<Core>(scene, 0.0); });
    const std::vector<int> decades = {2, 4, 6, 8, 10, 12};
    m.addTolerances<LibccdMpr>("FCL MPR (libccd)", convexPair, decades);
    m.addTolerances<LibccdGjk>("FCL GJK (libccd)", convexPair, decades);
    m.addTolerances<IndepGjk>("FCL GJK (indep)", convexPair, decades);
    m.addPosed<FclBvh>("FCL BVH", anything);
    m.add("GEOS", "", anything,
          [](const Scene& scene) { return std::make_shared<Geos>(inWorld(scene), scene.moving); });
    m.add("Boost.Geometry", "", anything,
          [](const Scene& scene) { return std::make_shared<BoostGeometry>(inWorld(scene), scene.moving); });
    m.addPosed<Box2dOverlap>("Box2D overlap", smallConvexPair);
    m.addPosed<Box2dManifold>("Box2D manifold", smallConvexPair);
    return m.all;
  }();
  return methods;
}

}  // namespace tricover::bench
