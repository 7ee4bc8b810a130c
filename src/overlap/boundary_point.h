// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "tricover/pose.h"

namespace tricover::detail {

/// A point of an overlap's boundary, in the WorldFrame, and the edges that it is on (positions; -1: none): a crossing
/// is on one of each, a vertex on two of its polygon.
struct BoundaryPoint {
  Vec2 at;
  std::ptrdiff_t a, a_before, b, b_before;
};

}  // namespace tricover::detail
