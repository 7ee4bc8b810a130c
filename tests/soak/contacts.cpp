// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/contacts.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cases.h"
#include "contact_laws.h"
#include "convex_depth.h"
#include "exact_penetration.h"
#include "exact_reference.h"
#include "reproduction.h"
#include "soak.h"

namespace tricover::soak {
namespace {

/// Whether a point is within a length of both regions, but for rounding.
bool isNear(const Case& c, const Vec2& p, double length) {
  const Polygon point({Ring(3, p)});
  const Case with_a{c.a, c.pose_a, point, Pose::Identity()}, with_b{c.b, c.pose_b, point, Pose::Identity()};
  const double error = length + support::rounding(c);
  return Reference(with_a).within(error) && Reference(with_b).within(error);
}

std::string wrongPoints(Random& random, const Case& c, const Contact& contact) {
  const ContactPoint &first = contact.points[0], &second = contact.points[1];
  if (contact.count == 1)
    return first.point == contact.point && first.depth == contact.depth && second.point == first.point ? ""
                                                                                                       : "one point";
  if (contact.count != 2) return "how many points";
  if (!(contact.depth >= first.depth && first.depth >= second.depth && second.depth >= 0)) return "a point's depth";
  if (!(first.point.allFinite() && second.point.allFinite())) return "a point";
  if (!random.oneIn(4)) return "";
  const double depth = contact.depth * (1 + 1e-9);
  return isNear(c, first.point, depth) && isNear(c, second.point, depth) ? "" : "an end that is far";
}

/// Whether a convex polygon is nowhere wider than so much, or hardly so.
bool isThin(const Polygon& polygon, double width) {
  long double area = 0;
  const Vec2 s = polygon.edgeStart(0);
  for (EdgeIndex i = 0; i < polygon.edgeCount(); ++i) {
    const Vec2 v = polygon.edgeStart(i) - s, w = polygon.edgeEnd(i) - s;
    area += static_cast<long double>(v.x()) * w.y() - static_cast<long double>(v.y()) * w.x();
  }
  return std::abs(area) < 8.0L * width * polygon.radius();
}

std::string wrongConvex(const Case& c, const Contact& contact) {
  const long double depth = contact.depth, error = support::rounding(c);
  const Reference::Bounds truth = support::convexDepth(c);
  if (!(depth <= truth.low + error && depth >= truth.high - error)) {
    const double exactly = exact::distanceBelow(exact::convexPenetrationSquared(c.a, c.pose_a, c.b, c.pose_b));
    const bool is_thin = isThin(c.a, support::rounding(c)) || isThin(c.b, support::rounding(c));
    if (contact.depth == 0 && is_thin) return "";
    if (!(std::abs(depth - exactly) <= error))
      return "depth " + support::hex(contact.depth) + ", which is " + support::hex(exactly);
  }
  Case moved = c;
  moved.pose_b.translation() += (contact.depth * (1 + 1e-9) + 4 * support::rounding(c)) * contact.normal;
  return Reference(moved).collide() ? "the way doesn't part them" : "";
}

std::string wrongContacts(Random& random, const Case& c, bool truth) {
  const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b);
  if (found.empty() == truth) return "contacts, or none";
  const bool is_convex = truth && support::isStrictlyConvex(c.a) && support::isStrictlyConvex(c.b);
  if (is_convex && found.size() != 1) return "how many there are";
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Contact& contact = found[i];
    if (!(std::abs(contact.normal.norm() - 1) <= 1e-12)) return "a normal that isn't unit";
    if (!(contact.depth >= 0 && std::isfinite(contact.depth))) return "a depth";
    if (i > 0 && contact.depth > found[i - 1].depth) return "the order";
    if (!contact.point.allFinite() || (random.oneIn(4) && !isNear(c, contact.point, 0))) return "a point outside";
    const std::string wrong = wrongPoints(random, c, contact);
    if (!wrong.empty()) return wrong;
  }
  if (is_convex) {
    const std::string wrong = wrongConvex(c, found[0]);
    if (!wrong.empty()) return wrong;
  } else if (found.size() == 1 && random.oneIn(16)) {
    const std::string wrong = support::wrongWayApart(c, found[0]);
    if (!wrong.empty()) return wrong;
  }
  if (!random.oneIn(8) || support::isOneTwice(c)) return {};
  std::vector<Contact> swapped = contacts(c.b, c.pose_b, c.a, c.pose_a);
  for (Contact& contact : swapped) contact.normal *= -1, std::swap(contact.edge_a, contact.edge_b);
  return support::same(found, swapped) ? "" : "swapped, they differ";
}

/// Contacts with a margin are where the regions are within it; apart, there is one, as deep as is left of the margin.
std::string wrongWithMargin(Random& random, const Case& c) {
  const double margin = random.unit() * std::max(c.a.radius(), c.b.radius());
  if (!std::isfinite(margin)) return "";
  const Reference reference(c);
  const bool truth = reference.within(margin);
  const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b, ContactOptions{margin});
  if (found.empty() == truth) return "contacts, or none, with a margin of " + support::hex(margin);
  const double error = support::rounding(c) + 1e-12 * margin;
  for (const Contact& contact : found)
    if (contact.depth < margin - error && reference.within(margin - contact.depth - error))
      return "shallower than what is left of the margin " + support::hex(margin);
  if (!truth || reference.collide()) return "";
  if (found.size() != 1) return "how many there are within the margin " + support::hex(margin);
  return found[0].depth <= margin && reference.within(margin - found[0].depth + error)
             ? ""
             : "deeper than what is left of the margin " + support::hex(margin);
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
    if (problem.empty() && random.oneIn(4)) problem = wrongWithMargin(random, drawn.c);
    if (!problem.empty()) run.fail(drawn.family, problem, support::reproduction(drawn.c));
  }
}

}  // namespace tricover::soak
