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

    // FCL's ray shooting says "free". (What this calls is linked, too, and serves the calls from within libfcl.)
    fcl::ContinuousCollisionRequest<double> continuous_request;
    continuous_request.gjk_solver_type = solver;
    for (const auto ccd_solver : {fcl::CCDC_CONSERVATIVE_ADVANCEMENT, fcl::CCDC_RAY_SHOOTING}) {
      continuous_request.ccd_solver_type = ccd_solver;
      const fcl::TranslationMotion<double> passes(here, beyond), still(beside, beside);
      fcl::ContinuousCollisionResult<double> of_poses, of_motions;
      const double times[] = {
          fcl::continuousCollide(&object, beyond, &other, beside, continuous_request, of_poses),
          fcl::continuousCollide<double>(square.get(), &passes, square.get(), &still, continuous_request, of_motions)};
      for (const double time : times)
        if (!(time > 0.25 && time < 0.3)) return "fcl::continuousCollide";  // 2 / 7
    }
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
