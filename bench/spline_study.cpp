// SPDX-License-Identifier: BSD-3-Clause
#include <fcl/geometry/shape/sphere.h>
#include <fcl/math/motion/spline_motion.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/continuous_collision_object.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "prism.h"
#include "random.h"
#include "rivals/fcl_pair.h"
#include "studies.h"
#include "tricover/segment.h"
#include "tricover_fcl/tricover_fcl.h"

namespace tricover::bench {
namespace {

constexpr std::size_t kMotions = 1000;
constexpr std::size_t kSamples = 15;

/// Between two samples of CCDC_NAIVE, so that a contact which the next sample finds isn't counted as missed.
constexpr double kSampleStep = 1.0 / (kSamples - 1);
constexpr Agreement kAgreement = {1, {2 * kShapeTimeError, 2 * kShapeTimeError}, {1e-2, kSampleStep + 1e-9}};

/// Of a uniform cubic B-spline's four control points, from Hermite's ends p, q and velocities v, w.
template <class T>
T secondPoint(const T& p, const T& q, const T& v, const T& w) {
  return 2 * p - q + (2 * v + w) / 3;
}
template <class T>
T thirdPoint(const T& p, const T& q, const T& v, const T& w) {
  return 2 * q - p - (v + 2 * w) / 3;
}

/// Metres: two robots of about 1 m cross a field of 10 m in one unit of time, like rmf_traffic's cubic Hermite
/// segments.
fcl::SplineMotion<double> randomSpline(support::Random& random) {
  const auto shift = [&](double most) { return fcl::Vector3d(random.real(-most, most), random.real(-most, most), 0); };
  const fcl::Vector3d begin = shift(5), end = shift(5), v = shift(12), w = shift(12);
  const double turn_begin = random.real(-3.15, 3.15), turn_end = turn_begin + random.real(-3.15, 3.15);
  const double turn_v = random.real(-6, 6), turn_w = random.real(-6, 6);
  const fcl::Vector3d p1 = secondPoint(begin, end, v, w), p2 = thirdPoint(begin, end, v, w);
  const double t1 = secondPoint(turn_begin, turn_end, turn_v, turn_w),
               t2 = thirdPoint(turn_begin, turn_end, turn_v, turn_w);
  const auto about = [](double turn) { return fcl::Vector3d(0, 0, turn); };
  return {p2 - 2 * v, p1, p2, p1 + 2 * w, about(t2 - 2 * turn_v), about(t1), about(t2), about(t1 + 2 * turn_w)};
}

using Splines = std::vector<std::shared_ptr<fcl::MotionBased>>;

Splines randomSplines(std::uint64_t seed) {
  support::Random random(seed);
  Splines splines;
  for (std::size_t i = 0; i < kMotions; ++i) {
    splines.push_back(std::make_shared<fcl::SplineMotion<double>>(randomSpline(random)));
  }
  return splines;
}

/// As rmf_traffic calls it.
class Crossing {
 public:
  Crossing(Geometry a, Geometry b, fcl::CCDSolverType solver, Splines of_a, Splines of_b)
      : a_(std::move(a)), b_(std::move(b)), of_a_(std::move(of_a)), of_b_(std::move(of_b)) {
    request_.ccd_solver_type = solver;
    request_.num_max_iterations = kSamples;
    request_.toc_err = kShapeTimeError;
  }
  double value(std::size_t i) {
    of_a_[i]->integrate(0);
    of_b_[i]->integrate(0);
    const fcl::ContinuousCollisionObjectd a(a_, of_a_[i]), b(b_, of_b_[i]);
    fcl::ContinuousCollisionResultd result;
    fcl::collide(&a, &b, request_, result);
    return result.is_collide ? result.time_of_contact : std::numeric_limits<double>::infinity();
  }

 private:
  Geometry a_, b_;
  Splines of_a_, of_b_;
  fcl::ContinuousCollisionRequestd request_;
};

Result measureBodies(const char* name, std::size_t vertices, const std::pair<Geometry, Geometry>& ours,
                     const std::pair<Geometry, Geometry>& theirs, const char* their_name, const Settings& settings) {
  const Splines of_a = randomSplines(17), of_b = randomSplines(18);
  std::vector<ValueContender> contenders;
  const auto add = [&](const std::string& method, Role role, const std::pair<Geometry, Geometry>& bodies,
                       fcl::CCDSolverType solver) {
    contenders.push_back(contender<Values>(
        method, role, false, std::make_shared<Crossing>(bodies.first, bodies.second, solver, of_a, of_b), kMotions));
  };
  add("via FCL", Role::Ours, ours, fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
  add("via FCL, 15 samples", Role::Rival, ours, fcl::CCDC_NAIVE);
  add(their_name, Role::Rival, theirs, fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
  add(std::string(their_name) + ", 15 samples", Role::Rival, theirs, fcl::CCDC_NAIVE);
  return measure({"spline", name, "splines", vertices, vertices, kMotions, 1}, contenders, kAgreement, settings);
}

}  // namespace

std::vector<Result> measureSplines(const Settings& settings) {
  // Long enough for a walk through all motions.
  const Settings patient{3, std::max(0.15, settings.seconds_per_repetition)};
  const auto shape = [](const Polygon& polygon, double margin) {
    return std::make_shared<tricover_fcl::PolygonShaped>(polygon, tricover_fcl::PolygonOptions{margin, -1, 1});
  };
  const Ring hull = {{-0.6, -0.3}, {0.5, -0.3}, {0.6, -0.2}, {0.6, 0.2}, {0.5, 0.3}, {-0.6, 0.3}};
  const Geometry footprint = shape(Polygon({hull}), 0), disc = shape(point({0, 0}), 0.5);
  // Prisms of equal height at equal z are what MPR is wrong about.
  const std::pair<Geometry, Geometry> prisms = {support::makePrism(hull, 1), support::makePrism(hull, 2)};
  const Geometry sphere = std::make_shared<fcl::Sphered>(0.5);
  return {measureBodies("footprints", hull.size(), {footprint, footprint}, prisms, "FCL Convex", patient),
          measureBodies("discs", 1, {disc, disc}, {sphere, sphere}, "FCL Sphere", patient)};
}

}  // namespace tricover::bench
