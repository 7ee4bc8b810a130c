// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tricover/contacts.h"

namespace tricover::detail {

/// The overlap of two regions as a negative margin takes it: the contacts by their local depths, the deepest first. An
/// overlap of one component that is as deep as `allowed` has its global depth, if that is less and matters.
std::vector<Contact> allowedOverlap(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                                    double allowed);

}  // namespace tricover::detail
