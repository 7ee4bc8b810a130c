// SPDX-License-Identifier: BSD-3-Clause
// The short way to the contact of two convex polygons: which pairs it answers, and that it answers them as the general
// way does.
#include "contact/convex_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "families.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"

namespace tricover::support {
namespace {

using namespace detail;

/// Vertices on an ellipse, up to 40 of them.
Ring convexRing(Random& random, double size) {
  const int n = random.integer(3, random.oneIn(4) ? 40 : 12);
  const double flat = random.oneIn(3) ? random.real(0.05, 1) : 1;
  Ring ring;
  for (int i = 0; i < n; ++i)
    ring.push_back(size * direction(2 * 3.14159265358979 * (i + random.real(0, 0.9)) / n).cwiseProduct(Vec2(1, flat)));
  return random.oneIn(6) ? rectangle(-size, -size * flat, size, size * flat) : random.coin() ? ring : reversed(ring);
}

/// Two of them, somewhere; and b led away from a until it only just meets it, then back by anything from far to a last
/// bit.
Case convexPair(Random& random) {
  const double size = random.real(0.3, 1);
  Case c{Polygon({convexRing(random, 1)}), randomPose(random, 2), Polygon({convexRing(random, size)}),
         randomPose(random, 2)};
  if (random.oneIn(3)) c.pose_b.linear() = c.pose_a.linear();
  if (random.oneIn(4)) c.pose_b = mirrored(c.pose_b);
  if (random.oneIn(8)) c.b = c.a;
  const Vec2 away = direction(random.oneIn(4) ? 0 : random.real(-4, 4));
  double near = contactOnWay(c, away, 4, 50).near;
  near -= random.oneIn(3) ? random.unit() : (random.coin() ? 1 : -1) * std::pow(10, random.real(-17, 0));
  c.pose_b.translation() = c.pose_a.translation() + near * away;
  return c;
}

/// The same region, of which the short way knows nothing: its first vertex is there twice.
Polygon withRepetition(const Polygon& polygon) {
  Ring ring = polygon.rings()[0];
  ring.push_back(ring.front());
  return Polygon({ring});
}

/// What they differ in by more than rounding; empty if in nothing.
std::string difference(const Contact& p, const Contact& q) {
  constexpr double kRounding = 1e-14;
  if (std::abs(p.depth - q.depth) > kRounding) return "depth";
  if ((p.normal - q.normal).norm() > kRounding / p.depth + 1e-12) return "normal";
  return (p.point - q.point).norm() > 1e-13 + 1e-14 / p.depth ? "point" : "";
}

TEST(ConvexContact, IsThatOfTheGeneralWay) {
  int overlaps = 0, aparts = 0, unsure = 0, missed = 0, wrong = 0;
  const int cases = scaledCount(4000);
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Case c = convexPair(random);
    const PosedPair pair(c.a.data(), c.pose_a, c.b.data(), c.pose_b);
    const ConvexContact found = convexContact(pair, nullptr);
    const auto general = contacts(withRepetition(c.a), c.pose_a, withRepetition(c.b), c.pose_b);
    (found.verdict == ConvexContact::Overlap ? overlaps : found.verdict == ConvexContact::Apart ? aparts : unsure)++;
    missed += found.verdict == ConvexContact::Unsure && !general.empty() && general[0].depth > 1e-9;
    std::string problem;
    if (found.verdict == ConvexContact::Apart && !general.empty()) problem = "apart";
    if (found.verdict == ConvexContact::Overlap)
      problem = general.size() == 1 ? difference(found.contact, general[0]) : "overlap";
    if (!problem.empty() && ++wrong <= 3) ADD_FAILURE() << "seed " << i << ": " << problem << "\n" << reproduction(c);
  }
  std::printf("%d cases, %d overlap, %d apart, %d unsure, %d of them deep\n", cases, overlaps, aparts, unsure, missed);
  EXPECT_EQ(wrong, 0);
  if (cases >= 100) {
    EXPECT_GE(overlaps, 0.4 * cases);
    EXPECT_LE(missed, 0.2 * overlaps);  // the rest of the unsure ones touch
    EXPECT_GE(aparts, 0.1 * cases);
    EXPECT_GE(unsure, 0.05 * cases);
  }
}

/// Of the edges at the deepest vertex the one that is more across the normal, whichever way round the ring runs.
TEST(ConvexContact, NamesTheFlatterEdgeAtAVertex) {
  const Polygon box({rectangle(0, 0, 4, 4)});
  const Pose here = Pose::Identity();
  for (const auto& [ring, edge] : {std::pair(Ring{{1, 3.6}, {3, 3.5}, {3, 6}, {1, 6}}, 0),
                                   {Ring{{1, 3.5}, {3, 3.6}, {3, 6}, {1, 6}}, 0},
                                   {Ring{{1, 6}, {3, 6}, {3, 3.5}, {1, 3.6}}, 2}}) {
    const Polygon leaning({ring});
    const ConvexContact found = convexContact(PosedPair(box.data(), here, leaning.data(), here), nullptr);
    ASSERT_EQ(found.verdict, ConvexContact::Overlap);
    EXPECT_EQ(found.contact.normal, Vec2(0, 1));
    EXPECT_NEAR(found.contact.depth, 0.5, 1e-15);
    EXPECT_EQ(found.contact.edge_a, 2);
    EXPECT_EQ(found.contact.edge_b, edge);
  }
}

}  // namespace
}  // namespace tricover::support
