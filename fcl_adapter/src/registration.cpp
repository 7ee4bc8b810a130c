// SPDX-License-Identifier: BSD-3-Clause
// The only file that sees FCL's function tables: instantiating them takes half a minute and a gigabyte.
#include "tricover_fcl/registration.h"

#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

#include <memory>
#include <stdexcept>
#include <string>

#include "collide_polygons.h"
#include "tricover_fcl/collide.h"
#include "tricover_fcl/polygon_shape.h"
#include "unsupported.h"

// libfcl hides its function tables but not the functions that read them. These instantiations replace them for the whole
// program (they come first in the search order), and read our tables, which hold FCL's rows and ours.
// Those for float are templates in every user's own code.
namespace fcl {

#define TRICOVER_INSTANTIATE(Solver)                                                                                 \
  template std::size_t collide(const CollisionGeometry<double>*, const Transform3<double>&,                          \
                               const CollisionGeometry<double>*, const Transform3<double>&, const Solver*,           \
                               const CollisionRequest<double>&, CollisionResult<double>&);                           \
  template double detail::continuousCollideConservativeAdvancement(                                                  \
      const CollisionGeometry<double>*, const MotionBase<double>*, const CollisionGeometry<double>*,                 \
      const MotionBase<double>*, const Solver*, const ContinuousCollisionRequest<double>&,                           \
      ContinuousCollisionResult<double>&);
TRICOVER_INSTANTIATE(detail::GJKSolver_libccd<double>)
TRICOVER_INSTANTIATE(detail::GJKSolver_indep<double>)
#undef TRICOVER_INSTANTIATE

// libfcl doesn't export the solver's level of these.
template double distance(const CollisionObject<double>*, const CollisionObject<double>*, const DistanceRequest<double>&,
                         DistanceResult<double>&);
template double distance(const CollisionGeometry<double>*, const Transform3<double>&, const CollisionGeometry<double>*,
                         const Transform3<double>&, const DistanceRequest<double>&, DistanceResult<double>&);

}  // namespace fcl

namespace tricover_fcl {
namespace {

template <typename Solver, typename S = typename Solver::S>
std::size_t collideRow(const fcl::CollisionGeometry<S>* o1, const fcl::Transform3<S>& tf1,
                       const fcl::CollisionGeometry<S>* o2, const fcl::Transform3<S>& tf2, const Solver*,
                       const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result) {
  return collidePolygons(*o1, tf1, *o2, tf2, request, result);
}

template <typename Solver, typename S = typename Solver::S>
S distanceRow(const fcl::CollisionGeometry<S>* o1, const fcl::Transform3<S>&, const fcl::CollisionGeometry<S>* o2,
              const fcl::Transform3<S>&, const Solver*, const fcl::DistanceRequest<S>&, fcl::DistanceResult<S>&) {
  throwUnsupported("distance", *o1, *o2);
}

template <typename Solver, typename S = typename Solver::S>
S advancementRow(const fcl::CollisionGeometry<S>* o1, const fcl::MotionBase<S>*, const fcl::CollisionGeometry<S>* o2,
                 const fcl::MotionBase<S>*, const Solver*, const fcl::ContinuousCollisionRequest<S>&,
                 fcl::ContinuousCollisionResult<S>&) {
  throwUnsupported("conservative advancement", *o1, *o2);
}

/// Our node type's row and column, all of it: FCL leaves them empty, and answers "free" from an empty one.
template <typename Solver>
void fillTables() {
  auto& collision = fcl::getCollisionFunctionLookTable<Solver>().collision_matrix;
  auto& distance = fcl::getDistanceFunctionLookTable<Solver>().distance_matrix;
  auto& advancement = fcl::getConservativeAdvancementFunctionLookTable<Solver>().conservative_advancement_matrix;
  for (int other = 0; other < fcl::NODE_COUNT; ++other) {
    collision[fcl::GEOM_TRIANGLE][other] = collision[other][fcl::GEOM_TRIANGLE] = collideRow<Solver>;
    distance[fcl::GEOM_TRIANGLE][other] = distance[other][fcl::GEOM_TRIANGLE] = distanceRow<Solver>;
    advancement[fcl::GEOM_TRIANGLE][other] = advancement[other][fcl::GEOM_TRIANGLE] = advancementRow<Solver>;
  }
}

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
    if (!throwsUnsupported([&] {
          fcl::distance(square.get(), pose, square.get(), pose, distance_request, distance_result);
        }) ||
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
  fillTables<fcl::detail::GJKSolver_libccd<float>>();
  fillTables<fcl::detail::GJKSolver_indep<float>>();
  fillTables<fcl::detail::GJKSolver_libccd<double>>();
  fillTables<fcl::detail::GJKSolver_indep<double>>();
  const std::string unreached = unreachedEntryPoint();
  if (!unreached.empty()) {
    throw std::logic_error(
        "tricover: " + unreached + " doesn't reach tricover, because libfcl comes before it in the search order. Link "
        "tricover::fcl before fcl (with a shared tricover, libtricover_fcl.so before libfcl.so, and nothing in LD_PRELOAD "
        "that brings libfcl first), or link tricover statically, without hiding the executable's symbols; or call "
        "tricover_fcl::collide and tricover_fcl::defaultCollisionFunction, which work in every case");
  }
  return true;
}

}  // namespace

void registerNarrowphase() {
  static const bool registered = registerOnce();  // by one thread, the others wait; tried again if it throws
  static_cast<void>(registered);
}

template <typename S>
std::size_t collide(const fcl::CollisionGeometry<S>* o1, const fcl::Transform3<S>& tf1,
                    const fcl::CollisionGeometry<S>* o2, const fcl::Transform3<S>& tf2,
                    const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result) {
  if (isPolygon(*o1) || isPolygon(*o2)) return collidePolygons(*o1, tf1, *o2, tf2, request, result);
  return fcl::collide(o1, tf1, o2, tf2, request, result);
}

template <typename S>
std::size_t collide(const fcl::CollisionObject<S>* o1, const fcl::CollisionObject<S>* o2,
                    const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result) {
  return tricover_fcl::collide(o1->collisionGeometry().get(), o1->getTransform(), o2->collisionGeometry().get(),
                               o2->getTransform(), request, result);
}

template <typename S>
bool defaultCollisionFunction(fcl::CollisionObject<S>* o1, fcl::CollisionObject<S>* o2, void* data) {
  auto& collision = *static_cast<fcl::DefaultCollisionData<S>*>(data);
  if (collision.done) return true;
  const std::size_t contacts = tricover_fcl::collide(o1, o2, collision.request, collision.result);
  collision.done = !collision.request.enable_cost && contacts > 0 && contacts >= collision.request.num_max_contacts;
  return collision.done;
}

#define TRICOVER_INSTANTIATE(S)                                                                                       \
  template std::size_t collide(const fcl::CollisionGeometry<S>*, const fcl::Transform3<S>&,                           \
                               const fcl::CollisionGeometry<S>*, const fcl::Transform3<S>&,                           \
                               const fcl::CollisionRequest<S>&, fcl::CollisionResult<S>&);                            \
  template std::size_t collide(const fcl::CollisionObject<S>*, const fcl::CollisionObject<S>*,                        \
                               const fcl::CollisionRequest<S>&, fcl::CollisionResult<S>&);                            \
  template bool defaultCollisionFunction(fcl::CollisionObject<S>*, fcl::CollisionObject<S>*, void*);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
