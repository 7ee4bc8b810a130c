// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tricover/polygon.h"

namespace tricover_fcl {

/// The convex hull of the points (at least one, all finite), counter-clockwise, right to 2^-50 of its size. The ring of
/// a hull without area runs there and back; it has three vertices at least.
tricover::Ring convexHull(const std::vector<tricover::Vec2>& points);

}  // namespace tricover_fcl
