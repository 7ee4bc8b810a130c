// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "penetration/separating_axes.h"
#include "tricover/contacts.h"

namespace tricover::detail {

/// The contact of two convex polygons that meet so that plain doubles prove their edges to cross twice, in O(n + m). No
/// answer for all others.
std::optional<Contact> convexContact(const PosedPair& pair, const SeparatingAxes& axes, double margin);

/// One contact for each component of the overlap, of any two polygons, deeper by the margin, as many as there are; none
/// if they are apart. axes: those of two convex regions, otherwise null.
std::vector<Contact> componentContacts(const PosedPair& pair, const SeparatingAxes* axes,
                                       const ContactOptions& options);

}  // namespace tricover::detail
