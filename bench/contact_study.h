// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "measure.h"

/// Contacts of a body that rests or slides on another.
namespace tricover::bench {

/// The core with and without a cache, and Box2D's manifolds where it takes the polygons.
std::vector<Result> measureContacts(const Settings& settings);

}  // namespace tricover::bench
