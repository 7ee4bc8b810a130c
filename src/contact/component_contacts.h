// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "penetration/separating_axes.h"
#include "tricover/contacts.h"

namespace tricover::detail {

/// One contact for each component of the overlap, of any two polygons, deeper by the margin, as many as there are; none
/// if they are apart. axes: those of two convex regions, otherwise null.
std::vector<Contact> componentContacts(const PosedPair& pair, const SeparatingAxes* axes,
                                       const ContactOptions& options);

}  // namespace tricover::detail
