// SPDX-License-Identifier: BSD-3-Clause
#include "tricover_fcl/registration.h"

#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

#include <memory>
#include <stdexcept>
#include <string>

#include "tables.h"
#include "tricover_fcl/polygon_shape.h"
#include "unsupported.h"

namespace tricover_fcl {
namespace {

template <typename Query>
bool throwsUnsupported(const Query& query) {
  try {
    query();
  } catch (const UnsupportedPair&) {
    return true;
  }
  return false;
}

/// The name of a public entry point that doesn't reach our rows, or an empty string. Stops at the first, because FCL
/// prints a warning for each.
std::string unreachedEntryPoint() {
  const auto square = std::make_shared<PolygonShaped>(tricover::Polygon({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}));
  const fcl::CollisionObject<double> object(square);
  const fcl::Transform3<double> pose = fcl::Transform3<double>::Identity();
  for (const fcl::GJKSolverType solver : {fcl::GST_LIBCCD, fcl::GST_INDEP}) {
    fcl::CollisionRequest<double> request;
    request.gjk_solver_type = solver;
    fcl::CollisionResult<double> of_geometries, of_objects;
    if (fcl::collide(square.get(), pose, square.get(), pose, request, of_geometries) != 1 ||
        fcl::collide(&object, &object, request, of_objects) != 1) {
      return "fcl::collide";
    }

    fcl::DistanceRequest<double> distance_request;
    distance_request.gjk_solver_type = solver;
    fcl::DistanceResult<double> distance_result;
    if (!throwsUnsupported(
            [&] { fcl::distance(square.get(), pose, square.get(), pose, distance_request, distance_result); }) ||
        !throwsUnsupported([&] { fcl::distance(&object, &object, distance_request, distance_result); })) {
      return "fcl::distance";
    }

    fcl::ContinuousCollisionRequest<double> continuous_request;
    continuous_request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    continuous_request.gjk_solver_type = solver;
    fcl::ContinuousCollisionResult<double> continuous_result;
    if (!throwsUnsupported([&] {
          fcl::continuousCollide(square.get(), pose, pose, square.get(), pose, pose, continuous_request,
                                 continuous_result);
        })) {
      return "fcl::continuousCollide";
    }
  }
  return {};
}

bool registerOnce() {
  fillTables<float>();
  fillTables<double>();
  const std::string unreached = unreachedEntryPoint();
  if (!unreached.empty()) {
    throw std::logic_error(
        "tricover: " + unreached +
        " doesn't reach tricover, because libfcl comes before it in the search order. Link "
        "tricover::fcl before fcl (with a shared tricover, libtricover_fcl.so before libfcl.so, and nothing in "
        "LD_PRELOAD that brings libfcl first), or link tricover statically, without hiding the executable's symbols; "
        "or call tricover_fcl::collide and tricover_fcl::defaultCollisionFunction, which work in every case");
  }
  return true;
}

}  // namespace

void registerNarrowphase() {
  static const bool registered = registerOnce();  // by one thread, the others wait; tried again if it throws
  static_cast<void>(registered);
}

}  // namespace tricover_fcl
