// SPDX-License-Identifier: BSD-3-Clause
#include "value_problems.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

#include "exact_penetration.h"
#include "exact_reference.h"
#include "poses.h"
#include "random.h"
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

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string exponential(int decade) { return "1e-" + std::to_string(decade); }

/// `answer(i)` is the value of the query with that number.
template <class Answer>
ValueMethod asking(const std::string& family, const std::string& setting, double promise, std::size_t positions,
                   Answer answer) {
  return {family,
          setting,
          {family + setting, Role::Rival, false,
           [=](const Sampling& sampling, Values& values) {
             forEachSample(sampling, positions, [&](std::size_t i) { values.push_back(answer(i)); });
           }},
          promise};
}

template <class Rival, class Prepared>
ValueMethod rival(const std::string& family, const std::string& setting, std::shared_ptr<Rival> method,
                  const Prepared& prepared) {
  method->prepare(prepared);
  return {family, setting, valueContender(family + setting, Role::Rival, false, std::move(method), prepared.size())};
}

bool isConvexPair(const Scene& scene) { return isConvex(scene.fixed) && isConvex(scene.moving); }
bool isForBox2d(const Scene& scene) { return box2dTakes(scene.fixed) && box2dTakes(scene.moving); }

ValueProblem distanceProblem(const Scene& scene, std::string group, const std::vector<Pose>& poses, Values truth) {
  ValueProblem problem{"distance", std::move(group), &scene, poses.size(), std::move(truth), {}, {}};
  problem.is_wrong = [](double value, double truth_, double size) { return value == 0 && truth_ > 1e-13 * size; };
  const auto add = [&](const std::string& name, double promise, const DistanceOptions& options) {
    problem.methods.push_back(asking("tricover", name, promise, poses.size(), [=, &scene](std::size_t i) {
      return distance(scene.fixed, scene.fixed_pose, scene.moving, poses[i], options).distance;
    }));
  };
  for (const int decade : {1, 2, 3, 4, 6, 9}) {
    DistanceOptions options;
    options.relative_error = std::pow(10, -decade);
    add("relative_error " + exponential(decade), options.relative_error, options);
  }
  add("exact", 1e-12, {});
  if (isConvexPair(scene)) {
    for (const int decade : {2, 4, 6, 8, 10}) {
      const double tolerance = std::pow(10, -decade);
      problem.methods.push_back(
          rival("FCL GJK (libccd)", exponential(decade), std::make_shared<LibccdGjk>(scene, tolerance), poses));
      problem.methods.push_back(
          rival("FCL GJK (indep)", exponential(decade), std::make_shared<IndepDistance>(scene, tolerance), poses));
    }
  }
  problem.methods.push_back(
      rival("FCL BVH (RSS)", "", std::make_shared<FclRssDistance>(scene.fixed, scene.moving), poses));
  problem.methods.push_back(rival("GEOS", "", std::make_shared<GeosDistance>(scene.fixed, scene.moving, true), poses));
  problem.methods.push_back(
      rival("Boost.Geometry", "", std::make_shared<BoostGeometry>(scene.fixed, scene.moving), poses));
  if (isForBox2d(scene))
    problem.methods.push_back(
        rival("Box2D (float)", "", std::make_shared<Box2dDistance>(scene.fixed, scene.moving, false), poses));
  return problem;
}

/// Around contact: what the placements know. Far away: from exact arithmetic.
std::vector<ValueProblem> distanceProblems(const Scene& scene, bool full) {
  std::vector<Pose> near, far = separatedPoses(scene.fixed, scene.moving, 2, 4);
  Values near_truth, far_truth;
  for (const Placement& placement : scene.placements) {
    if (placement.collides || placement.gap < 1e-13 * scene.size) continue;
    near.push_back(placement.pose);
    near_truth.push_back(placement.gap);
  }
  far.resize(std::min<std::size_t>(far.size(), full ? 200 : 50));
  for (const Pose& pose : far)
    far_truth.push_back(
        exact::distanceBelow(exact::distanceSquared(scene.fixed, scene.fixed_pose, scene.moving, pose)));
  return {distanceProblem(scene, scene.name + ", gaps of 1e-13 to 1e-1 of the size", near, near_truth),
          distanceProblem(scene, scene.name + ", far apart", far, far_truth)};
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
    return kNever;
  }

 private:
  const Scene& scene_;
  std::vector<Motion> motions_;
  int samples_;
};

