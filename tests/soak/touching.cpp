// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "cases.h"
#include "laws.h"
#include "reproduction.h"
#include "shapes.h"
#include "soak.h"
#include "touching_families.h"
#include "touching_laws.h"

namespace tricover::soak {

/// Whether interiors meet, in every way of asking, against exact rationals: of pairs that often touch without that, and
/// of any.
void soakTouching(Run& run) {
  Limits limits;
  limits.most_vertices = 12;
  support::StrategyCaches old;
  while (run.next()) {
    Random& random = run.random();
    const auto& touching = support::touchingFamilies();
    const support::Family& family = touching[random.bits() % touching.size()];
    const Drawn drawn = random.coin() ? anyCase(random, limits) : Drawn{family.name, family.make(random.bits()), 1};
    const support::Overlap truth = support::overlapOf(drawn.c);
    run.count(drawn.family, truth.overlap);
    std::string wrong = support::wrongTouching(drawn.c, truth, old, random);
    if (wrong.empty()) wrong = support::wrongTouchingInScene(drawn.c, truth);
    if (wrong.empty() && random.oneIn(100)) {
      const double apart = static_cast<double>(Reference(drawn.c).distance().low);
      const double margin = random.coin() && apart < 1e300 ? support::nudged(apart, random.integer(0, 2)) : 0;
      wrong = support::brokenLaw(drawn.c, margin, Touching::Allowed,
                                 support::areWithin(drawn.c, margin, Touching::Allowed), random, old.of_pair);
    }
    if (wrong.empty()) continue;
    run.fail(drawn.family,
             wrong + ", truth: meet " + std::to_string(truth.meet) + ", overlap " + std::to_string(truth.overlap),
             support::reproduction(drawn.c));
  }
}

}  // namespace tricover::soak
