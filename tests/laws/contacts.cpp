// SPDX-License-Identifier: BSD-3-Clause
// contacts() in every detail, by what contacts.h promises, on exact numbers; of convex pairs against the exact depth.
#include "tricover/contacts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
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
#include "tricover/distance.h"

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
  std::vector<Contact> swapped = contacts(c.b, c.pose_b, c.a, c.pose_a, globally());
  for (Contact& contact : swapped) contact.normal *= -1, std::swap(contact.edge_a, contact.edge_b);
  return same(found, swapped) ? "" : "swapped, they differ";
}

std::string wrong(Random& random, Tally& tally, Case& c) {
  const bool truth = Reference(c).collide();
  const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b, globally());
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
  const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b, globally());
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

/// Near a corner a translation by a few roundings may be free where a longer one along the same normal is not.
std::string wrongAlone(Random&, Tally& tally, Case& c) {
  const std::vector<Contact> found = contactsOf(c, ContactDetail::GlobalDepth);
  tally.count("alone", found.size() == 1);
  return found.size() == 1 ? wrongWayApart(c, found[0]) : "";
}

/// A point, some roundings inside of a corner that leads inwards: what parts them by a rounding more may end in a wall.
Case pointAtNotch(Random& random) {
  const auto real = [&](double low, double high) { return random.real(low, high); };
  const Vec2 notch(1e-6 * real(-1, 1), 1e-6 * real(1, 3)), at(real(-2, 2), real(-2, 2));
  const Polygon notched({{{-1e-5, -1e-5}, {1e-5, -1e-5}, {1e-5, 1e-5 * real(0.2, 2)}, notch, {-1e-5, 1e-5}}});
  const Pose pose_a = turnedAndMoved(real(-3, 3), 0, 0);
  Pose pose_b = turnedAndMoved(real(-3, 3), 0, 0);
  const Vec2 inwards(real(-4e-16, 4e-16), -5e-16);
  pose_b.translation() = pose_a * (notch + inwards) - pose_b * at;
  return {notched, pose_a, Polygon({Ring(3, at)}), pose_b};
}

/// A point at the outline of a tiny polygon at the frame's origin, itself far from its own: its translation is rounded
/// by more than all other coordinates.
Case farPointOnTinyPolygon(Random& random) {
  const double size = std::ldexp(1, -random.integer(8, 24));
  const int kind = random.integer(0, 2), n = random.integer(3, 12);
  const Polygon a({kind == 0   ? star(random, n, 0.3 * size, size)
                   : kind == 1 ? regular(n, size)
                               : comb(2, 0.5 * size, 0.25 * size, size)});
  const Pose pose_a = turnedAndMoved(random.real(0, 6.3), 0, 0);
  const double x = random.real(-3, 3), y = random.real(-3, 3);
  Pose pose_b = turnedAndMoved(random.real(0, 6.3), 0, 0);
  const EdgeIndex edge = random.integer(0, static_cast<int>(a.edgeCount()) - 1);
  const double share = random.coin() ? random.integer(0, 1) : random.unit();
  const Vec2 at = pose_a * Vec2(a.edgeStart(edge) + share * (a.edgeEnd(edge) - a.edgeStart(edge)));
  pose_b.translation() = nudged(random, at - pose_b.linear() * Vec2(x, y), random.integer(0, 2));
  return {a, pose_a, Polygon({Ring(3, Vec2(x, y))}), pose_b};
}

/// Where the way out led into a wall, and where steps of 4, and of 256 roundings are too few.
std::string wrongKeptPoints(Random& random, Tally& tally) {
  std::string wrong;
  for (const std::uint64_t seed : {347, 13387, 26429, 804234, 2412803, 3074748}) {
    Random of_seed(seed);
    Case c = seed == 347 ? pointAtNotch(of_seed) : farPointOnTinyPolygon(of_seed);
    if (wrong.empty()) wrong = wrongAlone(random, tally, c);
  }
  return wrong;
}

/// Two triangles that meet in a corner, in a wall. The chord through the deepest point leaves the lower one near the
/// corner that the upper one begins at.
Case trianglesInWall(Random& random) {
  const double size = 0x1p-42;
  const auto real = [&](double low, double high) { return size * random.real(low, high); };
  const Polygon two(
      {{{0, 0}, {real(-3, -1), 0}, {0, real(-3, -1)}}, {{0, 0}, {real(-3, -1), real(0.1, 2)}, {0, real(1, 3)}}});
  Pose pose_a = turnedAndMoved(random.real(0.1, 0.5), 0.498, 0.3097);
  pose_a.translate(Vec2(0, -1));
  return {Polygon({rectangle(-1, -1, 1, 1)}), pose_a, two, turnedAndMoved(0, 0.498, 0.3097 - 4 * size)};
}

std::string wrongOnTriangles(Random&, Tally& tally, Case& c) {
  const std::vector<Contact> found = contactsOf(c, ContactDetail::GlobalDepth);
  if (found.size() != 1) return "how many there are";
  tally.count("at the corner", found[0].point.y() > c.pose_b.translation().y() - 0x1p-50);
  const Polygon at({Ring(3, found[0].point)});
  return distance(at, Pose::Identity(), c.b, c.pose_b).distance <= 0x1p-50 ? "" : "the point is on neither";
}

Laws contactsLaws() {
  Limits convex;
  convex.convex = true;
  Laws laws = {{"kept_points", 1, wrongKeptPoints, {{"alone", 1, 1}}}};
  add(laws, {family("tiny_in_corner", tinyInCorner)}, 600, wrongAlone, {{"alone", 0.25, 1}});
  add(laws, {family("point_at_notch", pointAtNotch)}, 1000, wrongAlone, {{"alone", 0.5, 1}});
  add(laws, {family("far_point_on_tiny", farPointOnTinyPolygon)}, 2000, wrongAlone, {{"alone", 0.2, 1}});
  add(laws, {family("triangles_in_wall", trianglesInWall)}, 2000, wrongOnTriangles, {{"at the corner", 0.005, 0.5}});
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