std::vector<Motion> motionsOf(const Scene& scene, bool turning, std::size_t count) {
  support::Random random(turning ? 6 : 5);
  std::vector<Motion> motions;
  for (const Pose& start : separatedPoses(scene.fixed, scene.moving, 1.03, 1.5)) {
    if (motions.size() == count) break;
    Motion motion;
    motion.start = start;
    const Vec2 inwards = (scene.fixed.origin() - start * scene.moving.origin()).normalized();
    motion.shift = scene.size / 2 * random.real(0.5, 2) * (Eigen::Rotation2Dd(random.real(-1.2, 1.2)) * inwards);
    motion.pivot = scene.moving.origin();
    if (turning) motion.angle = random.real(-2.6, 2.6);
    motions.push_back(motion);
  }
  return motions;
}

/// The first contact to 1e-12, by the finest of our own settings; exact collisions confirm it: none at many times
/// before, and one right after (or none at all).
double confirmedImpact(const Scene& scene, const Motion& motion) {
  constexpr int kSamples = 64;
  constexpr double kAfter = 1e-9;
  ImpactOptions options;
  options.time_error = 1e-13;
  const auto impact = timeOfImpact(scene.fixed, Motion::still(scene.fixed_pose), scene.moving, motion, options);
  const auto collides = [&](double time) {
    return exact::collide(scene.fixed, scene.fixed_pose, scene.moving, motion.at(time));
  };
  const double end = impact ? impact->time : 1;
  for (int k = 0; k < kSamples; ++k)
    if (collides(std::max(end * k / kSamples - kAfter, 0.0)))
      throw std::logic_error("tradeoff: an impact is late: " + scene.name);
  // A graze may be over by then: contact is asked for at several times after.
  bool confirmed = !impact;
  for (double after = 1e-13; after < 1e-6 && !confirmed; after *= 10)
    confirmed = collides(std::min(impact->time + after, 1.0));
  return !impact ? kNever : confirmed ? impact->time : std::numeric_limits<double>::quiet_NaN();
}

ValueProblem impactProblem(const Scene& scene, bool turning, bool full) {
  std::vector<Motion> motions;
  Values truth;
  for (const Motion& motion : motionsOf(scene, turning, full ? 200 : 60)) {
    const double time = confirmedImpact(scene, motion);
    if (std::isnan(time)) continue;  // a graze
    motions.push_back(motion);
    truth.push_back(time);
  }
  ValueProblem problem{
      "time of impact", scene.name + (turning ? ", turning" : ", sliding"), &scene, motions.size(), truth, {}, {}};
  problem.is_wrong = [](double value, double truth_, double) { return value > truth_ + 1e-9; };
  const Motion still = Motion::still(scene.fixed_pose);
  for (const int decade : {1, 2, 3, 4, 6, 9, 12}) {
    ImpactOptions options;
    options.time_error = std::pow(10, -decade);
    problem.methods.push_back(asking("tricover", "time_error " + exponential(decade), options.time_error,
                                     motions.size(), [=, &scene](std::size_t i) {
                                       const auto impact =
                                           timeOfImpact(scene.fixed, still, scene.moving, motions[i], options);
                                       return impact ? impact->time : kNever;
                                     }));
  }
  for (const int samples : {10, 100, 1000, 10000})
    if (full || samples <= 1000)
      problem.methods.push_back(asking("collide() at samples", std::to_string(samples), kInfinity, motions.size(),
                                       Sampled(scene, motions, samples)));
  const std::vector<Triangle> fixed = triangulate(scene.fixed), moving = triangulate(scene.moving);
  problem.methods.push_back(rival(
      "FCL advancement (RSS)", "",
      std::make_shared<FclAdvancement>(makeFlatMesh<fcl::RSSd>(fixed), makeFlatMesh<fcl::RSSd>(moving)), motions));
  if (isForBox2d(scene))
    problem.methods.push_back(
        rival("Box2D (float)", "", std::make_shared<Box2dImpact>(scene.fixed, scene.moving), motions));
  return problem;
}

