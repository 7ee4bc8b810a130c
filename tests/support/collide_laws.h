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

}  // namespace tricover::support
