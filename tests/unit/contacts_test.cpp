// SPDX-License-Identifier: BSD-3-Clause
// contacts(): one for each connected part of the overlap, by hand.
#include "tricover/contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "shapes.h"
#include "tricover/collide.h"

namespace tricover::support {
namespace {

const Pose kHere = Pose::Identity();

bool alike(const Contact& p, const Contact& q, double size) {
  return std::abs(p.depth - q.depth) <= 1e-12 * size && ((p.point - q.point) / size).norm() <= 1e-12 &&
         (p.normal - q.normal).norm() <= 1e-9 && p.edge_a == q.edge_a && p.edge_b == q.edge_b;
}

/// Asks in both orders, and looks at what holds for all contacts.
std::vector<Contact> ask(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  const std::vector<Contact> found = contacts(a, pose_a, b, pose_b);
  std::vector<Contact> swapped = contacts(b, pose_b, a, pose_a);
  EXPECT_EQ(found.empty(), !collide(a, pose_a, b, pose_b));
  EXPECT_EQ(found.size(), swapped.size());
  const double size = 2 * a.radius() + 2 * b.radius();
  for (std::size_t i = 0; i < std::min(found.size(), swapped.size()); ++i) {
    std::swap(swapped[i].edge_a, swapped[i].edge_b);
    swapped[i].normal = -swapped[i].normal;
    EXPECT_TRUE(a.id() == b.id() || alike(found[i], swapped[i], size)) << i;
    EXPECT_NEAR(found[i].normal.norm(), 1, 1e-12);
    EXPECT_GE(found[i].depth, 0);
    EXPECT_TRUE(i == 0 || found[i].depth <= found[i - 1].depth);
    EXPECT_TRUE(found[i].edge_a >= 0 || found[i].edge_b >= 0);
    EXPECT_LT(found[i].edge_a, static_cast<std::ptrdiff_t>(a.vertexCount()));
    EXPECT_LT(found[i].edge_b, static_cast<std::ptrdiff_t>(b.vertexCount()));
  }
  return found;
}

std::vector<Contact> ask(const std::vector<Ring>& a, const std::vector<Ring>& b) {
  return ask(Polygon(a), kHere, Polygon(b), kHere);
}

void expectContact(const Contact& contact, const Vec2& point, const Vec2& normal, double depth, double size = 1) {
  EXPECT_LE(((contact.point - point) / size).norm(), 1e-12) << contact.point.transpose();
  EXPECT_LE((contact.normal - normal).norm(), 1e-9) << contact.normal.transpose();
  EXPECT_NEAR(contact.depth, depth, 1e-12 * size);
}

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
    EXPECT_NEAR(contact.depth, 2, 1e-12);  // the other way it would be 4
    EXPECT_LE((contact.normal - Vec2(0, 1)).norm(), 1e-9);
    EXPECT_NEAR(contact.point.y(), 1.5, 1e-12);
  }
}

TEST(Contacts, AreAtMostAsManyAsAskedFor) {
  const Polygon above({rectangle(-10, 4.75, 100, 9)}), teeth({comb(7, 3, 1, 5)});
  EXPECT_EQ(contacts(above, kHere, teeth, kHere, 3).size(), 3u);
  EXPECT_EQ(contacts(above, kHere, teeth, kHere, 0).size(), 0u);
  EXPECT_EQ(contacts(above, kHere, teeth, kHere, 100).size(), 7u);
}

