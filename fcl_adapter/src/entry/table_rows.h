// SPDX-License-Identifier: BSD-3-Clause
// Our rows of FCL's function tables. Only for the files that instantiate a table (fill_tables.h).
#pragma once

#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

#include "entry/fill_tables.h"
#include "queries/queries.h"

// FCL's distances and advancements ask collide, too: without this its tables would be instantiated with theirs.
namespace fcl {

extern TRICOVER_COLLIDE(double, detail::GJKSolver_libccd);
extern TRICOVER_COLLIDE(double, detail::GJKSolver_indep);
extern TRICOVER_COLLIDE(float, detail::GJKSolver_libccd);
extern TRICOVER_COLLIDE(float, detail::GJKSolver_indep);
extern template std::size_t collide(const CollisionGeometry<float>*, const Transform3<float>&,
                                    const CollisionGeometry<float>*, const Transform3<float>&,
                                    const CollisionRequest<float>&, CollisionResult<float>&);

}  // namespace fcl

namespace tricover_fcl {

template <typename Solver, typename S = typename Solver::S>
std::size_t collideRow(const fcl::CollisionGeometry<S>* o1, const fcl::Transform3<S>& tf1,
                       const fcl::CollisionGeometry<S>* o2, const fcl::Transform3<S>& tf2, const Solver*,
                       const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result) {
  return collideGeometries(*o1, tf1, *o2, tf2, request, result);
}

template <typename Solver, typename S = typename Solver::S>
S distanceRow(const fcl::CollisionGeometry<S>* o1, const fcl::Transform3<S>& tf1, const fcl::CollisionGeometry<S>* o2,
              const fcl::Transform3<S>& tf2, const Solver*, const fcl::DistanceRequest<S>& request,
              fcl::DistanceResult<S>& result) {
  return distanceOfGeometries(*o1, tf1, *o2, tf2, request, result);
}

template <typename Solver, typename S = typename Solver::S>
S advancementRow(const fcl::CollisionGeometry<S>* o1, const fcl::MotionBase<S>* motion1,
                 const fcl::CollisionGeometry<S>* o2, const fcl::MotionBase<S>* motion2, const Solver*,
                 const fcl::ContinuousCollisionRequest<S>& request, fcl::ContinuousCollisionResult<S>& result) {
  return advanceGeometries(*o1, *motion1, *o2, *motion2, request, result);
}

/// Our node type's row and column, all of it: FCL leaves them empty, and answers "free" from an empty one.
template <typename Function>
void fillRowAndColumn(Function (&matrix)[fcl::NODE_COUNT][fcl::NODE_COUNT], Function ours) {
  for (int other = 0; other < fcl::NODE_COUNT; ++other) {
    matrix[fcl::GEOM_TRIANGLE][other] = matrix[other][fcl::GEOM_TRIANGLE] = ours;
  }
}

template <typename S>
void fillCollisionTables() {
  using Ccd = fcl::detail::GJKSolver_libccd<S>;
  using Indep = fcl::detail::GJKSolver_indep<S>;
  fillRowAndColumn(fcl::getCollisionFunctionLookTable<Ccd>().collision_matrix, &collideRow<Ccd>);
  fillRowAndColumn(fcl::getCollisionFunctionLookTable<Indep>().collision_matrix, &collideRow<Indep>);
}

template <typename S>
void fillDistanceTables() {
  using Ccd = fcl::detail::GJKSolver_libccd<S>;
  using Indep = fcl::detail::GJKSolver_indep<S>;
  fillRowAndColumn(fcl::getDistanceFunctionLookTable<Ccd>().distance_matrix, &distanceRow<Ccd>);
  fillRowAndColumn(fcl::getDistanceFunctionLookTable<Indep>().distance_matrix, &distanceRow<Indep>);
}

template <typename Solver>
void fillAdvancementTable() {
  fillRowAndColumn(fcl::getConservativeAdvancementFunctionLookTable<Solver>().conservative_advancement_matrix,
                   &advancementRow<Solver>);
}

template <typename S>
void fillAdvancementTables() {
  fillAdvancementTable<fcl::detail::GJKSolver_libccd<S>>();
  fillAdvancementTable<fcl::detail::GJKSolver_indep<S>>();
}

}  // namespace tricover_fcl
