// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "families.h"
#include "random.h"
#include "strategies.h"

namespace tricover::support {

/// Whether the closed regions meet, and whether their interiors do.
struct Overlap {
  bool meet, overlap;
};

/// By exact rationals.
Overlap overlapOf(const Case& c);

// The first way of asking that gives another answer than the truth; empty if there is none.

/// Of collide(), in every way to ask it.
std::string wrongTouching(const Case& c, const Overlap& truth, StrategyCaches& old, Random& random);
/// The same of a Scene, which has it of a query or of a body.
std::string wrongTouchingInScene(const Case& c, const Overlap& truth);

}  // namespace tricover::support
