// SPDX-License-Identifier: BSD-3-Clause
// contacts(): one for each connected part of the overlap, by hand.
#include <utility>

#include "contact_laws.h"
#include "contacts_by_hand.h"
#include "exact_reference.h"
#include "random.h"
#include "test_scale.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"
#include "tricover/polygon.h"

namespace tricover::support {
namespace {

TEST(Contacts, OfTwoSquares) {
  const auto found = ask({rectangle(0, 0, 4, 4)}, {rectangle(3, 1, 5, 3)});
  ASSERT_EQ(found.size(), 1u);
  expectContact(found[0], {3.5, 2}, {1, 0}, 1);
  EXPECT_EQ(found[0].edge_a, 1);
  EXPECT_EQ(found[0].edge_b, 3);
}

TEST(Contacts, AreNoneBetweenRegionsThatAreApart) {
  EXPECT_TRUE(ask({rectangle(0, 0, 4, 4)}, {rectangle(5, 1, 6, 3)}).empty());
  EXPECT_TRUE(ask({rectangle(0, 0, 9, 9), rectangle(1, 1, 8, 8)}, {rectangle(2, 2, 7, 7)}).empty());
}

TEST(Contacts, OfCornersThatOverlap) {
  const auto found = ask({rectangle(0, 0, 4, 4)}, {rectangle(3, 3.5, 6, 6)});
  ASSERT_EQ(found.size(), 1u);
  expectContact(found[0], {3.5, 3.75}, {0, 1}, 0.5);
}

TEST(Contacts, OfABarThroughASquareAreOne) {
  const auto found = ask({rectangle(-5, -5, 5, 5)}, {rectangle(-50, 1, 50, 3)});
  ASSERT_EQ(found.size(), 1u);
  expectContact(found[0], {0, 2}, {0, 1}, 4);  // to leave the square, not only where it is
}

TEST(Contacts, OfACombOverABarAreOneATooth) {
  constexpr int kTeeth = 7;
  // Teeth from 0 to 5, 1 wide, one every 3.
  const Polygon above({rectangle(-10, 4.75, 100, 9)}), teeth({comb(kTeeth, 3, 1, 5)});
  auto found = ask(above, kHere, teeth, kHere);
  ASSERT_EQ(found.size(), static_cast<std::size_t>(kTeeth));
  std::sort(found.begin(), found.end(), [](auto& p, auto& q) { return p.point.x() < q.point.x(); });
  for (std::size_t i = 0; i < found.size(); ++i)
    expectContact(found[i], {0.5 + 3.0 * static_cast<double>(i), 4.875}, {0, -1}, 0.25, 100);
}

TEST(Contacts, OfTeethThroughAThinBarPullThemOut) {
  const auto found = ask({rectangle(-10, 1, 100, 2)}, {comb(4, 3, 1, 5)});
  ASSERT_EQ(found.size(), 4u);
  for (const Contact& contact : found) {
    EXPECT_NEAR(contact.depth, 4, 1e-12);  // the other way the comb's back would be in the bar
    EXPECT_LE((contact.normal - Vec2(0, -1)).norm(), 1e-9);
    EXPECT_NEAR(contact.point.y(), 1.5, 1e-12);
  }
}

TEST(Contacts, AreAtMostAsManyAsAskedFor) {
  const Polygon above({rectangle(-10, 4.75, 100, 9)}), teeth({comb(7, 3, 1, 5)});
  EXPECT_EQ(contacts(above, kHere, teeth, kHere, {0, 3}).size(), 3u);
  EXPECT_EQ(contacts(above, kHere, teeth, kHere, {0, 0}).size(), 0u);
  EXPECT_EQ(contacts(above, kHere, teeth, kHere, {0, 100}).size(), 7u);
}

TEST(Contacts, WithAMarginAreOfWhatIsGrown) {
  const Polygon square({rectangle(-1, -1, 1, 1)}), far({rectangle(0x1p700, -1, 0x1p701, 1)});
  const auto beside = [&](double gap, double margin) {
    return contacts(square, kHere, square, turnedAndMoved(0, 2 + gap, 0.5), {margin});
  };
  ASSERT_EQ(beside(-0.25, 0.5).size(), 1u);
  EXPECT_EQ(beside(-0.25, 0.5)[0].depth, 0.75);
  ASSERT_EQ(beside(0, 0.5).size(), 1u);
  EXPECT_EQ(beside(0, 0.5)[0].depth, 0.5);
  EXPECT_EQ(beside(0.25, 0.5)[0].depth, 0.25);
  EXPECT_EQ(beside(0.25, 0.5)[0].normal, Vec2(1, 0));
  EXPECT_EQ(beside(0.25, 0.5)[0].point.x(), 1.125);
  // They touch exactly there, and not beyond.
  ASSERT_EQ(beside(0.5, 0.5).size(), 1u);
  EXPECT_EQ(beside(0.5, 0.5)[0].depth, 0);
  EXPECT_EQ(beside(0.5, 0.5)[0].normal, Vec2(1, 0));
  EXPECT_TRUE(beside(0.5, nudged(0.5, -1)).empty());
  EXPECT_TRUE(contacts(square, kHere, far, kHere, {0x1p699}).empty());
  ASSERT_EQ(contacts(square, kHere, far, kHere, {0x1p702}).size(), 1u);
  EXPECT_EQ(contacts(square, kHere, far, kHere, {0x1p702})[0].depth, 0x1.8p701);
  EXPECT_EQ(contacts(Polygon::point({0, 0}), kHere, Polygon::point({3, 4}), kHere, {6})[0].depth, 1);
  EXPECT_EQ(contacts(Polygon::point({0, 0}), kHere, Polygon::point({3, 4}), kHere, {6})[0].normal, Vec2(0.6, 0.8));
}

TEST(Contacts, OfTwoAnnuliAreTheirTwoLenses) {
  const Polygon annulus({regular(64, 2), regular(64, 1.5)});
  EXPECT_EQ(ask(annulus, kHere, annulus, turnedAndMoved(0.1, 2, 0)).size(), 2u);
  // Wide rings hang together around the holes.
  const Polygon wide({regular(64, 2), regular(64, 0.25)});
  EXPECT_EQ(ask(wide, kHere, wide, turnedAndMoved(0.1, 1, 0)).size(), 1u);
}

TEST(Contacts, HolesBelongToTheComponentAroundThem) {
  // Two holes of the one, one of the other, none of which meets an edge.
  const auto found = ask({rectangle(0, 0, 10, 10), rectangle(1, 1, 3, 3), rectangle(5, 1, 7, 3)},
                         {rectangle(0.5, 0.5, 11, 9.5), rectangle(1, 5, 3, 7)});
  EXPECT_EQ(found.size(), 1u);
  // A region with an island in its hole, under a square: two components, the hole's boundary belongs to the outer one.
  EXPECT_EQ(
      ask({rectangle(0, 0, 10, 10), rectangle(1, 1, 9, 9), rectangle(4, 4, 6, 6)}, {rectangle(-1, -1, 11, 11)}).size(),
      2u);
  EXPECT_EQ(
      ask({rectangle(0, 0, 10, 10), rectangle(1, 1, 9, 9), rectangle(4, 4, 6, 6)}, {rectangle(2, 2, 8, 8)}).size(), 1u);
}

TEST(Contacts, OfAContainmentLeadPastTheNearestEdge) {
  const auto found = ask({rectangle(0, 0, 10, 10)}, {rectangle(6, 4, 9, 5)});
  ASSERT_EQ(found.size(), 1u);
  expectContact(found[0], {7.5, 4.5}, {1, 0}, 4);
  EXPECT_EQ(found[0].edge_a, -1);
  EXPECT_EQ(found[0].edge_b, 3);
  // The same in a region that isn't convex.
  const auto beside_a_hole = ask({rectangle(0, 0, 20, 20), rectangle(10, 0.5, 19.5, 19)}, {rectangle(6, 4, 9, 5)});
  ASSERT_EQ(beside_a_hole.size(), 1u);
  expectContact(beside_a_hole[0], {7.5, 4.5}, {1, 0}, 4);
  EXPECT_EQ(beside_a_hole[0].edge_a, -1);
  EXPECT_EQ(beside_a_hole[0].edge_b, 3);
}

TEST(Contacts, OfARingAroundAHoleLeadOutwards) {
  // Every ring is part of the component but a's outermost.
  const auto found = ask({rectangle(0, 0, 20, 20), rectangle(9, 9, 11, 11)}, {rectangle(4, 5, 14, 15)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].depth, 14, 1e-12);
  EXPECT_LE((found[0].normal - Vec2(-1, 0)).norm(), 1e-9);
  EXPECT_EQ(found[0].edge_a, -1);
  EXPECT_EQ(found[0].edge_b, 1);
}

TEST(Contacts, OfALineThatEndsInsideAreSeparateFromWhatIsBesideItsCrossing) {
  const Ring corner = {{1, 0}, {8, 0}, {8, 6}, {12, 6}, {12, 7}, {1, 7}};
  const Ring hook = {{0, 7}, {5, 7}, {5, 9}, {0, 9}, {0, 10}, {1, 10}, {1, 3}, {0, 3}};
  EXPECT_EQ(ask({corner}, {hook, {{8, 6}, {8, 6}, {5, 6}}}).size(), 2u);
}

TEST(Contacts, HaveTheirPointsOnTheirOwnPart) {
  // A bent line, whose middle is on the side of a square that is a part of its own.
  const auto found = ask({rectangle(-9, -9, 5, 9)}, {{{0, 0}, {0, 4}, {4, 4}, {0, 4}}, rectangle(1, 1, 3, 3)});
  ASSERT_EQ(found.size(), 2u);
  expectContact(found[0], {0, 0}, {1, 0}, 5);
  expectContact(found[1], {2, 2}, {1, 0}, 4);
}

TEST(Contacts, OfIdenticalPolygonsAreWhatMovesThemApart) {
  const auto found = ask({rectangle(0, 0, 4, 2)}, {rectangle(0, 0, 4, 2)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].depth, 2, 1e-12);
  EXPECT_NEAR(std::abs(found[0].normal.y()), 1, 1e-12);
  const Ring corner = {{0, 0}, {10, 0}, {10, 1}, {1, 1}, {1, 10}, {0, 10}};
  const auto bent = ask({corner}, {corner});
  ASSERT_EQ(bent.size(), 1u);
  EXPECT_GT(bent[0].depth, 1);
}

/// Parts that hang together at a vertex of theirs, all of it within the other or across its border.
TEST(Contacts, OfPartsThatShareAVertexAreOne) {
  const std::vector<Ring> pinched = {{{0, 0}, {1, 2}, {-1, 2}}, {{0, 0}, {-1.5, -2}, {0.5, -2}}};
  EXPECT_EQ(ask(pinched, {rectangle(-3, -3, 3, 3)}).size(), 1u);
  EXPECT_EQ(ask(pinched, {rectangle(-3, -1, 3, 1)}).size(), 1u);
  EXPECT_EQ(ask({{{0, 0.25}, {1, 2}, {-1, 2}}, pinched[1]}, {rectangle(-3, -1, 3, 1)}).size(), 2u);
}

TEST(Contacts, OfABowTie) {
  const Ring bow_tie = {{-4, -4}, {4, 4}, {4, -4}, {-4, 4}};
  EXPECT_EQ(ask({bow_tie}, {rectangle(-5, -1, 5, 1)}).size(), 1u);  // joined where it crosses itself
  EXPECT_EQ(ask({bow_tie}, {rectangle(-5, 1, 5, 1.5)}).size(), 2u);
  EXPECT_EQ(ask({bow_tie}, {rectangle(-5, -5, 5, 5)}).size(), 1u);
  const auto touched = ask({bow_tie}, {{{0, 0}, {1, 3}, {-1, 3}}});  // in the crossing, from outside
  ASSERT_EQ(touched.size(), 1u);
  EXPECT_EQ(touched[0].depth, 0);
}

TEST(Contacts, OfRingsThatOverlapEvenOdd) {
  // The common part is outside: two parts that touch at the two points where the rings cross.
  const std::vector<Ring> rings = {rectangle(0, 0, 4, 4), rectangle(2, 2, 6, 6)};
  EXPECT_EQ(ask(rings, {rectangle(-1, -1, 7, 7)}).size(), 1u);
  EXPECT_EQ(ask(rings, {rectangle(2.5, 2.5, 3.5, 3.5)}).size(), 0u);
  EXPECT_EQ(ask(rings, {rectangle(1, 1, 5, 5)}).size(), 1u);  // joined at the crossings inside
  // Not so if those are outside.
  EXPECT_EQ(ask(rings, {{{1, 1}, {3, 1.5}, {5, 5}, {1.5, 3}}}).size(), 2u);
  // Two curves that cross twice, both their ends on b: only their crossings join what is above to what is below.
  const Ring cap = {{-9, -2}, {0, 2}, {9, -2}, {9, -9}, {-9, -9}}, cup = {{-9, 2}, {0, -2}, {9, 2}, {9, 9}, {-9, 9}};
  EXPECT_EQ(ask({cap, cup}, {rectangle(-6, -4, 6, 4)}).size(), 1u);
}

TEST(Contacts, CopeWithThousandsOfThem) {
  constexpr int kTeeth = 3000;
  const Polygon above({rectangle(-10, 4.5, 10000, 9)}), teeth({comb(kTeeth, 3, 1, 5)});
  EXPECT_EQ(ask(above, kHere, teeth, kHere).size(), static_cast<std::size_t>(kTeeth));
}

/// Holes in a row are found by rays along it: each to the next one only.
TEST(Contacts, OfARowOfHolesAreOne) {
  std::vector<Ring> rings = {rectangle(-1, -1, 2001, 2)};
  for (int i = 0; i < 1000; ++i) rings.push_back(rectangle(2 * i, 0, 2 * i + 1, 1));
  EXPECT_EQ(ask(rings, {rectangle(-0.5, -0.5, 2000.5, 1.5)}).size(), 1u);
}

/// Islands inside of islands, the larger polygon's inside of the smaller's: each leaves where it is nearest to the
/// edge.
TEST(Contacts, OfIslandsOfTheLargerPolygonInsideOfTheOthers) {
  const Polygon a({rectangle(-1, -1, 1, 1), rectangle(99, -1, 101, 1), rectangle(300, 0, 301, 1)});
  const Polygon b({rectangle(-5, -6, 1.5, 7), rectangle(94, -1.25, 106, 9)});
  for (const bool swapped : {false, true}) {
    const auto found = swapped ? contacts(b, turnedAndMoved(0, 0, 0), a, turnedAndMoved(0, 0, 0), globally())
                               : contacts(a, turnedAndMoved(0, 0, 0), b, turnedAndMoved(0, 0, 0), globally());
    ASSERT_EQ(found.size(), 2u);
    const double sign = swapped ? -1 : 1;
    EXPECT_EQ(found[0].depth, 2.5);
    EXPECT_EQ(found[0].normal, Vec2(-sign, 0));
    EXPECT_EQ(found[1].depth, 2.25);
    EXPECT_EQ(found[1].normal, Vec2(0, sign));
  }
}

/// The overlap is a triangle whose tip isn't above the middle of its base: the point is above the tip.
TEST(Contacts, AreBesideTheDeepestPointWhicheverPolygonHasIt) {
  const Ring floor = rectangle(-10, -5, 10, 0);
  for (const double size : {1.0, 20.0}) {  // the smaller polygon's and the larger one's
    const Ring tip = {{0, -1}, {0 + 2 * size, -1 + 2 * size}, {-6 * size, -1 + 2 * size}};
    const auto found = ask({tip}, {floor});
    ASSERT_EQ(found.size(), 1u);
    expectContact(found[0], {0, -0.5}, {0, -1}, 1);
    const auto other = ask({floor}, {tip});
    ASSERT_EQ(other.size(), 1u);
    expectContact(other[0], {0, -0.5}, {0, 1}, 1);
  }
}

/// As contacts.h says: a common point but for 2^-1042, of coordinates without a full fraction.
TEST(Contacts, OfDenormalCoordinates) {
  int overlaps = 0, all = 0;
  for (int i = 0; i < scaledCount(400); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const double size = std::pow(10, random.integer(-314, -308));
    const auto shape = [&] {
      const int corners = random.integer(3, 9);
      Ring ring = random.coin() ? anyConvex(random, 1) : star(random, corners, 0.3, 1);
      for (Vec2& p : ring) p *= size;
      return Polygon({ring});
    };
    const Polygon a = shape(), b = shape();
    const Pose there =
        turnedAndMoved(random.real(0, 6.28), size * random.real(-1.5, 1.5), size * random.real(-1.5, 1.5));
    for (const Contact& contact : contacts(a, kHere, b, there, globally())) {
      const Polygon at = Polygon::point(contact.point);
      const mpq_class off(0x1p-1042 * (1 + 1e-9));
      EXPECT_TRUE(exact::within(exact::distanceSquared(at, kHere, a, kHere), off)) << i;
      EXPECT_TRUE(exact::within(exact::distanceSquared(at, kHere, b, there), off)) << i;
      ++overlaps;
    }
    ++all;
  }
  EXPECT_GE(overlaps, all / 5);
}

/// Components with so many pieces in each other's way that their search ends early, each with what it may pass.
TEST(Contacts, HaveALocalDepthThatPassesAllOfAComponentWhoseSearchEndsEarly) {
  ContactOptions local;
  local.detail = ContactDetail::LocalDepth;
  const auto expectPassed = [&](const Polygon& a, const Polygon& b) {
    const std::vector<Contact> found = contacts(a, kHere, b, kHere, local);
    ASSERT_FALSE(found.empty());
    EXPECT_GT(found[0].depth, 0);
    EXPECT_EQ(wrongLocalDepths({a, kHere, b, kHere}, found), "");
  };
  // An edge of a's that bounds the component lies on one of b's.
  expectPassed(Polygon({{{6, 1}, {6, 3}, {5, 3}},
                        {{6, 2}, {6, 3}, {10, 3}},
                        {{8, 4}, {6, 1}, {8, 1}},
                        {{3, 5}, {10, 4}, {4, 4}, {4, 10}, {5, 1}, {3, 1}}},
                       FillRule::NonZero),
               Polygon({{{12, 6}, {12, 0}, {0, 0}, {0, 12}, {6, 12}}, {{3, 2}, {3, 8}, {0, 2}}}));
  // b is almost within a.
  expectPassed(
      Polygon({{{8.51, -.69},
                {7.75, -1.64},
                {5.75, .48},
                {6.94, 1.07},
                {7.37, 1.03},
                {8.37, .3},
                {8.38, .27},
                {8.4, .24},
                {8.41, .21},
                {8.44, .15},
                {8.46, .09}}}),
      Polygon({{{6.64, .24},  {6.64, .03},  {6.65, -.39}, {6.94, -.67}, {7.12, -.83}, {7.22, -.87}, {7.32, -.9},
                {7.41, -.88}, {7.88, -.79}, {8.07, -.75}, {8.15, -.65}, {8.23, -.56}, {8.27, -.51}, {8.31, -.47},
                {8.35, -.42}, {8.39, -.37}, {8.41, -.27}, {8.45, -.11}, {8.48, .06},  {8.44, .15},  {8.39, .24},
                {8.11, .81},  {7.37, 1},    {7, .79},     {6.78, .67},  {6.76, .64},  {6.74, .61}}}));
  // Rings across each other, of both.
  expectPassed(Polygon({{{0, .35}, {.3, -.2}, {-.1, -.35}}, {{-.15, .05}, {.15, .15}, {.2, -.05}}}, FillRule::NonZero),
               Polygon({{{-.35, -.7}, {.75, .2}, {-.75, .5}}, {{-.2, 0}, {.5, -.05}, {-.15, .15}}}, FillRule::NonZero));
  // Parts of b that share corners and a line.
  expectPassed(Polygon({{{-.915, .237}, {-.915, -.351}, {-.356, -.533}}, {{-.47, -.963}, {.53, -.219}, {-.47, -.219}}}),
               Polygon({{{-.262, -.415}, {-.379, -.415}, {-.379, -.532}, {-.262, -.532}},
                        {{-.379, -.415}, {-.496, -.415}, {-.379, -.532}},
                        {{-.262, -.532}, {-.379, -.532}, {-.262, -.648}},
                        {{-.379, -.532}, {-.46, -.612}, {-.379, -.612}}},
                       FillRule::NonZero));
}

/// A line without area in b, whose end is as near to a's border as coordinates are rounded.
TEST(Contacts, OfALineThatEndsBesideABorderAreOneWithWhatIsAroundIt) {
  const Ring square = rectangle(-3, -3, 3, 3);
  const Polygon a({square}), b({square, {{-1, 0}, {-1, 0}, {-2, 0}}}, FillRule::NonZero);
  Pose pose_a = kHere, pose_b = kHere;
  pose_a.matrix().topRows<2>() << -0x1.fade3d9f2e0bcp-1, 0x1.213d3119e9866p-3, -0x1.5e62aed083bd5p+2,
      -0x1.213d3119e9866p-3, -0x1.fade3d9f2e0bcp-1, 0x1.74bba634d4dap+0;
  pose_b.matrix().topRows<2>() << -0x1.fade3d9f2e0bcp-1, 0x1.213d3119e9866p-3, -0x1.326ddb947507bp+3,
      -0x1.213d3119e9866p-3, -0x1.fade3d9f2e0bcp-1, 0x1.e18c2c77771cbp+0;
  EXPECT_EQ(contacts(a, pose_a, b, pose_b, globally()).size(), 1u);
}

/// In a slot that leans: a touch, which no direction frees by a little, is left the way that is the shortest.
TEST(Contacts, OfAPlugThatFitsLeadTheShortestWayOut) {
  const Polygon slot({{{0, 0}, {20, 0}, {20, 10}, {14, 10}, {7, 3}, {3, 3}, {10, 10}, {0, 10}}}),
      plug({{{3, 3}, {7, 3}, {10, 6}, {6, 6}}});
  const std::vector<Contact> found = contacts(slot, kHere, plug, kHere, globally());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].depth, 0);
  EXPECT_NEAR(penetration(slot, kHere, plug, kHere)->normal.dot(found[0].normal), 1, 1e-12);
  EXPECT_NEAR(found[0].normal.y(), -1, 1e-12);
}

