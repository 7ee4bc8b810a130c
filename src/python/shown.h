// SPDX-License-Identifier: BSD-3-Clause
// Results that Python hands back, for drawings and recordings to show: those of one pair, never arrays.
#pragma once

#include "python/module.h"

namespace tricover_python {

tricover::DistanceResult distanceFrom(const py::object& given);
tricover::LeastDistance leastDistanceFrom(const py::object& given);
tricover::Impact impactFrom(const py::object& given);
tricover::Conflict conflictFrom(const py::object& given);
tricover::RayHit rayHitFrom(const py::object& given);
tricover::BodyPair pairFrom(const py::object& given);
std::vector<tricover::Contact> contactsFrom(const py::object& given);

}  // namespace tricover_python
