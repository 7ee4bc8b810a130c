// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <string>

#include "cases.h"
#include "conflict_laws.h"
#include "lasting_contact_laws.h"
#include "reproduction.h"
#include "soak.h"

namespace tricover::soak {
namespace {

bool meet(const Case& c, double margin) {
  const Reference reference(c);
  return margin > 0 ? reference.within(margin) : reference.collide();
}

/// What starts in contact, or nearly, and slides: shifts beside exact intervals, motions beside many samples.
void askFromContact(Run& run) {
  Random& random = run.random();
  const bool shifts = random.coin();
  const support::MovingCase c = shifts ? support::anyShiftFromContact(random) : support::anyMotionFromContact(random);
  const double error = std::pow(10, -random.integer(2, 12));
  support::LastingCounts counts;
  const std::string wrong =
      shifts ? support::wrongWithShifts(c, error, counts) : support::wrongWithSamples(c, error, 40, counts);
  const char* family = shifts ? "shifts" : "motions";
  run.count(family, counts.later > 0);
  if (!wrong.empty())
    run.fail(family, wrong + ", time error " + support::hex(error) + ", margin " + support::hex(c.margin),
             support::reproduction(c));
}

}  // namespace

/// conflicts() against exact collisions at many times on the way, of shapes of a size of about 1.
void soakConflicts(Run& run) {
  Limits limits;
  limits.most_vertices = 16;
  while (run.next()) {
    Random& random = run.random();
    if (random.oneIn(3)) {
      askFromContact(run);
      continue;
    }
    const char *family = nullptr, *other = nullptr;
    const Polygon a = anyShape(random, family, limits), b = anyShape(random, other, limits);
    support::Flight f{a, support::anyPlan(random), b, support::anyPlan(random)};
    if (random.oneIn(3)) f.margin = random.real(0.01, 0.8);
    const double error = std::pow(10, -random.integer(2, 5));
    support::ConflictCounts counts;
    const std::string wrong = support::wrongConflicts(f, error, meet, counts);
    run.count(family, counts.spans > 0);
    if (wrong.empty()) continue;
    run.fail(family, wrong + ", time error " + support::hex(error) + ", margin " + support::hex(f.margin),
             support::reproduction({a, f.way_a.at(0), b, f.way_b.at(0)}));
  }
}

}  // namespace tricover::soak