/// A line through a's inside and out of it: a ends at what is outside, not where it goes on within a.
TEST(Contacts, HaveALocalDepthThatPassesLinesWithinARegion) {
  const Polygon a({{{2, 2}, {1, 0}, {2, 2}}, {{3, 3}, {3, -1}, {0, 1}}}, FillRule::NonZero),
      b({{{3, 3}, {-3, 3}, {-3, -3}, {3, -3}},
         {{3, 3}, {-1, -1}, {1, -3}, {-1, -1}},
         {{2, 0}, {-1, -3}, {-3, -1}, {-1, -3}}},
        FillRule::NonZero);
  ContactOptions local;
  local.detail = ContactDetail::LocalDepth;
  for (const double turn : {0.0, 0.5}) {
    const Pose both = turnedAndMoved(turn, 4, -1);
    const std::vector<Contact> found = contacts(a, both, b, both, local);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(wrongLocalDepths({a, both, b, both}, found), "");
    EXPECT_GE(found[0].depth, 3 - 1e-12);
  }
}

/// From the deepest point a line of b without area leads towards the middle, and ends before it.
TEST(Contacts, HaveAPointThatIsNotBeyondTheEndOfALine) {
  const Polygon a({rectangle(-3, -3, 3, 3), {{2, -2}, {1, -3}, {2, -1}, {1, -3}}}),
      b({{{-1, 3}, {1, -3}, {3, -1}}, {{-2, -3}, {1, -1}, {-2, -3}, {-1, -2}}});
  for (const ContactDetail detail : {ContactDetail::LocalDepth, ContactDetail::GlobalDepth}) {
    ContactOptions options;
    options.detail = detail;
    for (const Contact& contact : contacts(a, kHere, b, kHere, options))
      EXPECT_LT(distance(b, kHere, Polygon::point(contact.point), kHere).distance, 1e-12);
  }
}

