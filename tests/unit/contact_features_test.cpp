// SPDX-License-Identifier: BSD-3-Clause
// What a contact says, by hand: where they touch, which edges it names, and at all sizes.
#include <utility>

#include "contacts_by_hand.h"

namespace tricover::support {
namespace {

TEST(ContactFeatures, ThatAreShallowHaveTheEdgesNormalAllTheSame) {
  const double cosine = std::cos(0.3), sine = std::sin(0.3);
  for (const double depth : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const Pose turned = turnedAndMoved(0.3, 7, 5);
    const auto found =
        ask(Polygon({rectangle(0, 0, 4, 4)}), turned, Polygon({{{4 - depth, 2}, {6, 1}, {5, 2}, {6, 3}}}), turned);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_LE((found[0].normal - Vec2(cosine, sine)).norm(), 1e-12) << depth;
    EXPECT_NEAR(found[0].depth, depth, 1e-14);
    EXPECT_EQ(found[0].edge_a, 1);
  }
}

TEST(ContactFeatures, WhereAVertexTouchesAnEdge) {
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
TEST(ContactFeatures, WhereAVertexThatLeansTouchesAnEdge) {
  const auto found = ask({{{4, 2}, {-6, 6}, {-4, 2}, {-6, -2}}}, {rectangle(4, 1.5, 5, 8)});
  ASSERT_EQ(found.size(), 1u);
  expectContact(found[0], {4, 2}, {1, 0}, 0);
  EXPECT_EQ(found[0].depth, 0);
  EXPECT_EQ(found[0].edge_b, 3);
}

/// Both ways out of a corner are as long; b's origin is above a's rather than beside it.
TEST(ContactFeatures, AtAVertexThatIsRepeatedNameTheFlatterEdge) {
  const Ring box = rectangle(0, 0, 4, 4), leaning{{1, 3.6}, {3, 3.5}, {3, 3.5}, {3, 6}, {1, 6}};
  const std::vector<Contact> found = ask({box}, {leaning});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].normal, Vec2(0, 1));
  EXPECT_EQ(found[0].edge_a, 2);
  EXPECT_EQ(found[0].edge_b, 0);
}

TEST(ContactFeatures, OfEquallyDeepWaysTakeTheOneAwayFromTheOther) {
  const auto found = ask({rectangle(-2, -4, 2, 4)}, {rectangle(1.5, 3.5, 4, 6)});
  ASSERT_EQ(found.size(), 1u);
  expectContact(found[0], {1.75, 3.75}, {0, 1}, 0.5);
}

TEST(ContactFeatures, WhereVerticesTouch) {
  for (const Ring& b : {Ring{{4, 4}, {6, 5}, {5, 6}}, Ring{{4, 4}, {6, 5}, {5, 5}, {5, 6}}}) {
    const auto found = ask({rectangle(0, 0, 4, 4)}, {b});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].depth, 0);
    EXPECT_LE((found[0].point - Vec2(4, 4)).norm(), 1e-12);
    EXPECT_GT(found[0].normal.x() + found[0].normal.y(), 0.7);
  }
}

TEST(ContactFeatures, WhereEdgesTouchAlongAStretch) {
  const auto found = ask({rectangle(0, 0, 4, 4)}, {rectangle(4, 1, 6, 9)});
  ASSERT_EQ(found.size(), 1u);
  expectContact(found[0], {4, 2.5}, {1, 0}, 0);
  EXPECT_EQ(found[0].depth, 0);
  EXPECT_EQ(found[0].edge_a, 1);
  EXPECT_EQ(found[0].edge_b, 3);
}

TEST(ContactFeatures, OfABoxInACornerThatItTouchesLeadOutOfTheCorner) {
  const Ring corner = {{0, 0}, {10, 0}, {10, 1}, {1, 1}, {1, 10}, {0, 10}};
  const auto found = ask({corner}, {rectangle(1, 1, 3, 3)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].depth, 0);
  EXPECT_LE((found[0].normal - Vec2(1, 1).normalized()).norm(), 1e-9);
}

TEST(ContactFeatures, OfAPegInAHoleThatFitsIsOne) {
  const auto found = ask({rectangle(0, 0, 9, 9), rectangle(3, 3, 6, 6)}, {rectangle(3, 3, 6, 6)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].depth, 0);
}

