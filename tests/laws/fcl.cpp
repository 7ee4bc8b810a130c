// SPDX-License-Identifier: BSD-3-Clause
// collide, distance and continuousCollide of two polygons as FCL's objects, in double and float, against the exact
// truth.
#include <fcl/math/motion/translation_motion.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "law.h"
#include "pairs.h"
#include "reference.h"
#include "reproduction.h"
#include "spatial.h"
#include "tricover/distance.h"
#include "tricover_fcl/tricover_fcl.h"

namespace tricover::laws {
namespace {

using namespace support;

template <typename S>
using Shape = tricover_fcl::PolygonShape<S>;

/// Through FCL's own function where libfcl has it compiled: for doubles.
template <typename S>
std::size_t collideByFcl(const Shape<S>& a, const fcl::Transform3<S>& tf_a, const Shape<S>& b,
                         const fcl::Transform3<S>& tf_b, const fcl::CollisionRequest<S>& request,
                         fcl::CollisionResult<S>& result) {
  if constexpr (std::is_same<S, double>::value) return fcl::collide(&a, tf_a, &b, tf_b, request, result);
  return tricover_fcl::collide<S>(&a, tf_a, &b, tf_b, request, result);
}

template <typename S>
Pose poseAt(const fcl::MotionBase<S>& motion, S time) {
  fcl::Transform3<S> pose;
  motion.integrate(time);
  motion.getCurrentTransform(pose);
  return planar(pose);
}

bool isRigid(const Pose& pose) {
  return (pose.linear().transpose() * pose.linear() - Eigen::Matrix2d::Identity()).norm() < kRigidTolerance;
}

/// What a slide of b to its pose says. FCL's motions turn by quaternions, so what they do is asked of themselves.
template <typename S>
std::string wrongImpact(Random& random, const Case& c, const Shape<S>& a, const Shape<S>& b,
                        const fcl::Transform3<S>& tf_a, const fcl::Transform3<S>& tf_b, double margin) {
  fcl::Transform3<S> from = tf_b;
  from.translation().x() += static_cast<S>(std::min(c.b.radius(), 1e30) * random.real(-3, 3));
  const fcl::TranslationMotion<S> still(tf_a, tf_a), slide(from, tf_b);
  const Case start{c.a, poseAt<S>(still, 0), c.b, poseAt<S>(slide, 0)};
  if (!isRigid(start.pose_a) || !isRigid(start.pose_b)) return "";  // quaternions double what a pose is off
  Case end = start;
  const Vec2 shift = slide.getVelocity().template head<2>().template cast<double>();
  end.pose_b.translation() += shift;
  const bool is_exact = end.pose_b.translation() - shift == start.pose_b.translation() &&
                        end.pose_b.translation() - start.pose_b.translation() == shift;

  fcl::ContinuousCollisionResult<S> impact;
  fcl::ContinuousCollisionRequest<S> request;
  request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;  // the default samples
  tricover_fcl::continuousCollide<S>(&a, &still, &b, &slide, request, impact);
  if (is_exact && !impact.is_collide && Reference(end).within(margin)) return "continuousCollide: they meet at the end";
  const bool starts = impact.is_collide && impact.time_of_contact == 0;
  const bool at_start = Reference(start).within(margin);
  if (at_start && !starts) return "continuousCollide: at the start";
  const double sizes = c.a.radius() + c.b.radius() + (start.pose_b.translation() - start.pose_a.translation()).norm();
  if (starts && !at_start && margin == 0 && Reference(start).distance().low > 1e-3 * c.b.radius() + 1e-12 * sizes)
    return "continuousCollide: not at the start";
  return "";
}

/// What FCL's functions say of the case, whose poses are S's, and what they should.
template <typename S>
std::string wrongAnswers(Random& random, const Case& c, double margin_a, double margin_b) {
  tricover_fcl::PolygonOptions of_a, of_b;
  of_a.margin = margin_a;
  of_b.margin = margin_b;
  const Shape<S> a(c.a, of_a), b(c.b, of_b);
  const fcl::Transform3<S> tf_a = lifted<S>(c.pose_a), tf_b = lifted<S>(c.pose_b);
  const double margin = margin_a + margin_b;
  const bool truth = Reference(c).within(margin);
  fcl::CollisionRequest<S> request;
  fcl::CollisionResult<S> hit, swapped;
  if ((collideByFcl(a, tf_a, b, tf_b, request, hit) > 0) != truth) return "collide";
  if ((collideByFcl(b, tf_b, a, tf_a, request, swapped) > 0) != truth) return "collide, swapped";
  if (random.oneIn(4)) {
    fcl::DistanceResult<S> apart;
    tricover_fcl::distance<S>(&a, tf_a, &b, tf_b, fcl::DistanceRequest<S>(), apart);
    DistanceOptions options;
    options.margin = margin;
    const double expected = distance(c.a, c.pose_a, c.b, c.pose_b, options).distance;
    if ((apart.min_distance <= 0) != truth) return "distance: zero or not";
    if (!truth && std::is_same<S, double>::value && apart.min_distance != expected) return "distance";
  }
  return random.oneIn(8) ? wrongImpact(random, c, a, b, tf_a, tf_b, margin) : "";
}

std::string wrong(Random& random, Tally& tally, Case& c, bool is_float) {
  if (is_float)
    for (Pose* pose : {&c.pose_a, &c.pose_b}) *pose = planar(lifted<float>(*pose));
  if (!c.pose_a.matrix().allFinite() || !c.pose_b.matrix().allFinite()) return {};
  const double margin_a = random.oneIn(3) ? smallerRadius(c) * random.unit() : 0,
               margin_b = random.oneIn(3) ? smallerRadius(c) * random.unit() : 0;
  tally.count("hits", Reference(c).within(margin_a + margin_b));
  std::string problem;
  try {
    problem = is_float ? wrongAnswers<float>(random, c, margin_a, margin_b)
                       : wrongAnswers<double>(random, c, margin_a, margin_b);
  } catch (const std::exception& error) {
    problem = error.what();
  }
  return problem.empty() ? problem : problem + ", margins " + hex(margin_a) + ", " + hex(margin_b);
}

std::string wrongDouble(Random& random, Tally& tally, Case& c) { return wrong(random, tally, c, false); }
std::string wrongFloat(Random& random, Tally& tally, Case& c) { return wrong(random, tally, c, true); }

Laws fclLaws() {
  tricover_fcl::registerNarrowphase();
  Limits limits;
  limits.most_exponent = 20;
  Laws laws;
  add(laws, anyPairs(), 400, wrongDouble);
  add(laws, anyPairs(limits), 200, wrongFloat, {{"hits", 0.02, 0.98}}, "float_");
  return laws;
}

const Register registered("fcl", fclLaws);

}  // namespace
}  // namespace tricover::laws
