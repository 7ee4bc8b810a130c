// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "families.h"
#include "random.h"
#include "reference.h"

/// Pairs of every kind: shapes from points to soups, sizes from 1e-300 to 1e300, contacts to the ulp and gaps beyond.
namespace tricover::soak {

using support::Case;
using support::Random;
using support::Reference;

struct Drawn {
  const char* family;  ///< of the shapes
  Case c;
  double size;  ///< about the smaller one's
};

/// What a query can't do with: sizes whose squares overflow, say.
struct Limits {
  int most_exponent = 300;  ///< of a size, base 10
  int most_vertices = 40;
  bool convex = false;  ///< only
};

Drawn anyCase(Random& random, const Limits& limits = {});

/// Of one of the families, of a size of about 1, around the origin.
Polygon anyShape(Random& random, const char*& family, const Limits& limits = {});

/// As they come: exact, turned, mirrored, made of floats, hardly rigid any more.
Pose anyRotation(Random& random);

/// b to somewhere about a: anywhere, a vertex on the other one's vertex or edge, at the contact on a way and a little
/// aside, or far away.
void place(Random& random, Case& c);

/// The next step of a walk: by an ulp or a jump, turning or not, either of them or both.
void step(Random& random, Case& c);

}  // namespace tricover::soak
