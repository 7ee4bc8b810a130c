// SPDX-License-Identifier: BSD-3-Clause
// Margins of contacts(), crossings() and penetration(), against exact distances and by the laws of Minkowski sums.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "contact_laws.h"
#include "exact_reference.h"
#include "families.h"
#include "penetration_laws.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"

namespace tricover::support {
namespace {

bool areWithin(const Case& c, const Vec2& way, double margin) {
  Pose moved = c.pose_b;
  moved.translation() += way;
  return exact::within(exact::distanceSquared(c.a, c.pose_a, c.b, moved), margin);
}

std::vector<std::pair<EdgeIndex, EdgeIndex>> nearEdges(const Case& c, double margin) {
  const std::vector<bool> named_a = exact::edgesOfCrossings(c.a), named_b = exact::edgesOfCrossings(c.b);
  const auto edgeOf = [](const Polygon& polygon, EdgeIndex edge) {
    return Polygon({{polygon.edgeStart(edge), polygon.edgeEnd(edge), polygon.edgeStart(edge)}});
  };
  std::vector<std::pair<EdgeIndex, EdgeIndex>> pairs;
  for (EdgeIndex i = 0; i < static_cast<EdgeIndex>(c.a.vertexCount()); ++i)
    for (EdgeIndex j = 0; j < static_cast<EdgeIndex>(c.b.vertexCount()); ++j)
      if (named_a[static_cast<std::size_t>(i)] && named_b[static_cast<std::size_t>(j)] &&
          areWithin({edgeOf(c.a, i), c.pose_a, edgeOf(c.b, j), c.pose_b}, Vec2::Zero(), margin))
        pairs.emplace_back(i, j);
  return pairs;
}

std::string wrongCrossings(const Case& c, double margin) {
  std::vector<std::pair<EdgeIndex, EdgeIndex>> found;
  for (const Crossing& crossing : crossings(c.a, c.pose_a, c.b, c.pose_b, {margin}))
    found.emplace_back(crossing.edge_a, crossing.edge_b);
  std::sort(found.begin(), found.end());
  return found == nearEdges(c, margin) ? "" : "pairs of edges";
}

TEST(ContactMargins, AgreeWithExactDistancesInAllFamilies) {
  int cases = 0, hits = 0, beside = 0, wrong = 0;
  for (const Family& family : families())
    for (int i = 0; i < scaledCount(12); ++i) {
      Random random(static_cast<std::uint64_t>(i) * 977 + 5);
      const Case c = family.make(static_cast<std::uint64_t>(i));
      const double apart = distance(c.a, c.pose_a, c.b, c.pose_b).distance;
      const double size = std::min(std::max(c.a.radius(), c.b.radius()), 1e140);
      const double margin = random.oneIn(3) && apart > 0 ? apart : random.unit() * size;
      if (!(margin < 1e150)) continue;
      const bool truth = areWithin(c, Vec2::Zero(), margin);
      ++cases, hits += truth, beside += truth && apart > 0;
      std::string problem = rounding(c) < 1e285 ? wrongContactsWithMargin(c, margin) : "";
      if (problem.empty() && c.a.vertexCount() * c.b.vertexCount() < 2000)
        problem = wrongPenetration(random, c, margin, penetration(c.a, c.pose_a, c.b, c.pose_b, {margin}), 2);
      if (problem.empty() && c.a.vertexCount() * c.b.vertexCount() < 200) problem = wrongCrossings(c, margin);
      if (!problem.empty() && ++wrong <= 5)
        ADD_FAILURE() << family.name << " " << i << ", margin " << hex(margin) << ": " << problem << "\n"
                      << reproduction(c);
    }
  std::printf("%d cases, %d within the margin, %d of them apart\n", cases, hits, beside);
  EXPECT_EQ(wrong, 0);
}

/// The polygon of one ring, grown by a regular polygon with its corners on a circle.
Polygon grown(const Polygon& polygon, double radius, int corners) {
  std::vector<Ring> rings = polygon.rings();
  double area = 0;
  for (std::size_t i = 0; i < polygon.vertexCount(); ++i) {
    const Vec2 p = polygon.edgeStart(static_cast<EdgeIndex>(i)), q = polygon.edgeEnd(static_cast<EdgeIndex>(i));
    area += p.x() * q.y() - p.y() * q.x();
  }
  if (area < 0) rings[0] = reversed(rings[0]);
  const Ring round = regular(corners, radius);
  for (std::size_t i = 0; i < polygon.vertexCount(); ++i) {
    const Vec2 p = polygon.edgeStart(static_cast<EdgeIndex>(i)), way = polygon.edgeEnd(static_cast<EdgeIndex>(i)) - p;
    // From the support vertex to one side of the edge round the start to that on the other, and likewise.
    Ring ring;
    const auto isBehind = [&](const Vec2& r) { return r.dot(way) < 0; };
    const auto first = std::find_if(round.begin(), round.end(), isBehind);
    std::size_t k = static_cast<std::size_t>(first - round.begin());
    while (isBehind(round[(k + round.size() - 1) % round.size()])) k = (k + round.size() - 1) % round.size();
    for (std::size_t j = 0; j < round.size(); ++j) {
      const Vec2 &r = round[(k + j) % round.size()], &next = round[(k + j + 1) % round.size()];
      const auto at = [&](const Vec2& corner, bool behind) {
        ring.push_back(behind ? Vec2(p + corner) : Vec2(p + way + corner));
      };
      at(r, isBehind(r));
      if (isBehind(r) == isBehind(next)) continue;
      // The corner that is farthest aside is one at both ends.
      const auto aside = [&](const Vec2& corner) { return std::abs(way.x() * corner.y() - way.y() * corner.x()); };
      if (aside(r) > aside(next))
        at(r, !isBehind(r));
      else
        at(next, isBehind(r));
    }
    rings.push_back(ring);
  }
  return Polygon(rings, FillRule::NonZero);
}

TEST(ContactMargins, PenetrationIsBetweenThatOfPolygonsGrownByLessAndByMore) {
  constexpr int kCorners = 48;
  int deep = 0, beside = 0, optimal = 0;
  for (int i = 0; i < scaledCount(60); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Polygon a({star(random, random.integer(4, 9), 0.3, 1)}), b({star(random, random.integer(3, 7), 0.2, 0.8)});
    const Pose pose_a = randomPose(random, 3);
    Pose pose_b = randomPose(random, 0);
    pose_b.translation() = pose_a.translation() + random.real(0, 1.6) * direction(random.real(0, 6.3));
    const double margin = std::exp2(random.real(-8, 0));
    const auto p = penetration(a, pose_a, b, pose_b, {margin});
    const auto less = penetration(a, pose_a, grown(b, margin, kCorners), pose_b);
    const auto more =
        penetration(a, pose_a, grown(b, margin / std::cos(3.14159265358979 / kCorners), kCorners), pose_b);
    EXPECT_LE((less ? less->lower_bound : 0), (p ? p->depth : 0) + 1e-9) << i;
    EXPECT_LE((p ? p->lower_bound : 0), (more ? more->depth : 0) + 1e-9) << i;
    if (!p) continue;
    const bool overlap = exact::collide(a, pose_a, b, pose_b);
    ++(overlap ? deep : beside);
    optimal += p->optimal;
    if (p->optimal && more) {
      EXPECT_LE(p->depth, more->depth + 1e-9) << i;
    }
  }
  std::printf("%d overlap, %d are beside each other; %d are optimal\n", deep, beside, optimal);
  EXPECT_GE(2 * optimal, deep + beside);
}

TEST(ContactMargins, OfConvexPolygonsAddToTheDepthOrTakeTheDistance) {
  for (int i = 0; i < scaledCount(2000); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const double scale = std::exp2(random.real(-300, 300));
    const Polygon a({anyConvex(random, scale)}), b({anyConvex(random, scale)});
    const Pose pose_a = randomPose(random, 3 * scale);
    Pose pose_b = randomPose(random, 0);
    pose_b.translation() = pose_a.translation() + random.real(0, 2.5) * scale * direction(random.real(0, 6.3));
    const double margin = random.real(0, 1) * scale, apart = distance(a, pose_a, b, pose_b).distance;
    const auto bare = penetration(a, pose_a, b, pose_b), p = penetration(a, pose_a, b, pose_b, {margin});
    const auto found = contacts(a, pose_a, b, pose_b, ContactOptions{margin});
    ASSERT_EQ(p.has_value(), bare || apart <= margin);
    ASSERT_EQ(found.size(), p ? 1u : 0u);
    if (!p) continue;
    const double truth = bare ? bare->depth + margin : margin - apart;
    EXPECT_NEAR(p->depth / scale, truth / scale, 1e-14) << i;
    EXPECT_NEAR(found[0].depth / scale, truth / scale, 1e-13) << i;
    if (p->depth > 1e-6 * scale) {
      EXPECT_LE((p->normal - found[0].normal).norm(), 1e-6) << i;
    }
    EXPECT_TRUE(p->optimal);
  }
}

}  // namespace
}  // namespace tricover::support