TEST(Contacts, OfTwoAnnuliAreTheirTwoLenses) {
  const Polygon annulus({regular(64, 2), regular(64, 1.5)});
  EXPECT_EQ(ask(annulus, kHere, annulus, pose(0.1, 2, 0)).size(), 2u);
  // Wide rings hang together around the holes.
  const Polygon wide({regular(64, 2), regular(64, 0.25)});
  EXPECT_EQ(ask(wide, kHere, wide, pose(0.1, 1, 0)).size(), 1u);
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

TEST(Contacts, ThatAreShallowHaveTheEdgesNormalAllTheSame) {
  const double cosine = std::cos(0.3), sine = std::sin(0.3);
  for (const double depth : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const Pose turned = pose(0.3, 7, 5);
    const auto found =
        ask(Polygon({rectangle(0, 0, 4, 4)}), turned, Polygon({{{4 - depth, 2}, {6, 1}, {5, 2}, {6, 3}}}), turned);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_LE((found[0].normal - Vec2(cosine, sine)).norm(), 1e-12) << depth;
    EXPECT_NEAR(found[0].depth, depth, 1e-14);
    EXPECT_EQ(found[0].edge_a, 1);
  }
}

TEST(Contacts, WhereAVertexTouchesAnEdge) {
  const auto found = ask({rectangle(0, 0, 4, 4)}, {{{4, 2}, {6, 1}, {6, 3}}});
  ASSERT_EQ(found.size(), 1u);
  expectContact(found[0], {4, 2}, {1, 0}, 0);
  EXPECT_EQ(found[0].depth, 0);
  EXPECT_EQ(found[0].edge_a, 1);
  // A notch keeps b from being convex.
  const auto notched = ask({rectangle(0, 0, 4, 4)}, {{{4, 2}, {6, 1}, {5, 2}, {6, 3}}});
  ASSERT_EQ(notched.size(), 1u);
  expectContact(notched[0], {4, 2}, {1, 0}, 0);
  EXPECT_EQ(notched[0].depth, 0);
  EXPECT_EQ(notched[0].edge_a, 1);
}

/// a's vertex touches b's edge, and a's edges there lean to one side: those of the other normal would run into b.
TEST(Contacts, WhereAVertexThatLeansTouchesAnEdge) {
  const auto found = ask({{{4, 2}, {-6, 6}, {-4, 2}, {-6, -2}}}, {rectangle(4, 1.5, 5, 8)});
  ASSERT_EQ(found.size(), 1u);
  expectContact(found[0], {4, 2}, {1, 0}, 0);
  EXPECT_EQ(found[0].depth, 0);
  EXPECT_EQ(found[0].edge_b, 3);
}

/// Both ways out of a corner are as long; b's origin is above a's rather than beside it.
TEST(Contacts, AtAVertexThatIsRepeatedNameTheFlatterEdge) {
  const Ring box = rectangle(0, 0, 4, 4), leaning{{1, 3.6}, {3, 3.5}, {3, 3.5}, {3, 6}, {1, 6}};
  const std::vector<Contact> found = ask({box}, {leaning});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].normal, Vec2(0, 1));
  EXPECT_EQ(found[0].edge_a, 2);
  EXPECT_EQ(found[0].edge_b, 0);
}

TEST(Contacts, OfEquallyDeepWaysTakeTheOneAwayFromTheOther) {
  const auto found = ask({rectangle(-2, -4, 2, 4)}, {rectangle(1.5, 3.5, 4, 6)});
  ASSERT_EQ(found.size(), 1u);
  expectContact(found[0], {1.75, 3.75}, {0, 1}, 0.5);
}

TEST(Contacts, WhereVerticesTouch) {
  for (const Ring& b : {Ring{{4, 4}, {6, 5}, {5, 6}}, Ring{{4, 4}, {6, 5}, {5, 5}, {5, 6}}}) {
    const auto found = ask({rectangle(0, 0, 4, 4)}, {b});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].depth, 0);
    EXPECT_LE((found[0].point - Vec2(4, 4)).norm(), 1e-12);
    EXPECT_GT(found[0].normal.x() + found[0].normal.y(), 0.7);
  }
}

TEST(Contacts, WhereEdgesTouchAlongAStretch) {
  const auto found = ask({rectangle(0, 0, 4, 4)}, {rectangle(4, 1, 6, 9)});
  ASSERT_EQ(found.size(), 1u);
  expectContact(found[0], {4, 2.5}, {1, 0}, 0);
  EXPECT_EQ(found[0].depth, 0);
  EXPECT_EQ(found[0].edge_a, 1);
  EXPECT_EQ(found[0].edge_b, 3);
}

