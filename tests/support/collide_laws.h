// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "families.h"
#include "random.h"
#include "strategies.h"

namespace tricover::support {

/// Without a tolerance, both are the truth.
struct CollideTruth {
  bool must, may;
};

/// The first way to ask collide() whose answer is wrong; empty if there is none. At every stage, by both strategies, in
/// both orders, with caches that are new, that saw other poses, and old ones that saw other pairs and options.
std::string wrongCollide(const Case& c, const CollideOptions& options, const CollideTruth& truth, StrategyCaches& old,
                         Random& random);

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
