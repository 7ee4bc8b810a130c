// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/collide.h"

#include <algorithm>
#include <cmath>

#include "cases.h"
#include "reproduction.h"
#include "shapes.h"
#include "soak.h"

namespace tricover::soak {
namespace {

/// About as long as the distance, or exactly so but for an ulp.
double anyMargin(Random& random, const Drawn& drawn, const Reference& truth) {
  const auto apart = static_cast<double>(truth.distance().low);
  if (!std::isfinite(apart)) return drawn.size;
  const double near = random.coin() ? apart * random.real(0.5, 1.5) : support::nudged(apart, random.integer(-1, 1));
  return random.oneIn(4) ? drawn.size * random.unit() : std::max(near, 0.0);
}

}  // namespace

/// collide() against the exact truth, in both orders; with margins; with tolerances what they allow.
void soakCollide(Run& run) {
  while (run.next()) {
    Random& random = run.random();
    const Drawn drawn = anyCase(random);
    const Case& c = drawn.c;
    const Reference reference(c);
    CollideOptions options;
    if (random.oneIn(4)) options.margin = anyMargin(random, drawn, reference);
    const bool truth = options.margin == 0 ? reference.collide() : reference.within(options.margin);
    run.count(drawn.family, truth);
    const auto expect = [&](bool right, const char* what) {
      if (!right)
        run.fail(drawn.family,
                 std::string(what) + ", margin " + support::hex(options.margin) + ", truth " + (truth ? "1" : "0"),
                 support::reproduction(c));
    };
    expect(collide(c.a, c.pose_a, c.b, c.pose_b, options) == truth, "collide");
    expect(collide(c.b, c.pose_b, c.a, c.pose_a, options) == truth, "collide, swapped");
    if (random.oneIn(8)) {
      options.tolerance = drawn.size * random.real(0, 2);
      const bool found = collide(c.a, c.pose_a, c.b, c.pose_b, options);
      expect(found == truth || (found && reference.within(options.margin + options.tolerance)), "tolerance");
    }
  }
}

}  // namespace tricover::soak