/// They were joined across the gap, because only the middle of a common stretch was known, not its end.
TEST(ContactFeatures, OfRingsWithoutAreaOnOneEdgeAreSeparate) {
  EXPECT_EQ(ask({rectangle(-3, -3, 3, 3)}, {{{1, -3}, {2, -3}, {2, -3}}, {{-2, -3}, {-1, -3}, {-1, -3}}}).size(), 2u);
  EXPECT_EQ(ask({{{3, 2}, {3, 3}, {1, 3}}}, {{{-3, 1}, {1, 3}, {1, 2}}, {{2, 3}, {3, 3}, {3, 3}}}).size(), 2u);
}

TEST(ContactFeatures, OfMirroredPolygons) {
  const Polygon a({rectangle(0, 0, 4, 4)}), b({rectangle(0, 0, 2, 2)});
  Pose flipped = kHere;
  flipped.linear() << -1, 0, 0, 1;
  const auto found = ask(a, kHere, b, Pose(turnedAndMoved(0, 5, 1) * flipped));  // x from 3 to 5
  ASSERT_EQ(found.size(), 1u);
  expectContact(found[0], {3.5, 2}, {1, 0}, 1);
  const auto both = ask(a, flipped, b, Pose(turnedAndMoved(0, -3, 1) * flipped));  // x from -5 to -3
  ASSERT_EQ(both.size(), 1u);
  expectContact(both[0], {-3.5, 2}, {-1, 0}, 1);
}

