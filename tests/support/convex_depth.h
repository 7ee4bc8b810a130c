// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reference.h"

namespace tricover::support {

/// One ring that turns the same way at every vertex, once around, beyond doubt.
bool isStrictlyConvex(const Polygon& polygon);

/// How deep two of them that overlap are in each other, by the least gap over the faces of both: in long doubles.
Reference::Bounds convexDepth(const Case& c);

}  // namespace tricover::support
