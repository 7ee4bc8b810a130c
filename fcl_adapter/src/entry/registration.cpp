// SPDX-License-Identifier: BSD-3-Clause
#include "tricover_fcl/registration.h"

#include <fcl/math/motion/translation_motion.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

#include <memory>
#include <stdexcept>
#include <string>

#include "entry/fill_tables.h"
#include "shape/errors.h"
#include "tricover_fcl/polygon_shape.h"

namespace tricover_fcl {
namespace {

/// Whether fcl::continuousCollide of two motions throws, as it does if it is ours. (What this calls is linked, too, and
/// serves the calls from within libfcl.)
bool refuses(const PolygonShaped& shape, const fcl::ContinuousCollisionRequest<double>& request) {
  const fcl::TranslationMotion<double> still(fcl::Transform3<double>::Identity(), fcl::Transform3<double>::Identity());
  fcl::ContinuousCollisionResult<double> result;
  try {
    fcl::continuousCollide<double>(&shape, &still, &shape, &still, request, result);
  } catch (const std::logic_error&) {
    return true;
  }
  return false;
}

/// The name of a public entry point that doesn't reach our rows, or an empty string. Stops at the first, because FCL
/// prints a warning for each.
std::string unreachedEntryPoint() {
  const auto square = std::make_shared<PolygonShaped>(tricover::Polygon({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}));
  const fcl::Transform3<double> here = fcl::Transform3<double>::Identity();
  fcl::Transform3<double> beside = here, beyond = here;
  beside.translation().x() = 3;
  beyond.translation().x() = 7;
  const fcl::CollisionObject<double> object(square), other(square, beside);
  for (const fcl::GJKSolverType solver : {fcl::GST_LIBCCD, fcl::GST_INDEP}) {
    fcl::CollisionRequest<double> request;
    request.gjk_solver_type = solver;
    fcl::CollisionResult<double> of_geometries, of_objects;
    if (fcl::collide(square.get(), here, square.get(), here, request, of_geometries) != 1 ||
        fcl::collide(&object, &object, request, of_objects) != 1) {
      return "fcl::collide";
    }

    fcl::DistanceRequest<double> distance_request;
    distance_request.gjk_solver_type = solver;
    fcl::DistanceResult<double> between_geometries, between_objects;
    if (fcl::distance(square.get(), here, square.get(), beside, distance_request, between_geometries) != 2 ||
        fcl::distance(&object, &other, distance_request, between_objects) != 2) {
      return "fcl::distance";
    }

    fcl::ContinuousCollisionRequest<double> continuous_request;
    continuous_request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    continuous_request.gjk_solver_type = solver;
    fcl::ContinuousCollisionResult<double> passing;
    const double time =
        fcl::continuousCollide(square.get(), here, beyond, square.get(), beside, beside, continuous_request, passing);
    if (!passing.is_collide || !(time > 0.25 && time < 0.3)) return "fcl::continuousCollide";  // 2 / 7
    continuous_request.ccd_solver_type = fcl::CCDC_RAY_SHOOTING;
    if (!refuses(*square, continuous_request)) return "fcl::continuousCollide";
  }
  return {};
}

bool registerOnce() {
  const std::string unreached = unreachedEntryPoint();
  if (!unreached.empty()) {
    refuseQuestion(
        unreached, "it doesn't reach tricover, because libfcl comes before it in the search order",
        "link tricover::fcl before fcl (with a shared tricover, libtricover_fcl.so before libfcl.so, and nothing in "
        "LD_PRELOAD that brings libfcl first), or link tricover statically, without hiding the executable's symbols. "
        "In a plugin whose host links libfcl, start the host with libtricover_fcl.so and libtricover.so in LD_PRELOAD, "
        "or call tricover_fcl::collide, distance, continuousCollide and the callbacks beside them, which work in every "
        "case");
  }
  return true;
}

}  // namespace

template <>
detail::FilledTables<double> detail::filledTables(const FclLayout& seen) {
  checkFclLayout(seen);
  static const bool filled = fillTables<double>();  // by one thread, the others wait
  static_cast<void>(filled);
  return {};
}

void detail::registerNarrowphase() {
  static const bool registered = registerOnce();  // by one thread, the others wait; tried again if it throws
  static_cast<void>(registered);
}

}  // namespace tricover_fcl
