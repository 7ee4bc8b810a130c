// SPDX-License-Identifier: BSD-3-Clause
#include "value_problems.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "exact_penetration.h"
#include "exact_reference.h"
#include "inputs.h"
#include "tricover/penetration.h"
#include "tricover/time_of_impact.h"

namespace tricover::bench {
namespace {

double relativeError(double value, double truth) {
  if (value == truth) return 0;
  if (!std::isfinite(value) || !std::isfinite(truth) || truth == 0) return 1;
  return std::min(std::abs(value - truth) / truth, 1.0);
}

/// From contact on, and far away.
std::vector<ValueProblem> distanceProblems(const KnownScene& scene, bool full) {
  const bool convex = isConvexPair(scene);
  ValueProblem near = nearDistances(scene, convex);
  near.group = scene.name + ", gaps of 1e-13 to 1e-1 of the size";
  std::vector<Pose> poses = separatedPoses(scene.fixed, scene.moving, 2, 4);
  poses.resize(std::min<std::size_t>(poses.size(), full ? 200 : 50));
  Values truth;
  for (const Pose& pose : poses)
    truth.push_back(exact::distanceBelow(exact::distanceSquared(scene.fixed, scene.fixed_pose, scene.moving, pose)));
  return {near, {kDistance, scene.name + ", far apart", &scene, truth, distanceMethods(scene, poses, convex)}};
}

/// The first contact to 1e-12, by the finest of our own settings; exact collisions confirm it: none at many times
/// before, and one right after (or none at all).
double confirmedImpact(const KnownScene& scene, const Motion& motion) {
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
  return !impact ? kNoContact : confirmed ? impact->time : std::numeric_limits<double>::quiet_NaN();
}

ValueProblem impactProblem(const KnownScene& scene, bool turning, bool full) {
  std::vector<Motion> motions;
  Values truth;
  std::vector<Motion> all =
      randomMotions(scene.fixed, scene.moving, scene.size / 2, turning ? 2.6 : 0, turning ? 6 : 5);
  all.resize(std::min<std::size_t>(all.size(), full ? 200 : 60));
  for (const Motion& motion : all) {
    const double time = confirmedImpact(scene, motion);
    if (std::isnan(time)) continue;  // a graze
    motions.push_back(motion);
    truth.push_back(time);
  }
  return {kImpact, scene.name + (turning ? ", turning" : ", sliding"), &scene, truth,
          impactMethods(scene, motions, isConvexPair(scene), full ? 10000 : 1000)};
}

ValueProblem penetrationProblem(const KnownScene& scene, bool full) {
  std::vector<Pose> poses;
  Values truth;
  const bool convex = isConvexPair(scene);
  for (const Pose& pose : posesOf("overlap", scene.fixed, scene.moving)) {
    if (poses.size() == (full ? 100u : 30u)) break;
    const auto best = penetration(scene.fixed, scene.fixed_pose, scene.moving, pose);
    if (!best || !best->optimal) continue;
    poses.push_back(pose);
    truth.push_back(convex ? exactDepth(scene, pose) : best->depth);
  }
  return {kPenetration, scene.name, &scene, truth, penetrationMethods(scene, poses, convex)};
}

}  // namespace

const ValueQuery kDistance = {"distance", ValueQuery::Error::OfTruth, [](double value, double truth, double size) {
                                return (value == 0 || !std::isfinite(value)) && truth > 1e-13 * size;
                              }};
const ValueQuery kImpact = {"time of impact", ValueQuery::Error::OfTime,
                            [](double value, double truth, double) { return value > truth + 1e-9; }};
const ValueQuery kPenetration = {"penetration", ValueQuery::Error::OfTruth,
                                 [](double value, double truth, double size) { return value < truth - 1e-9 * size; }};
const ValueQuery kContacts = {"contacts", ValueQuery::Error::OfSize, [](double value, double truth, double size) {
                                return value == kNoContact || value < truth - 1e-9 * size;
                              }};

ValueError errorOf(const ValueProblem& problem, const ValueMethod& method, std::size_t query, double value) {
  const double truth = problem.truth[query], relative = relativeError(value, truth), size = problem.scene->size;
  const bool both = std::isfinite(value) && std::isfinite(truth),
             of_time = problem.query.error == ValueQuery::Error::OfTime;
  const double off = both ? std::abs(value - truth) / (of_time ? 1 : size) : relative;
  // Next to the rounding of coordinates nothing is promised.
  const bool near = (of_time ? off : std::min(relative, off * 1e13)) <= method.promise * (1 + 1e-9) + 1e-12;
  return {relative, off, problem.query.error == ValueQuery::Error::OfTruth ? relative : off,
          std::isnan(value) || problem.query.is_wrong(value, truth, size),
          near || (problem.may_round && problem.may_round(query, value))};
}

ValueProblem nearDistances(const KnownScene& scene, bool convex) {
  std::vector<Pose> poses;
  Values truth;
  for (const KnownPose& known : scene.poses) {
    if (known.collides || known.gap < 1e-13 * scene.size) continue;
    poses.push_back(known.pose);
    truth.push_back(known.gap);
  }
  return {kDistance, scene.name, &scene, truth, distanceMethods(scene, poses, convex)};
}

ValueProblem shallowContacts(const KnownScene& scene) {
  std::vector<Pose> poses;
  Values truth;
  for (const KnownPose& known : scene.poses) {
    if (!known.collides || known.gap > -0.9e-13 * scene.size) continue;
    poses.push_back(known.pose);
    truth.push_back(exactDepth(scene, known.pose));
  }
  return {kContacts, scene.name, &scene, truth, contactMethods(scene, poses, true)};
}

double exactDepth(const KnownScene& scene, const Pose& pose) {
  return exact::distanceBelow(exact::convexPenetrationSquared(scene.fixed, scene.fixed_pose, scene.moving, pose));
}

std::vector<ValueProblem> valueProblems(const std::vector<KnownScene>& scenes, bool full) {
  std::vector<ValueProblem> problems;
  for (const KnownScene& scene : scenes)
    for (ValueProblem& problem : distanceProblems(scene, full)) problems.push_back(std::move(problem));
  for (const KnownScene& scene : scenes)
    for (const bool turning : {false, true}) problems.push_back(impactProblem(scene, turning, full));
  for (const KnownScene& scene : scenes)
    if (isConvexPair(scene)) problems.push_back(shallowContacts(scene));
  for (const KnownScene& scene : scenes) problems.push_back(penetrationProblem(scene, full));
  return problems;
}

}  // namespace tricover::bench