/// FCL's depth of two convex prisms, so high that they part sideways: by EPA or MPR.
template <class Solver>
class FclDepth : public ConvexPair {
 public:
  explicit FclDepth(const Scene& scene) : ConvexPair(scene, 4) {}
  double value(std::size_t i) {
    std::vector<fcl::ContactPointd> contacts;
    if (!solver_.shapeIntersect(*fixed_, fixed_transform_, *moving_, transforms_[i], &contacts)) return 0;
    double deepest = 0;
    for (const fcl::ContactPointd& contact : contacts) deepest = std::max(deepest, std::abs(contact.penetration_depth));
    return deepest;
  }

 private:
  Solver solver_;
};

ValueProblem penetrationProblem(const Scene& scene, bool full) {
  std::vector<Pose> poses;
  Values truth;
  const bool convex = isConvexPair(scene);
  for (const Pose& pose : posesOf("overlap", scene.fixed, scene.moving)) {
    if (poses.size() == (full ? 100u : 30u)) break;
    const auto best = penetration(scene.fixed, scene.fixed_pose, scene.moving, pose);
    if (!best || !best->optimal) continue;
    poses.push_back(pose);
    truth.push_back(
        convex ? std::sqrt(exact::convexPenetrationSquared(scene.fixed, scene.fixed_pose, scene.moving, pose).get_d())
               : best->depth);
  }
  ValueProblem problem{"penetration", scene.name, &scene, poses.size(), truth, {}, {}};
  problem.is_wrong = [](double value, double truth_, double size) { return value < truth_ - 1e-9 * size; };
  for (const std::size_t budget : {0, 10, 100, 1000, 20000}) {
    if (convex && budget != 20000) continue;
    const bool best = budget == 20000;
    problem.methods.push_back(asking("tricover", "budget " + std::to_string(budget), best ? 1e-11 : kInfinity,
                                     poses.size(), [=, &scene](std::size_t i) {
                                       PenetrationOptions options;
                                       options.budget = budget;
                                       const auto found =
                                           penetration(scene.fixed, scene.fixed_pose, scene.moving, poses[i], options);
                                       return found ? found->depth : 0;
                                     }));
  }
  problem.methods.push_back(asking("deepest of contacts()", "", kInfinity, poses.size(), [=, &scene](std::size_t i) {
    const auto all = contacts(scene.fixed, scene.fixed_pose, scene.moving, poses[i], 1);
    return all.empty() ? 0 : all.front().depth;
  }));
  if (convex) {
    problem.methods.push_back(
        rival("FCL EPA (indep)", "", std::make_shared<FclDepth<fcl::detail::GJKSolver_indepd>>(scene), poses));
    problem.methods.push_back(
        rival("FCL MPR (libccd)", "", std::make_shared<FclDepth<fcl::detail::GJKSolver_libccdd>>(scene), poses));
  }
  return problem;
}

}  // namespace

std::vector<ValueProblem> valueProblems(const std::vector<Scene>& scenes, bool full) {
  std::vector<ValueProblem> problems;
  for (const Scene& scene : scenes)
    for (ValueProblem& problem : distanceProblems(scene, full)) problems.push_back(std::move(problem));
  for (const Scene& scene : scenes)
    for (const bool turning : {false, true}) problems.push_back(impactProblem(scene, turning, full));
  for (const Scene& scene : scenes) problems.push_back(penetrationProblem(scene, full));
  return problems;
}

}  // namespace tricover::bench
