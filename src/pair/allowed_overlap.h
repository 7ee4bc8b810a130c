// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tricover/contacts.h"

namespace tricover::detail {

/// The overlap of two regions as a negative margin takes it: the contacts by their local depths, the deepest first. If
/// these are as deep as `allowed` but for the error, and a shorter translation separates the regions, that one is the
/// only contact; its `points` mean nothing. A first depth above `allowed` may be too small, but not below that.
std::vector<Contact> allowedOverlap(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                                    double allowed, double error = 0);
inline double depthOf(const std::vector<Contact>& overlap) { return overlap.empty() ? 0 : overlap.front().depth; }

}  // namespace tricover::detail
