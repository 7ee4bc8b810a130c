// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "penetration/separating_axes.h"
#include "tricover/contacts.h"

namespace tricover::detail {

/// The contact of two convex polygons that meet so that plain doubles prove their edges to cross twice, in O(n + m). No
/// answer for all others.
std::optional<Contact> convexContact(const PosedPair& pair, const SeparatingAxes& axes, double margin);

}  // namespace tricover::detail
