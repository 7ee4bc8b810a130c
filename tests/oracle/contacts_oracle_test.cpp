// SPDX-License-Identifier: BSD-3-Clause
// crossings() against all pairs of edges, contacts() against collisions, components and translations, on exact numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "contact_laws.h"
#include "exact_reference.h"
#include "families.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/contacts.h"

namespace tricover::support {
namespace {

using Pairs = std::vector<std::pair<std::ptrdiff_t, std::ptrdiff_t>>;

Pairs pairsOf(const std::vector<Crossing>& crossings) {
  Pairs pairs;
  for (const Crossing& c : crossings) pairs.emplace_back(c.edge_a, c.edge_b);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

bool isEdge(const Polygon& polygon, std::ptrdiff_t edge) { return edge >= 0 && edge < polygon.edgeCount(); }

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

std::string wrongWay(Random& random, const Case& c, bool truth) {
  const Pairs pairs = exact::meetingEdges(c.a, c.pose_a, c.b, c.pose_b);
  if (pairsOf(crossings(c.a, c.pose_a, c.b, c.pose_b)) != pairs) return "crossings";
  const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b);
  if (found.empty() == truth) return "contacts";
  if (!(rounding(c) < 1e285)) return {};  // where sums of coordinates overflow
  const std::string wrong = wrongContacts(random, c, found) + wrongEdges(c, found, !pairs.empty());
  return wrong.empty() ? wrongDetail(random, c, found, pairs) : wrong;
}

class ContactsOracle : public testing::TestWithParam<Family> {};

TEST_P(ContactsOracle, AgreesWithExactRationals) {
  const int cases = scaledCount(1500);
  int hits = 0, many = 0, disagreements = 0;
  for (int i = 0; i < cases; ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    const Case c = GetParam().make(seed);
    const bool truth = exact::collide(c.a, c.pose_a, c.b, c.pose_b);
    hits += truth;
    many += contacts(c.a, c.pose_a, c.b, c.pose_b).size() > 1;
    Random random(~seed);
    const std::string wrong = wrongWay(random, c, truth);
    if (!wrong.empty() && ++disagreements <= 3)
      ADD_FAILURE() << GetParam().name << " seed " << seed << ": " << wrong << "\n" << reproduction(c);
  }
  std::printf("%-22s %6d cases %6d hits %6d with several contacts\n", GetParam().name, cases, hits, many);
  EXPECT_EQ(disagreements, 0);
  if (cases >= 100) {
    EXPECT_GE(hits, 0.15 * cases);
    EXPECT_LE(hits, 0.85 * cases);
  }
}

INSTANTIATE_TEST_SUITE_P(Families, ContactsOracle, testing::ValuesIn(families()),
                         [](const auto& family) { return family.param.name; });

TEST(ContactsOracleConvex, DepthAndNormalPartThemAndNothingLessDoes) {
  const int cases = scaledCount(4000);
  int hits = 0, contained = 0, ends = 0, wrong = 0;
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const double size = random.coin() ? 0.2 : 1, reach = random.oneIn(4) ? 1e3 : 1;
    Case c{Polygon({anyConvex(random, 1, 12)}), randomPose(random, reach), Polygon({anyConvex(random, size, 12)}),
           randomPose(random, 1)};
    c.pose_b.translation() = c.pose_a.translation() + Vec2(random.real(-1.5, 1.5), random.real(-1.5, 1.5));
    if (random.oneIn(5)) c.pose_a = mirrored(c.pose_a);
    if (random.oneIn(5)) c.pose_b = throughFloat(c.pose_b);
    const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b);
    if (found.empty()) continue;
    ++hits;
    contained += found[0].edge_a < 0 || found[0].edge_b < 0;
    ends += found[0].count == 2;
    const double depth = found[0].depth, rounding = 1e-15 * (4 + 2 * reach);
    Case before = c;
    before.pose_b.translation() += 0.99 * depth * found[0].normal;
    const bool is_least = depth < 200 * rounding || exact::collide(before.a, before.pose_a, before.b, before.pose_b);
    const std::string problem = found.size() != 1 ? "how many there are"
                                : !is_least       ? "less than the depth parts them"
                                                  : wrongContacts(random, c, found) + wrongConvexContact(c, found[0]);
    if (!problem.empty() && ++wrong <= 3) ADD_FAILURE() << "seed " << i << ": " << problem << "\n" << reproduction(c);
  }
  std::printf("%d cases, %d hits, %d of them containments, %d wrong\n", cases, hits, contained, wrong);
  EXPECT_EQ(wrong, 0);
  if (cases >= 100) {
    EXPECT_GE(hits, 0.3 * cases);
    EXPECT_GE(contained, 0.02 * cases);
    EXPECT_GE(ends, 0.05 * hits);
    EXPECT_LE(ends, 0.95 * hits);
  }
}

}  // namespace
}  // namespace tricover::support
