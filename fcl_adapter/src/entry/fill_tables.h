// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

}  // namespace tricover_fcl
