// SPDX-License-Identifier: BSD-3-Clause
// crossings() against all pairs of edges, contacts() against collisions, components and translations, on exact numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <set>

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

Pairs pairsOf(const std::vector<Crossing>& crossings, bool swapped) {
  Pairs pairs;
  for (const Crossing& c : crossings) pairs.emplace_back(swapped ? c.edge_b : c.edge_a, swapped ? c.edge_a : c.edge_b);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

bool isEdge(const Polygon& polygon, std::ptrdiff_t edge) { return edge >= 0 && edge < polygon.edgeCount(); }

/// What is wrong with a pair's contacts whatever their number; empty if nothing is.
std::string wrongContacts(const Case& c, const std::vector<Contact>& found, bool crossed) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Contact& contact = found[i];
    if (!(std::abs(contact.normal.norm() - 1) <= 1e-12)) return "a normal that isn't unit";
    if (!(contact.depth >= 0 && std::isfinite(contact.depth))) return "a depth";
    if (!contact.point.allFinite()) return "a point";
    if (i > 0 && contact.depth > found[i - 1].depth) return "the order";
    const bool of_a = isEdge(c.a, contact.edge_a), of_b = isEdge(c.b, contact.edge_b);
    if (!of_a && !(contact.edge_a == -1 && of_b)) return "edge_a";
    if (!of_b && !(contact.edge_b == -1 && of_a)) return "edge_b";
    if (!crossed && of_a && of_b) return "an edge of what holds the other";
    if (crossed && found.size() == 1 && !(of_a && of_b)) return "no edge, where edges cross";
  }
  return {};
}

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
std::string wrongDetail(const Case& c, const std::vector<Contact>& found, const Pairs& pairs) {
  const std::vector<Contact> points = contactsOf(c, ContactDetail::Points),
                             local = contactsOf(c, ContactDetail::LocalDepth);
  if (points.size() != found.size() || local.size() != found.size()) return "how many there are by less detail";
  // Of convex polygons all is told.
  const std::string wrong_points = same(points, found) ? "" : wrongPoints(c, points, pairs);
  if (!wrong_points.empty()) return wrong_points;
  const std::string wrong = wrongContacts(c, local, !pairs.empty());
  if (!wrong.empty()) return wrong + ", local";
  const double error = 4 * rounding(c);
  if (local.size() != 1 || !(local[0].depth > 1e3 * error && std::isfinite(local[0].depth + 1e3 * error))) return {};
  // What crosses now doesn't when b has gone its way out of this part.
  Case moved = c;
  moved.pose_b.translation() += (local[0].depth * (1 + 1e-9) + error) * local[0].normal;
  const Pairs left = exact::meetingEdges(moved.a, moved.pose_a, moved.b, moved.pose_b);
  return std::find_first_of(pairs.begin(), pairs.end(), left.begin(), left.end()) == pairs.end()
             ? ""
             : "edges that still cross beyond the local depth";
}

std::string wrongWay(const Case& c, bool truth) {
  const Pairs pairs = exact::meetingEdges(c.a, c.pose_a, c.b, c.pose_b);
  if (pairsOf(crossings(c.a, c.pose_a, c.b, c.pose_b), false) != pairs) return "crossings";
  if (pairsOf(crossings(c.b, c.pose_b, c.a, c.pose_a), true) != pairs) return "crossings, swapped";
  const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b);
  if (found.empty() == truth) return "contacts";
  const std::vector<Contact> swapped = contacts(c.b, c.pose_b, c.a, c.pose_a);
  if (swapped.size() != found.size()) return "contacts, swapped";
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Contact &p = found[i], &q = swapped[i];
    if (p.point != q.point || p.normal != -q.normal || p.depth != q.depth || p.edge_a != q.edge_b ||
        p.edge_b != q.edge_a)
      return "a contact, swapped";
  }
  const std::string wrong = wrongContacts(c, found, !pairs.empty());
  return wrong.empty() ? wrongDetail(c, found, pairs) : wrong;
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
    const std::string wrong = wrongWay(c, truth);
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

/// By all faces of both against all vertices.
double depthBySeparatingAxes(const Case& c) {
  std::vector<Vec2> points[2];
  for (const Vec2& p : c.a.rings()[0]) points[0].push_back(c.pose_a * p);
  for (const Vec2& p : c.b.rings()[0]) points[1].push_back(c.pose_b * p);
  double least = std::numeric_limits<double>::infinity();
  for (const int side : {0, 1}) {
    const std::vector<Vec2>&of = points[side], &behind = points[1 - side];
    for (std::size_t i = 0; i < of.size(); ++i) {
      const Vec2 way = (of[(i + 1) % of.size()] - of[i]).normalized();
      for (const Vec2& normal : {Vec2(way.y(), -way.x()), Vec2(-way.y(), way.x())}) {
        double other = std::numeric_limits<double>::infinity(), own = -other;
        for (const Vec2& p : of) own = std::max(own, normal.dot(p));
        for (const Vec2& p : behind) other = std::min(other, normal.dot(p));
        least = std::min(least, own - other);
      }
    }
  }
  return least;
}

/// By how much a point is outside of a convex polygon, in plain doubles.
double outside(const Polygon& polygon, const Pose& pose, const Vec2& point) {
  const Ring& ring = polygon.rings()[0];
  double most = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 v = pose * ring[i], way = pose * ring[(i + 1) % ring.size()] - v;
    const Vec2 normal = Vec2(way.y(), -way.x()).normalized() * (pose.linear().determinant() < 0 ? -1 : 1);
    most = std::max(most, normal.dot(point - v));
  }
  return most;
}

TEST(ContactsOracleConvex, DepthAndNormalPartThemAndNothingLessDoes) {
  const int cases = scaledCount(4000);
  int hits = 0, contained = 0, wrong = 0;
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
    const auto collidesAfter = [&](double way) {
      Pose moved = c.pose_b;
      moved.translation() += way * found[0].normal;
      return exact::collide(c.a, c.pose_a, c.b, moved);
    };
    const double depth = found[0].depth, rounding = 1e-15 * (4 + 2 * reach);
    const bool right = found.size() == 1 && !collidesAfter(depth * (1 + 1e-9) + rounding) &&
                       (depth < 200 * rounding || collidesAfter(0.99 * depth)) &&
                       std::abs(depth - depthBySeparatingAxes(c)) <= 2 * rounding &&
                       outside(c.a, c.pose_a, found[0].point) <= 8 * rounding &&
                       outside(c.b, c.pose_b, found[0].point) <= 8 * rounding;
    if (!right && ++wrong <= 3)
      ADD_FAILURE() << "seed " << i << ": " << found.size() << " contacts, depth " << depth << ", by separating axes "
                    << depthBySeparatingAxes(c) << "\n"
                    << reproduction(c);
  }
  std::printf("%d cases, %d hits, %d of them containments, %d wrong\n", cases, hits, contained, wrong);
  EXPECT_EQ(wrong, 0);
  if (cases >= 100) {
    EXPECT_GE(hits, 0.3 * cases);
    EXPECT_GE(contained, 0.02 * cases);
  }
}

}  // namespace
}  // namespace tricover::support