TEST(Contacts, OfABoxInACornerThatItTouchesLeadOutOfTheCorner) {
  const Ring corner = {{0, 0}, {10, 0}, {10, 1}, {1, 1}, {1, 10}, {0, 10}};
  const auto found = ask({corner}, {rectangle(1, 1, 3, 3)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].depth, 0);
  EXPECT_LE((found[0].normal - Vec2(1, 1).normalized()).norm(), 1e-9);
}

TEST(Contacts, OfAPegInAHoleThatFitsIsOne) {
  const auto found = ask({rectangle(0, 0, 9, 9), rectangle(3, 3, 6, 6)}, {rectangle(3, 3, 6, 6)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].depth, 0);
}

/// They were joined across the gap, because only the middle of a common stretch was known, not its end.
TEST(Contacts, OfRingsWithoutAreaOnOneEdgeAreSeparate) {
  EXPECT_EQ(ask({rectangle(-3, -3, 3, 3)}, {{{1, -3}, {2, -3}, {2, -3}}, {{-2, -3}, {-1, -3}, {-1, -3}}}).size(), 2u);
  EXPECT_EQ(ask({{{3, 2}, {3, 3}, {1, 3}}}, {{{-3, 1}, {1, 3}, {1, 2}}, {{2, 3}, {3, 3}, {3, 3}}}).size(), 2u);
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

/// Which way round rings run says nothing.
TEST(Contacts, OfRingsThatRunClockwiseAreTheSame) {
  const Ring box = rectangle(0, 0, 2, 2), corner{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
  const Ring beside = rectangle(1, 1, 2, 4);
  for (const auto& [first, second] :
       {std::pair(box, box), std::pair(corner, beside), std::pair(box, rectangle(2, 1, 5, 3))}) {
    const std::vector<Contact> expected = ask({first}, {second});
    ASSERT_EQ(expected.size(), 1u);
    for (const int reversed : {1, 2, 3}) {
      Ring a = first, b = second;
      if (reversed & 1) std::reverse(a.begin(), a.end());
      if (reversed & 2) std::reverse(b.begin(), b.end());
      const std::vector<Contact> found = ask({a}, {b});
      ASSERT_EQ(found.size(), 1u);
      EXPECT_EQ(found[0].depth, expected[0].depth);
      EXPECT_EQ(found[0].normal, expected[0].normal);
    }
  }
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

TEST(Contacts, OfMirroredPolygons) {
  const Polygon a({rectangle(0, 0, 4, 4)}), b({rectangle(0, 0, 2, 2)});
  Pose flipped = kHere;
  flipped.linear() << -1, 0, 0, 1;
  const auto found = ask(a, kHere, b, Pose(pose(0, 5, 1) * flipped));  // x from 3 to 5
  ASSERT_EQ(found.size(), 1u);
  expectContact(found[0], {3.5, 2}, {1, 0}, 1);
  const auto both = ask(a, flipped, b, Pose(pose(0, -3, 1) * flipped));  // x from -5 to -3
  ASSERT_EQ(both.size(), 1u);
  expectContact(both[0], {-3.5, 2}, {-1, 0}, 1);
}

TEST(Contacts, AtEveryScale) {
  for (const double s : {1e-300, 1e-100, 1.0, 1e100, 1e300}) {
    const auto overlap = ask({scaled(rectangle(0, 0, 4, 4), s)}, {scaled(rectangle(3, 1, 5, 3), s)});
    ASSERT_EQ(overlap.size(), 1u) << s;
    expectContact(overlap[0], Vec2(3.5, 2) * s, {1, 0}, s, s);
    const auto touch = ask({scaled(rectangle(0, 0, 4, 4), s)}, {scaled({{4, 2}, {6, 1}, {5, 2}, {6, 3}}, s)});
    ASSERT_EQ(touch.size(), 1u) << s;
    expectContact(touch[0], Vec2(4, 2) * s, {1, 0}, 0, s);
    EXPECT_EQ(touch[0].depth, 0);
    const auto bent =
        ask({scaled({{0, 0}, {10, 0}, {10, 1}, {1, 1}, {1, 10}, {0, 10}}, s)}, {scaled(rectangle(4, 0.5, 6, 6), s)});
    ASSERT_EQ(bent.size(), 1u) << s;
    expectContact(bent[0], Vec2(5, 0.75) * s, {0, 1}, 0.5 * s, s);
  }
}

TEST(Contacts, OfAHugeAndATinyPolygonAreWhereTheTinyOneIs) {
  const auto found = ask({rectangle(-1e300, -1e300, 1e300, 0)}, {scaled(rectangle(-1, -1, 1, 2), 1e-300)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LE(found[0].point.norm(), 1e-290);
  const auto less = ask({rectangle(-1e9, -1e9, 1e9, 0)}, {scaled(rectangle(-1, -1, 1, 2), 1e-3)});
  ASSERT_EQ(less.size(), 1u);
  EXPECT_LE((less[0].point - Vec2(0, -0.5e-3)).norm(), 1e-6);
  EXPECT_LE((less[0].normal - Vec2(0, 1)).norm(), 1e-9);
}

TEST(Contacts, FarAway) {
  const Polygon a({rectangle(0, 0, 4, 4)}), b({rectangle(0, 0, 2, 2)});
  const auto found = ask(a, pose(0, 1e15, -1e15), b, pose(0, 1e15 + 3, -1e15 + 1));
  ASSERT_EQ(found.size(), 1u);
  expectContact(found[0], {1e15 + 3.5, -1e15 + 2}, {1, 0}, 1);
  // Its own coordinates are far away, too.
  const Polygon c({shifted(rectangle(0, 0, 2, 2), {1e15, 1e15})});
  const auto again = ask(a, kHere, c, pose(0, -1e15 + 3, -1e15 + 1));
  ASSERT_EQ(again.size(), 1u);
  expectContact(again[0], {3.5, 2}, {1, 0}, 1);
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

/// So many edges end in one point that their pairs are left to few: one contact, whose normal parts them.
TEST(Contacts, OfFansThatTouchInOnePointAreOne) {
  constexpr int kSpikes = 60;
  const auto fan = [](double sign) {
    Ring ring;
    for (int i = 0; i < kSpikes; ++i)
      ring.insert(ring.end(), {{0, 0}, {sign * (10 + i), 2.0 * i - kSpikes}, {sign * (10 + i), 2.0 * i + 1 - kSpikes}});
    return ring;
  };
  const auto found = ask({fan(-1)}, {fan(1)});
  ASSERT_EQ(found.size(), 1u);
  expectContact(found[0], {0, 0}, found[0].normal, 0);
  EXPECT_FALSE(
      collide(Polygon({fan(-1)}), kHere, Polygon({fan(1)}), Pose(kHere * Eigen::Translation2d(found[0].normal))));
  // Turned into each other the spikes cross beside it, too.
  const auto crossed = ask(Polygon({fan(-1)}), kHere, Polygon({fan(1)}), pose(2, 0, 0));
  ASSERT_EQ(crossed.size(), 1u);
  EXPECT_GT(crossed[0].depth, 0);
  EXPECT_EQ(crossings(Polygon({fan(-1)}), kHere, Polygon({fan(1)}), kHere).size(),
            static_cast<std::size_t>(4 * kSpikes * kSpikes));
}

/// Many spikes of either at one point, and one edge of each along the other's.
TEST(Contacts, OfFansWithACommonEdgeAreInItsMiddle) {
  Ring left, right;
  for (int k = 0; k < 40; ++k) {
    const double angle = k * 0.07;
    left.insert(left.end(), {Vec2(0, 0), Vec2(-std::sin(angle), std::cos(angle)),
                             Vec2(-std::sin(angle + 0.03), std::cos(angle + 0.03))});
    right.insert(right.end(), {Vec2(0, 0), Vec2(std::sin(angle), std::cos(angle)),
                               Vec2(std::sin(angle + 0.02), std::cos(angle + 0.02))});
  }
  for (const double turn : {0.0, 1.0, 3.0}) {
    const Pose at = pose(turn, 0, 0);
    const std::vector<Contact> found = ask(Polygon({left}), at, Polygon({right}), at);
    ASSERT_EQ(found.size(), 1u) << turn;
    EXPECT_LE((found[0].point - at * Vec2(0, 0.5)).norm(), 1e-12) << turn;
  }
}

TEST(Contacts, NameEdgesOfSmallConvexAndOfDeepPairs) {
  for (const int n : {4, 8, 16, 200}) {
    const Polygon a({regular(n, 1)}), b({regular(n, 0.9)});
    for (const double x : {0.3, 0.6, 1.2}) {
      const auto found = ask(a, kHere, b, pose(0.1, x, 0));
      ASSERT_EQ(found.size(), 1u);
      EXPECT_GE(found[0].edge_a, 0) << n << " " << x;
      EXPECT_GE(found[0].edge_b, 0) << n << " " << x;
    }
    const auto contained = ask(a, kHere, Polygon({regular(n, 0.1)}), kHere);
    ASSERT_EQ(contained.size(), 1u);
    EXPECT_EQ(contained[0].edge_a, -1);
    EXPECT_GE(contained[0].edge_b, 0);
    EXPECT_NEAR(contained[0].point.norm(), 0, 0.1);
  }
}

/// Islands inside of islands, the larger polygon's inside of the smaller's: each leaves where it is nearest to the
/// edge.
TEST(Contacts, OfIslandsOfTheLargerPolygonInsideOfTheOthers) {
  const Polygon a({rectangle(-1, -1, 1, 1), rectangle(99, -1, 101, 1), rectangle(300, 0, 301, 1)});
  const Polygon b({rectangle(-5, -6, 1.5, 7), rectangle(94, -1.25, 106, 9)});
  for (const bool swapped : {false, true}) {
    const auto found =
        swapped ? contacts(b, pose(0, 0, 0), a, pose(0, 0, 0)) : contacts(a, pose(0, 0, 0), b, pose(0, 0, 0));
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

/// Straight vertices divide the floor; the edge is the one below the point, on either side of the tip's.
TEST(Contacts, NameTheEdgeOfADividedFaceThatIsNearest) {
  const Ring floor = {{-10, -5}, {10, -5}, {10, 0}, {3, 0}, {-1, 0}, {-10, 0}};
  for (const double x : {0.0, -5.0}) {
    const auto found = ask({shifted({{0, -1}, {2, 1}, {-6, 1}}, {x, 0})}, {floor});
    ASSERT_EQ(found.size(), 1u);
    expectContact(found[0], {x, -0.5}, {0, -1}, 1);
    EXPECT_TRUE(found[0].edge_a == 0 || found[0].edge_a == 2) << found[0].edge_a;
    EXPECT_EQ(found[0].edge_b, x == 0 ? 3 : 4);
  }
}

/// Hooks through lids: a leg's side leads out, and what is deepest behind it is the hook's own tip.
TEST(Contacts, WhereTheDeepestIsTheOthersVertexNameTheEdgeThatIsCrossed) {
  const Ring hooks = {{10.5, 20}, {-0.5, 20}, {-0.5, -80}, {-2, -80}, {-2, -90}, {0.5, -90},
                      {0.5, 10},  {9.5, 10},  {9.5, -80},  {8, -80},  {8, -90},  {10.5, -90}};
  const Ring lid = {{-1, 0}, {1, 0}, {4, -100}, {-4, -100}};
  const auto found = ask({hooks}, {lid, shifted(lid, {10, 0})});
  ASSERT_EQ(found.size(), 2u);
  for (const Contact& contact : found) {
    EXPECT_EQ(contact.depth, 2.5);
    EXPECT_EQ(contact.normal, Vec2(1, 0));
    EXPECT_EQ(contact.edge_a, contact.point.x() < 5 ? 5 : 11);
    EXPECT_EQ(contact.edge_b, contact.point.x() < 5 ? 0 : 4);
  }
}

}  // namespace
}  // namespace tricover::support
