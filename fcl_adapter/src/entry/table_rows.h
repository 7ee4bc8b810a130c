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

#define TRICOVER_ELSEWHERE(S, Solver)                                                                                 \
  extern template std::size_t collide(const CollisionGeometry<S>*, const Transform3<S>&, const CollisionGeometry<S>*, \
                                      const Transform3<S>&, const Solver<S>*, const CollisionRequest<S>&,             \
                                      CollisionResult<S>&);
TRICOVER_ELSEWHERE(double, detail::GJKSolver_libccd)
TRICOVER_ELSEWHERE(double, detail::GJKSolver_indep)
TRICOVER_ELSEWHERE(float, detail::GJKSolver_libccd)
TRICOVER_ELSEWHERE(float, detail::GJKSolver_indep)
#undef TRICOVER_ELSEWHERE
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

template <typename Solver>
void fillCollisionTable() {
  fillRowAndColumn(fcl::getCollisionFunctionLookTable<Solver>().collision_matrix, &collideRow<Solver>);
}

template <typename Solver>
void fillDistanceTable() {
  fillRowAndColumn(fcl::getDistanceFunctionLookTable<Solver>().distance_matrix, &distanceRow<Solver>);
}

template <typename Solver>
void fillAdvancementTable() {
  fillRowAndColumn(fcl::getConservativeAdvancementFunctionLookTable<Solver>().conservative_advancement_matrix,
                   &advancementRow<Solver>);
}

}  // namespace tricover_fcl
