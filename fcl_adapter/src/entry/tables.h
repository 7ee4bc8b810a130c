// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tricover_fcl {

/// Puts our rows into FCL's function tables of both solvers. Instantiating the tables takes a minute and a gigabyte for
/// each scalar, so it happens in two files and nowhere else: tables_float.cpp and tables_double.cpp.
template <typename S>
void fillTables();

}  // namespace tricover_fcl
