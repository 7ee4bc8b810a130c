// SPDX-License-Identifier: BSD-3-Clause
// Only for tables_float.cpp and tables_double.cpp: what it includes is what makes them heavy.
#pragma once

#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

#include "entry/queries.h"

namespace tricover_fcl {

template <typename Solver, typename S = typename Solver::S>
std::size_t collideRow(const fcl::CollisionGeometry<S>* o1, const fcl::Transform3<S>& tf1,
                       const fcl::CollisionGeometry<S>* o2, const fcl::Transform3<S>& tf2, const Solver*,
                       const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result) {
  return collideGeometries(*o1, tf1, *o2, tf2, request, {}, result);
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
template <typename Solver>
void fillSolverTables() {
  auto& collision = fcl::getCollisionFunctionLookTable<Solver>().collision_matrix;
  auto& distance = fcl::getDistanceFunctionLookTable<Solver>().distance_matrix;
  auto& advancement = fcl::getConservativeAdvancementFunctionLookTable<Solver>().conservative_advancement_matrix;
  for (int other = 0; other < fcl::NODE_COUNT; ++other) {
    collision[fcl::GEOM_TRIANGLE][other] = collision[other][fcl::GEOM_TRIANGLE] = collideRow<Solver>;
    distance[fcl::GEOM_TRIANGLE][other] = distance[other][fcl::GEOM_TRIANGLE] = distanceRow<Solver>;
    advancement[fcl::GEOM_TRIANGLE][other] = advancement[other][fcl::GEOM_TRIANGLE] = advancementRow<Solver>;
  }
}

}  // namespace tricover_fcl
