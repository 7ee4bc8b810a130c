// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/world_frame.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"

namespace tricover::detail {

/// Where two regions that are apart are nearest, and the unit vector from a to b there.
struct NearestContact {
  DistanceResult nearest;
  Vec2 normal;
};

NearestContact nearestContact(const PosedPair& pair);

/// The contact of two regions that are apart, within a margin.
Contact contactBeside(const PosedPair& pair, double margin);

}  // namespace tricover::detail