TEST(ContactFeatures, AtEveryScale) {
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

TEST(ContactFeatures, OfAHugeAndATinyPolygonAreWhereTheTinyOneIs) {
  const auto found = ask({rectangle(-1e300, -1e300, 1e300, 0)}, {scaled(rectangle(-1, -1, 1, 2), 1e-300)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LE(found[0].point.norm(), 1e-290);
  const auto less = ask({rectangle(-1e9, -1e9, 1e9, 0)}, {scaled(rectangle(-1, -1, 1, 2), 1e-3)});
  ASSERT_EQ(less.size(), 1u);
  EXPECT_LE((less[0].point - Vec2(0, -0.5e-3)).norm(), 1e-6);
  EXPECT_LE((less[0].normal - Vec2(0, 1)).norm(), 1e-9);
}

TEST(ContactFeatures, FarAway) {
  const Polygon a({rectangle(0, 0, 4, 4)}), b({rectangle(0, 0, 2, 2)});
  const auto found = ask(a, turnedAndMoved(0, 1e15, -1e15), b, turnedAndMoved(0, 1e15 + 3, -1e15 + 1));
  ASSERT_EQ(found.size(), 1u);
  expectContact(found[0], {1e15 + 3.5, -1e15 + 2}, {1, 0}, 1);
  // Its own coordinates are far away, too.
  const Polygon c({shifted(rectangle(0, 0, 2, 2), {1e15, 1e15})});
  const auto again = ask(a, kHere, c, turnedAndMoved(0, -1e15 + 3, -1e15 + 1));
  ASSERT_EQ(again.size(), 1u);
  expectContact(again[0], {3.5, 2}, {1, 0}, 1);
}

/// Many edges end in one point: one contact, whose normal separates them.
TEST(ContactFeatures, OfFansThatTouchInOnePointAreOne) {
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
  const auto crossed = ask(Polygon({fan(-1)}), kHere, Polygon({fan(1)}), turnedAndMoved(2, 0, 0));
  ASSERT_EQ(crossed.size(), 1u);
  EXPECT_GT(crossed[0].depth, 0);
  EXPECT_EQ(crossings(Polygon({fan(-1)}), kHere, Polygon({fan(1)}), kHere).size(),
            static_cast<std::size_t>(4 * kSpikes * kSpikes));
}

/// Many spikes of either at one point, and one edge of each along the other's.
TEST(ContactFeatures, OfFansWithACommonEdgeAreInItsMiddle) {
  Ring left, right;
  for (int k = 0; k < 40; ++k) {
    const double angle = k * 0.07;
    left.insert(left.end(), {Vec2(0, 0), Vec2(-std::sin(angle), std::cos(angle)),
                             Vec2(-std::sin(angle + 0.03), std::cos(angle + 0.03))});
    right.insert(right.end(), {Vec2(0, 0), Vec2(std::sin(angle), std::cos(angle)),
                               Vec2(std::sin(angle + 0.02), std::cos(angle + 0.02))});
  }
  for (const double turn : {0.0, 1.0, 3.0}) {
    const Pose at = turnedAndMoved(turn, 0, 0);
    const std::vector<Contact> found = ask(Polygon({left}), at, Polygon({right}), at);
    ASSERT_EQ(found.size(), 1u) << turn;
    EXPECT_LE((found[0].point - at * Vec2(0, 0.5)).norm(), 1e-12) << turn;
  }
}

/// By more than directions are tried with, and along less of the line than coordinates are off by: found by soak.
TEST(ContactFeatures, OfACornerThroughALineLeadBack) {
  const Vec2 end(-0x1.04e9e2f412566p+0, 0x1.2980ceda0a94bp+3);
  const Polygon line(
      {{end, end, -end, end, {-0x1.875ed46e1b819p+1, 0x1.be4136470fdf1p+4}, {-2 * end.x(), -2 * end.y()}}});
  const Polygon corner({{{0x1.08d314d84ef4bp-25, 0x1.bb2f21fa6425p-26},
                         {0x1.1409a4df7a256p-27, 0x1.1c2494aed5f3fp-31},
                         {0x1.4fd4d9d652p-25, 0x1.7fd5503b70eecp-29},
                         {-0x1.4ba63564120fep-25, 0x1.350e344ecfad1p-28},
                         {0x1.8ee94a2fd44d1p-27, 0x1.bfba2c2804293p-27},
                         {0x1.44c74bf9fb143p-25, -0x1.546c614c7c417p-27},
                         {0x1.3f7f45d34bd9bp-25, -0x1.6fa420178d744p-25}}});
  const Pose pose_a = pose(0x1.0dbb0f06201c2p-15, -0x1.fffcb62e15463p-1, -0x1.9222231b87d6ap+8, 0x1.0000ffffe504ep+0,
                           -0x1.0dbb0f061bb2ap-15, 0x1.d3db30048cd9p+8);
  const Pose pose_b = pose(0x1.45fae8a21ef9cp-1, 0x1.8ad16aca0ad03p-1, -0x1.92222445989fap+8, -0x1.8ac8dd1485eaep-1,
                           0x1.45fe6b02ab607p-1, 0x1.d3db2fe4c8e2dp+8);
  const auto found = ask(line, pose_a, corner, pose_b);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].depth, 0);
  Pose apart = pose_b;
  apart.translation() += 1e-10 * found[0].normal;
  EXPECT_FALSE(collide(line, pose_a, corner, apart));
}

TEST(ContactFeatures, NameEdgesOfSmallConvexAndOfDeepPairs) {
  for (const int n : {4, 8, 16, 200}) {
    const Polygon a({regular(n, 1)}), b({regular(n, 0.9)});
    for (const double x : {0.3, 0.6, 1.2}) {
      const auto found = ask(a, kHere, b, turnedAndMoved(0.1, x, 0));
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

/// Straight vertices divide the floor; the edge is the one below the point, on either side of the tip's.
TEST(ContactFeatures, NameTheEdgeOfADividedFaceThatIsNearest) {
  const Ring floor = {{-10, -5}, {10, -5}, {10, 0}, {3, 0}, {-1, 0}, {-10, 0}};
  for (const double x : {0.0, -5.0}) {
    const auto found = ask({shifted({{0, -1}, {2, 1}, {-6, 1}}, {x, 0})}, {floor});
    ASSERT_EQ(found.size(), 1u);
    expectContact(found[0], {x, -0.5}, {0, -1}, 1);
    EXPECT_TRUE(found[0].edge_a == 0 || found[0].edge_a == 2) << found[0].edge_a;
    EXPECT_EQ(found[0].edge_b, x == 0 ? 3 : 4);
  }
}

/// Hooks through lids: past a leg's side b leaves the hook, which is widest at its lower end, by the lid's width there.
TEST(ContactFeatures, WhereTheDeepestIsTheOthersVertexNameTheEdgeThatIsCrossed) {
  const Ring hooks = {{10.5, 20}, {-0.5, 20}, {-0.5, -80}, {-2, -80}, {-2, -90}, {0.5, -90},
                      {0.5, 10},  {9.5, 10},  {9.5, -80},  {8, -80},  {8, -90},  {10.5, -90}};
  const Ring lid = {{-1, 0}, {1, 0}, {4, -100}, {-4, -100}};
  const auto found = ask({hooks}, {lid, shifted(lid, {10, 0})});
  ASSERT_EQ(found.size(), 2u);
  for (const Contact& contact : found) {
    const Vec2 normal = Vec2(100, -3).normalized();
    EXPECT_NEAR(contact.depth, 4.2 * normal.x(), 1e-12);
    EXPECT_LE((contact.normal - normal).norm(), 1e-12);
    EXPECT_EQ(contact.edge_a, contact.point.x() < 5 ? 5 : 11);
    EXPECT_EQ(contact.edge_b, contact.point.x() < 5 ? 3 : 7);
  }
}

}  // namespace
}  // namespace tricover::support
