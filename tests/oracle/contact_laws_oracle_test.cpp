// SPDX-License-Identifier: BSD-3-Clause
// What the point, the normal, the depth and the edges of a contact promise, on exact numbers: in every family, of
// random outlines that overlap, and of outlines that touch in one point without any symmetry. A point is in both
// regions, always. The only part's normal and depth are those of penetration(), or part them where they only touch.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "contact_laws.h"
#include "families.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/contacts.h"
#include "tricover/penetration.h"

namespace tricover::support {
namespace {

/// How often a kind of contacts keeps to the laws.
struct Tally {
  void add(const Case& c, const Contact& contact, bool alone, bool convex, const char* name, int seed) {
    const bool common = isCommon(c, contact), parted = !alone || parts(c, contact), last = edgesPartLast(c, contact);
    ++contacts;
    alones += alone;
    not_parted += !parted;
    edges_apart += !last;
    std::string problem = !common ? "the point lies outside" : alone ? wrongWayApart(c, contact) : "";
    if (problem.empty() && convex && !parted) problem = "the normal doesn't part them";
    if (problem.empty() && convex && !last) problem = "other edges part last";
    if (!problem.empty() && ++wrong <= 3)
      ADD_FAILURE() << name << " seed " << seed << ": " << problem << "\n" << reproduction(c);
  }
  void print(const char* kind) const {
    std::printf("%-8s %6d contacts %6d alone %5d not parted %5d edges apart %5d wrong\n", kind, contacts, alones,
                not_parted, edges_apart, wrong);
  }

  /// No larger shares of them than these don't part by their normal, and name edges that don't part last. Of fewer
  /// cases than all, counts that are so small scatter: by three of their standard deviations, whatever the scale.
  void expectAtMost(double unparted, double apart) const {
    EXPECT_EQ(wrong, 0);
    const auto most = [&](double share) {
      const double count = share * contacts;
      return isScaledDown() ? count + 3 * std::sqrt(count) : count;
    };
    EXPECT_LE(not_parted, most(unparted));
    EXPECT_LE(edges_apart, most(apart));
  }

  int contacts = 0, alones = 0, not_parted = 0, edges_apart = 0, wrong = 0;
};

/// Of convex pairs, of touches, and of the rest.
struct Tallies {
  void add(const Case& c, const char* name, int seed) {
    const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b);
    const bool is_convex = isConvex(c.a) && isConvex(c.b);
    for (const Contact& contact : found) {
      Tally& tally = is_convex ? convex : contact.depth == 0 ? touches : others;
      tally.add(c, contact, found.size() == 1, is_convex, name, seed);
    }
  }
  void print() const {
    convex.print("convex");
    touches.print("touches");
    others.print("others");
  }

  Tally convex, touches, others;
};

// What is no law, kept from growing. Beyond the end of the shortest way into a notch or a hole they may meet again, if
// it has room only aside; and a wedged touch, as of two segments that cross, has no way out. Of several parts each
// contact knows the edges around its own: those named are then not always those that part last.
TEST(ContactLaws, HoldInAllFamilies) {
  Tallies tallies;
  for (const Family& family : families()) {
    for (int i = 0; i < scaledCount(600); ++i) {
      const Case c = family.make(static_cast<std::uint64_t>(i));
      // Sums of coordinates must not overflow here.
      if (rounding(c) < 1e290) tallies.add(c, family.name, i);
    }
  }
  tallies.print();
  tallies.convex.expectAtMost(0, 0);
  tallies.touches.expectAtMost(0.02, 0.002);
  tallies.others.expectAtMost(0.04, 0.02);
}

TEST(ContactLaws, HoldOfStars) {
  Tallies tallies;
  for (int i = 0; i < scaledCount(4000); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const auto anyStar = [&] { return Polygon({star(random, random.integer(4, 12), 0.5, 2)}); };
    Case c{anyStar(), randomPose(random, 3), anyStar(), randomPose(random, 0)};
    c.pose_b.translation() = c.pose_a.translation() + Vec2(random.real(-3, 3), random.real(-3, 3));
    tallies.add(c, "star", i);
  }
  tallies.print();
  tallies.convex.expectAtMost(0, 0);
  tallies.others.expectAtMost(0.001, 0.02);
}

/// A ring around the origin's upper half: the origin itself, or an edge through it, and corners above, from right to
/// left.
Ring fan(Random& random, bool with_edge) {
  Ring corners;
  for (int n = random.integer(2, 5); n > 0; --n) corners.emplace_back(random.integer(-6, 6), random.integer(1, 6));
  std::sort(corners.begin(), corners.end(), [](const Vec2& p, const Vec2& q) { return p.x() * q.y() > q.x() * p.y(); });
  const auto same = [](const Vec2& p, const Vec2& q) { return p.x() * q.y() == q.x() * p.y(); };
  corners.erase(std::unique(corners.begin(), corners.end(), same), corners.end());
  if (corners.size() < 2) corners.emplace_back(-7, 1);
  if (!with_edge) return corners.insert(corners.begin(), Vec2(0, 0)), corners;
  corners.insert(corners.begin(), Vec2(random.integer(1, 6), 0));
  corners.emplace_back(-random.integer(1, 6), 0);
  return corners;
}

TEST(ContactLaws, TouchesThatAreNotSymmetricHaveTheOneNormalThatParts) {
  int with_edges = 0, wrong = 0;
  const int cases = scaledCount(4000);
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    // One of them above a line and one below, exactly, whatever the pose that both have does to them.
    const Vec2 base(random.integer(-20, 20), random.integer(-20, 20)),
        along(random.integer(1, 7), random.integer(-7, 7));
    const Vec2 up(-along.y(), along.x());
    const int edge = random.integer(0, 2);  // neither's, a's or b's
    Ring below = fan(random, edge == 1), above = fan(random, edge == 2);
    for (Vec2& p : below) p = base - p.x() * along - p.y() * up;
    for (Vec2& p : above) p = base + p.x() * along + p.y() * up;
    const auto anyStart = [&](Ring& ring) {
      std::rotate(ring.begin(), ring.begin() + random.integer(0, static_cast<int>(ring.size()) - 1), ring.end());
      if (random.coin()) ring = reversed(ring);
    };
    anyStart(below);
    anyStart(above);
    Pose both = randomPose(random, 9);
    if (random.oneIn(3)) both.linear().setIdentity();
    if (random.oneIn(3)) both = mirrored(both);
    const Case c{Polygon({below}), both, Polygon({above}), both};
    const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b);
    with_edges += edge != 0;
    const std::string problem = [&]() -> std::string {
      if (found.size() != 1) return std::to_string(found.size()) + " contacts";
      const Contact& contact = found[0];
      if (contact.depth != 0) return "a depth";
      if ((contact.point - both * base).norm() > rounding(c)) return "another point";
      if (edge != 0 && (contact.normal - (both.linear() * up).normalized()).norm() > 1e-9) return "another normal";
      if (!parts(c, contact)) return "the normal doesn't part them";
      if (contact.edge_a < 0 || contact.edge_b < 0 || !edgesPartLast(c, contact)) return "other edges";
      return {};
    }();
    if (!problem.empty() && ++wrong <= 3) ADD_FAILURE() << "seed " << i << ": " << problem << "\n" << reproduction(c);
  }
  std::printf("%d cases, %d on an edge, %d wrong\n", cases, with_edges, wrong);
  EXPECT_EQ(wrong, 0);
  if (cases >= 100) {
    EXPECT_GE(with_edges, 0.5 * cases);
  }
}

