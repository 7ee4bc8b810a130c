// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// FCL's functions that read its tables: an instantiation or, after `extern`, a declaration of one in another file.
#define TRICOVER_COLLIDE(S, Solver)                                                                            \
  template std::size_t collide(const CollisionGeometry<S>*, const Transform3<S>&, const CollisionGeometry<S>*, \
                               const Transform3<S>&, const Solver<S>*, const CollisionRequest<S>&,             \
                               CollisionResult<S>&)
#define TRICOVER_ADVANCE(S, Solver)                                                                         \
  template S continuousCollideConservativeAdvancement(                                                      \
      const CollisionGeometry<S>*, const MotionBase<S>*, const CollisionGeometry<S>*, const MotionBase<S>*, \
      const Solver<S>*, const ContinuousCollisionRequest<S>&, ContinuousCollisionResult<S>&)

namespace tricover_fcl {

/// They put our rows into FCL's function tables of both solvers. A table costs its compiler half a minute and a
/// gigabyte, so each is instantiated in one file and nowhere else: for double where hidden entry points are replaced
/// (replaced_collide.cpp, replaced_distance.cpp, replaced_advancement*.cpp), for float in float_collide.cpp,
/// float_distance.cpp and float_advancement*.cpp.
template <typename S>
void fillCollisionTables();
template <typename S>
void fillDistanceTables();
template <typename S>
void fillAdvancementTables();

template <typename S>
bool fillTables() {
  fillCollisionTables<S>();
  fillDistanceTables<S>();
  fillAdvancementTables<S>();
  return true;
}

}  // namespace tricover_fcl
