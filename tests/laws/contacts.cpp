// SPDX-License-Identifier: BSD-3-Clause
// contacts() in every detail, by what contacts.h promises, on exact numbers; of convex pairs against the exact depth.
#include "tricover/contacts.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "contact_laws.h"
#include "exact_reference.h"
#include "families.h"
#include "law.h"
#include "pairs.h"
#include "reference.h"
#include "shapes.h"

namespace tricover::laws {
namespace {

using namespace support;

using Pairs = std::vector<std::pair<EdgeIndex, EdgeIndex>>;

bool isEdge(const Polygon& polygon, EdgeIndex edge) { return edge >= 0 && edge < polygon.edgeCount(); }

std::vector<Contact> contactsOf(const Case& c, ContactDetail detail) {
  ContactOptions options;
  options.detail = detail;
  return contacts(c.a, c.pose_a, c.b, c.pose_b, options);
}

/// What is wrong with contacts of parts that told nothing but points; empty if nothing is.
std::string wrongPoints(const Case& c, const std::vector<Contact>& points, const Pairs& pairs) {
  for (const Contact& contact : points) {
    if (contact.depth != 0 || contact.normal != Vec2::Zero()) return "a depth of a point";
    const bool crosses = contact.edge_a >= 0 && contact.edge_b >= 0;
    if (crosses ? !std::binary_search(pairs.begin(), pairs.end(), std::pair(contact.edge_a, contact.edge_b))
                : !isEdge(c.a, contact.edge_a) && !isEdge(c.b, contact.edge_b))
      return "a point's edges";
  }
  return {};
}

/// What is wrong with contacts of less detail, given all pairs of edges that meet; empty if nothing is.
std::string wrongDetail(Random& random, const Case& c, const std::vector<Contact>& found, const Pairs& pairs) {
  const std::vector<Contact> points = contactsOf(c, ContactDetail::Points),
                             local = contactsOf(c, ContactDetail::LocalDepth);
  if (points.size() != found.size() || local.size() != found.size()) return "how many there are by less detail";
  // Of convex polygons all is told.
  const std::string wrong_points = same(points, found) ? "" : wrongPoints(c, points, pairs);
  if (!wrong_points.empty()) return wrong_points;
  const std::string wrong = wrongContacts(random, c, local) + wrongEdges(c, local, !pairs.empty());
  if (!wrong.empty()) return wrong + ", local";
  return wrongLocalDepths(c, local);
}

std::string wrongSwapped(const Case& c, const std::vector<Contact>& found) {
  std::vector<Contact> swapped = contacts(c.b, c.pose_b, c.a, c.pose_a);
  for (Contact& contact : swapped) contact.normal *= -1, std::swap(contact.edge_a, contact.edge_b);
  return same(found, swapped) ? "" : "swapped, they differ";
}

std::string wrong(Random& random, Tally& tally, Case& c) {
  const bool truth = Reference(c).collide();
  const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b);
  tally.count("hits", truth);
  if (truth) tally.count("several", found.size() > 1);
  if (found.empty() == truth) return "contacts, or none";
  if (!(rounding(c) < 1e285)) return {};  // where sums of coordinates overflow
  const bool is_convex = truth && isStrictlyConvex(c.a) && isStrictlyConvex(c.b);
  if (is_convex && found.size() != 1) return "how many there are";
  const Pairs pairs = Reference(c).meetingEdges();
  std::string problem = wrongContacts(random, c, found) + wrongEdges(c, found, !pairs.empty());
  if (problem.empty()) problem = wrongDetail(random, c, found, pairs);
  if (problem.empty() && is_convex) problem = wrongConvexContact(c, found[0]);
  if (problem.empty() && !is_convex && found.size() == 1 && random.oneIn(16)) problem = wrongWayApart(c, found[0]);
  if (problem.empty() && random.oneIn(8) && !isOneTwice(c)) problem = wrongSwapped(c, found);
  if (problem.empty() && random.oneIn(4))
    problem = wrongContactsWithMargin(c, random.unit() * std::max(c.a.radius(), c.b.radius()));
  return problem;
}

Case convexPair(Random& random) {
  const double size = random.coin() ? 0.2 : 1, reach = random.oneIn(4) ? 1e3 : 1;
  Case c{Polygon({anyConvex(random, 1, 12)}), randomPose(random, reach), Polygon({anyConvex(random, size, 12)}),
         randomPose(random, 1)};
  c.pose_b.translation() = c.pose_a.translation() + Vec2(random.real(-1.5, 1.5), random.real(-1.5, 1.5));
  if (random.oneIn(5)) c.pose_a = mirrored(c.pose_a);
  if (random.oneIn(5)) c.pose_b = throughFloat(c.pose_b);
  return c;
}

/// The depth and normal of convex pairs part them, and nothing less does.
std::string wrongConvex(Random& random, Tally& tally, Case& c) {
  const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b);
  tally.count("hits", !found.empty());
  if (found.empty()) return Reference(c).collide() ? "none" : "";
  tally.count("containments", found[0].edge_a < 0 || found[0].edge_b < 0);
  tally.count("of two points", found[0].count == 2);
  if (found.size() != 1) return "how many there are";
  const double depth = found[0].depth;
  Case before = c;
  before.pose_b.translation() += 0.99 * depth * found[0].normal;
  if (depth > 16 * rounding(c) && !Reference(before).collide()) return "less than the depth parts them";
  return wrongContacts(random, c, found) + wrongConvexContact(c, found[0]);
}

Laws contactsLaws() {
  Limits convex;
  convex.convex = true;
  Laws laws;
  add(laws, families(), 1500, wrong, {{"hits", 0.15, 0.85}});
  add(laws, anyPairs(), 500, wrong);
  add(laws, anyPairs(convex), 500, wrong, {{"hits", 0.02, 0.98}}, "both_");
  add(laws, {family("convex", convexPair)}, 4000, wrongConvex,
      {{"hits", 0.3, 0.98}, {"containments", 0.07, 0.9}, {"of two points", 0.05, 0.95}});
  return laws;
}

const Register registered("contacts", contactsLaws);

}  // namespace
}  // namespace tricover::laws