TEST(ContactLaws, TheWayOutOfASliverPartsItByNoMoreThanCoordinatesAreOffBy) {
  const Polygon a({{{-0x1.0f6984a2f4936p-1, 0x1.74ba6ae98bf64p-1},
                    {0x1.4621e623c1b3p-1, 0x1.d48173ac94c1ep-1},
                    {-0x1.2baf0aff58084p-1, 0x1.bc8b71309f816p-1},
                    {-0x1.b7c0d66c81568p-2, 0x1.9082f5846856cp-1},
                    {-0x1.b332d4fc371dcp-1, 0x1.354d228e1197p-3},
                    {0x1.7fc94ce18abccp-1, -0x1.e6fbbf1686ca2p-1}}});
  const Pose pose_a =
      pose(-0x1.59febec9429f2p-1, -0x1.79669d3f646b8p-1, 0, 0x1.79669d3f646b8p-1, -0x1.59febec9429f2p-1, 0);
  const Polygon b({{{0x1.cba477ea68819p-35, 0},
                    {0x1.73dbca6851b96p-35, 0x1.d524c5fa6a734p-45},
                    {0x1.1c131ce63af14p-36, 0x1.7b8b9111e9afbp-44},
                    {-0x1.1c131ce63af12p-36, 0x1.7b8b9111e9afcp-44},
                    {-0x1.73dbca6851b95p-35, 0x1.d524c5fa6a736p-45},
                    {-0x1.7bcbfbe172957p-35, 0x1.aab81e82ccbd8p-45},
                    {-0x1.8d68ee525cff6p-35, 0x1.4c96f1f8c0092p-45},
                    {-0x1.a8fdc480dc0d1p-35, 0x1.725f67dbe3f4fp-46},
                    {-0x1.cb0aef1a267e7p-35, 0x1.9a4464cda8d74p-52},
                    {-0x1.cba477ea68819p-35, 0x1.b8353570a300fp-97},
                    {-0x1.b506500aa2e6cp-35, -0x1.e38151dab1c17p-47},
                    {-0x1.73dbca6851b97p-35, -0x1.d524c5fa6a732p-45},
                    {-0x1.1c131ce63af15p-36, -0x1.7b8b9111e9afbp-44},
                    {0x1.1c131ce63af1p-36, -0x1.7b8b9111e9afcp-44},
                    {0x1.73dbca6851b95p-35, -0x1.d524c5fa6a738p-45},
                    {0x1.88db2651d8575p-35, -0x1.64ed3b6d2f39bp-45}}});
  const Pose pose_b = pose(-0x1.a96c897495633p-1, 0x1.1ce21a17b05fcp-1, -0x1.1adda9a2d5655p+0, -0x1.1ce21a17b05fcp-1,
                           -0x1.a96c897495633p-1, -0x1.30d4097a83b53p-3);
  const Case c{a, pose_a, b, pose_b};
  const std::vector<Contact> found = contacts(a, pose_a, b, pose_b);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(wrongWayApart(c, found[0]), "");
}

}  // namespace
}  // namespace tricover::support
