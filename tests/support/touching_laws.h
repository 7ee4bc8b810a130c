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
/// At the margin that the distance is, if that is one, and near it.
std::string wrongTouchingAtMargin(const Case& c);
/// What is listed, beside what is without the option, and that it is symmetric.
std::string wrongTouchingInLists(const Case& c, const Overlap& truth);

}  // namespace tricover::support
