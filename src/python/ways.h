// SPDX-License-Identifier: BSD-3-Clause
// Motions and trajectories as operands of queries.
#pragma once

#include "python/module.h"

namespace tricover_python {

/// A Motion, a Trajectory or a pose where a body stays; or a list of motions or of trajectories.
struct Way {
  Many<tricover::Motion> motions;
  Many<tricover::Trajectory> trajectories;  // if there are any
  bool stays = false;                       // a pose, which is one motion that stays
};

Way wayFrom(const py::object& given, const std::string& name);
/// Makes a pose a trajectory if the other one is. \throws py::type_error for a motion beside a trajectory
void makeAlike(Way& a, Way& b, const char* name_a, const char* name_b);
/// One, or an error.
void requireOne(const Way& way, const std::string& name);

/// Times, (n,) or one.
Many<double> timesFrom(const py::object& given, const std::string& name);

}  // namespace tricover_python
