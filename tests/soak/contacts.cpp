// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/contacts.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cases.h"
#include "contact_laws.h"
#include "convex_depth.h"
#include "reproduction.h"
#include "soak.h"

namespace tricover::soak {
namespace {

std::string wrongContacts(Random& random, const Case& c, bool truth) {
  const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b);
  if (found.empty() == truth) return "contacts, or none";
  const bool is_convex = truth && support::isStrictlyConvex(c.a) && support::isStrictlyConvex(c.b);
  if (is_convex && found.size() != 1) return "how many there are";
  std::string wrong = support::wrongContacts(random, c, found);
  if (!wrong.empty()) return wrong;
  if (is_convex)
    wrong = support::wrongConvexContact(c, found[0]);
  else if (found.size() == 1 && random.oneIn(16))
    wrong = support::wrongWayApart(c, found[0]);
  if (!wrong.empty()) return wrong;
  if (!random.oneIn(8) || support::isOneTwice(c)) return {};
  std::vector<Contact> swapped = contacts(c.b, c.pose_b, c.a, c.pose_a);
  for (Contact& contact : swapped) contact.normal *= -1, std::swap(contact.edge_a, contact.edge_b);
  return support::same(found, swapped) ? "" : "swapped, they differ";
}

}  // namespace

/// contacts() by its laws, of convex pairs against the exact depth.
void soakContacts(Run& run) {
  while (run.next()) {
    Random& random = run.random();
    Limits limits;
    limits.convex = random.coin();
    const Drawn drawn = anyCase(random, limits);
    // Sums of coordinates must not overflow here.
    if (!(support::rounding(drawn.c) < 1e285)) continue;
    const bool truth = Reference(drawn.c).collide();
    run.count(drawn.family, truth);
    std::string problem = wrongContacts(random, drawn.c, truth);
    const double margin = random.unit() * std::max(drawn.c.a.radius(), drawn.c.b.radius());
    if (problem.empty() && random.oneIn(4)) problem = support::wrongContactsWithMargin(drawn.c, margin);
    if (!problem.empty()) run.fail(drawn.family, problem, support::reproduction(drawn.c));
  }
}

}  // namespace tricover::soak