/// A ring of b that is one point, as high as the end of a line that is on a's border.
TEST(Contacts, OfAPointBesideTheEndOfALineOnABorderAreOneWithWhatIsAroundIt) {
  const Polygon a({{{-3, 3}, {3, 3}, {3, -3}, {-3, -3}}}),
      b({{{-3, -3}, {-3, 3}, {3, 3}, {3, -3}}, {{1, 1}, {1, 1}, {1, 1}}, {{0, -1}, {0, -1}, {0, 1}}},
        FillRule::NonZero);
  Pose pose_a = kHere, pose_b = kHere;
  pose_a.matrix().topRows<2>() << 0x1.9b195f6e398cdp-1, 0x1.3130e28256cb7p-1, 0x1.36c8e4ab4bcfep+3,
      -0x1.3130e28256cb7p-1, 0x1.9b195f6e398cdp-1, 0x1.2a1df2c31fddp-1;
  pose_b.matrix().topRows<2>() << 0x1.9b195f6e398cdp-1, 0x1.3130e28256cb7p-1, 0x1.871c0cecac581p+2,
      -0x1.3130e28256cb7p-1, 0x1.9b195f6e398cdp-1, 0x1.877ddb6db125ap-1;
  EXPECT_EQ(contacts(a, pose_a, b, pose_b, globally()).size(), 1u);
}

}  // namespace
}  // namespace tricover::support
