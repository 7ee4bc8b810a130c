// SPDX-License-Identifier: BSD-3-Clause
// Contacts of one or two points: boxes on floors and in corners, edge on edge, vertex on edge, beside.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "shapes.h"
#include "tricover/contacts.h"

namespace tricover::support {
namespace {

const Pose kHere = Pose::Identity();
const Polygon kFloor({rectangle(-10, -1, 10, 0)}), kCrate({rectangle(-0.5, 0, 0.5, 1)});

/// The one contact of two polygons; with the operands swapped it has the same points.
Contact only(const Polygon& a, const Polygon& b, const Pose& pose_b, const ContactOptions& options = {}) {
  const std::vector<Contact> found = contacts(a, kHere, b, pose_b, options),
                             swapped = contacts(b, pose_b, a, kHere, options);
  EXPECT_EQ(found.size(), 1u);
  EXPECT_EQ(swapped.size(), 1u);
  if (found.size() != 1 || swapped.size() != 1) return {};
  EXPECT_EQ(found[0].count, swapped[0].count);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(found[0].points[k].point, swapped[0].points[k].point);
    EXPECT_EQ(found[0].points[k].depth, swapped[0].points[k].depth);
  }
  return found[0];
}

/// From left to right.
void expectEnds(const Contact& contact, const ContactPoint& left, const ContactPoint& right, double precision = 1e-14) {
  ASSERT_EQ(contact.count, 2u);
  std::array<ContactPoint, 2> ends = contact.points;
  EXPECT_GE(ends[0].depth, ends[1].depth);
  EXPECT_LE(ends[0].depth, contact.depth);
  if (ends[0].point.x() > ends[1].point.x()) std::swap(ends[0], ends[1]);
  EXPECT_LE((ends[0].point - left.point).norm(), precision);
  EXPECT_LE((ends[1].point - right.point).norm(), precision);
  EXPECT_NEAR(ends[0].depth, left.depth, precision);
  EXPECT_NEAR(ends[1].depth, right.depth, precision);
}

void expectOne(const Contact& contact) {
  EXPECT_EQ(contact.count, 1u);
  for (const ContactPoint& p : contact.points) {
    EXPECT_EQ(p.point, contact.point);
    EXPECT_EQ(p.depth, contact.depth);
  }
}

constexpr ContactDetail kDetails[] = {ContactDetail::LocalDepth, ContactDetail::GlobalDepth};

ContactOptions with(ContactDetail detail, double margin = 0) {
  ContactOptions options;
  options.detail = detail;
  options.margin = margin;
  return options;
}

TEST(ContactEnds, OfACrateOnAFloorAreItsCorners) {
  for (const double depth : {0.0, 0x1p-40, 0x1p-20, 0x1p-6, 0.25}) {
    const Contact contact = only(kFloor, kCrate, turnedAndMoved(0, 2, -depth));
    EXPECT_EQ(contact.depth, depth);
    EXPECT_LE((contact.point - Vec2(2, -depth / 2)).norm(), 1e-14);
    expectEnds(contact, {{1.5, -depth / 2}, depth}, {{2.5, -depth / 2}, depth});
  }
  // Half over the floor's end.
  expectEnds(only(kFloor, kCrate, turnedAndMoved(0, 9.75, -0.125)), {{9.25, -0.0625}, 0.125}, {{10, -0.0625}, 0.125});
}

/// A bar through a square that is deeper than the bar is wide: the ends are in the bar, as the middle is.
TEST(ContactEnds, OfABarThroughASquareAreInTheBar) {
  const Contact contact = only(Polygon({rectangle(-5, -5, 5, 5)}), Polygon({rectangle(-50, 1, 50, 3)}), kHere);
  EXPECT_LE((contact.point - Vec2(0, 2)).norm(), 1e-14);
  expectEnds(contact, {{-5, 2}, 4}, {{5, 2}, 4});
}

TEST(ContactEnds, OfEdgesThatLeanHaveTheirOwnDepths) {
  for (const double angle : {1e-9, -1e-9, 1e-6, 1e-3}) {
    Pose leaning = turnedAndMoved(angle, 2, 0);
    // The lower corner is 2^-8 deep.
    leaning.translation().y() = -0x1p-8 + 0.5 * std::abs(std::sin(angle));
    const Contact contact = only(kFloor, kCrate, leaning);
    EXPECT_NEAR(contact.depth, 0x1p-8, 1e-15);
    ASSERT_EQ(contact.count, 2u);
    EXPECT_NEAR(contact.points[0].depth, 0x1p-8, 1e-15);
    EXPECT_NEAR(contact.points[1].depth, 0x1p-8 - std::abs(std::sin(angle)), 1e-15);
    EXPECT_EQ(contact.points[0].point.x() < 2, angle > 0);
    EXPECT_NEAR(contact.points[0].point.y(), -0x1p-9, 1e-15);
  }
}

TEST(ContactEnds, OfWhatTouchesAtACornerAreOne) {
  // The other corner is 1e-9 above the floor.
  Pose leaning = turnedAndMoved(1e-9, 2, 0);
  leaning.translation().y() = 0.5e-9 - 1e-12;
  expectOne(only(kFloor, kCrate, leaning));
  expectOne(only(kFloor, kCrate, turnedAndMoved(0.25 * std::acos(-1.0), 2, -0.125)));
  const Polygon notched({{{-10, -1}, {10, -1}, {10, 0}, {-8, 0}, {-9, -0.5}, {-10, 0}}});
  for (const ContactDetail detail : kDetails) {
    expectOne(only(notched, kCrate, leaning, with(detail)));
    expectOne(only(notched, kCrate, turnedAndMoved(0.25 * std::acos(-1.0), 2, -0.125), with(detail)));
  }
}

/// Floors of many vertices, repeated ones and a closing one, that aren't convex: the stretch is all of it.
TEST(ContactEnds, GoOnAlongStraightEdges) {
  Ring ring = {{-10, -1}, {10, -1}, {10, 0}};
  for (int i = 79; i > -40; --i) {
    ring.emplace_back(0.125 * i, 0);
    if (i % 3 == 0) ring.push_back(ring.back());
  }
  ring.emplace_back(-10, 0);
  ring.emplace_back(-9, -0.5);
  ring.push_back(ring.front());
  const Polygon floor({ring}), convex({Ring(ring.begin(), ring.end() - 2)});
  for (const ContactDetail detail : kDetails) {
    for (const double depth : {0.0, 0x1p-30, 0x1p-6}) {
      const Contact contact = only(floor, kCrate, turnedAndMoved(0, 2.0625, -depth), with(detail));
      expectEnds(contact, {{1.5625, -depth / 2}, depth}, {{2.5625, -depth / 2}, depth});
      expectEnds(only(convex, kCrate, turnedAndMoved(0, 2.0625, -depth), with(detail)), {{1.5625, -depth / 2}, depth},
                 {{2.5625, -depth / 2}, depth});
    }
    for (const Polygon& below : {floor, convex})
      expectEnds(only(below, kCrate, turnedAndMoved(0, 2.0625, 0.25), with(detail, 0.5)), {{1.5625, 0.125}, 0.25},
                 {{2.5625, 0.125}, 0.25});
  }
}

TEST(ContactEnds, WithAMarginAreOfWhatIsGrown) {
  for (const double depth : {-0.25, 0.0, 0x1p-6, 0.125}) {
    const Contact contact = only(kFloor, kCrate, turnedAndMoved(0, 2, -depth), with(ContactDetail::GlobalDepth, 0.5));
    expectEnds(contact, {{1.5, -depth / 2}, depth + 0.5}, {{2.5, -depth / 2}, depth + 0.5});
  }
  // Away from the floor by more than the margin at one end.
  Pose leaning = turnedAndMoved(0.75, 2, 0);
  leaning.translation().y() = 0.5 * std::sin(0.75) + 0.25;
  expectOne(only(kFloor, kCrate, leaning, with(ContactDetail::GlobalDepth, 0.5)));
}

/// The shortest translation out of a corner clears both of its edges; the contact is on one of them.
TEST(ContactEnds, InACornerAreOnOneOfItsEdges) {
  const Polygon corner({{{-10, -1}, {10, -1}, {10, 9}, {9, 9}, {9, 0}, {-10, 0}}});
  for (const double deep : {0x1p-20, 0x1p-5}) {
    const Contact contact = only(corner, kCrate, turnedAndMoved(0, 8.5 + deep, -deep));
    EXPECT_NEAR(contact.depth, std::sqrt(2) * deep, 1e-14);
    ASSERT_EQ(contact.count, 2u);
    for (const ContactPoint& p : contact.points) EXPECT_NEAR(p.depth, contact.depth, 1e-14);
    const bool is_floor = contact.edge_a == 4;
    EXPECT_EQ(contact.edge_b, is_floor ? 0 : 1);
    for (const ContactPoint& p : contact.points)
      EXPECT_NEAR(is_floor ? p.point.y() : p.point.x() - 9, is_floor ? -deep / 2 : deep / 2, deep / 2 + 1e-14);
  }
}

TEST(ContactEnds, OfTeethAreAsFarApartAsTheyAreWide) {
  const Polygon above({rectangle(-10, 4.75, 100, 9)}), teeth({comb(7, 3, 1, 5)});
  const std::vector<Contact> found = contacts(above, kHere, teeth, kHere, with(ContactDetail::LocalDepth));
  ASSERT_EQ(found.size(), 7u);
  for (const Contact& contact : found) {
    const double x = contact.point.x();
    expectEnds(contact, {{x - 0.5, 4.875}, 0.25}, {{x + 0.5, 4.875}, 0.25}, 1e-12);
  }
}

/// Within a margin, far from the world's origin: where the pair is on the plane doesn't matter.
TEST(ContactEnds, WithinAMarginAreTheSameFarFromTheOrigin) {
  const Polygon rack({rectangle(-0.5, -0.5, 0.5, 0.5)}), crate({rectangle(-0.4, -0.5, 0.4, 0.5)});
  const Polygon notched({{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}, {-0.4, 0}}});
  for (const Polygon& below : {rack, notched})
    for (const double x : {0.0, 300.0, 1e3, 1e5})
      for (const double gap : {0.01, 0.005}) {
        const auto found = contacts(below, turnedAndMoved(0, x, 0), crate, turnedAndMoved(0, x, 1 + gap), {0.02});
        ASSERT_EQ(found.size(), 1u);
        EXPECT_EQ(found[0].edge_a, 2) << x;
        EXPECT_EQ(found[0].edge_b, 0) << x;
        expectEnds(found[0], {{x - 0.4, 0.5 + gap / 2}, 0.02 - gap}, {{x + 0.4, 0.5 + gap / 2}, 0.02 - gap}, 1e-10);
      }
}

/// The deepest contact is the first, and the deeper one of its ends is as deep.
TEST(ContactEnds, HaveTheDepthOfTheirComponent) {
  const Polygon u({{{-2, 0}, {2, 0}, {2, 2}, {1, 2}, {1, 1}, {-1, 1}, {-1, 2}, {-2, 2}}});
  const Polygon through({{{-1.25, 0.5}, {-1, 1.25}, {1, 1}, {2, 1.25}}});
  int two = 0, one = 0;
  for (const ContactDetail detail : kDetails)
    for (int i = 0; i < 600; ++i) {
      const Pose there = i == 0 ? kHere : turnedAndMoved(0.37 * i, std::cos(0.71 * i), 1 + std::sin(0.53 * i));
      const std::vector<Contact> found = contacts(u, kHere, i % 2 == 0 ? through : kCrate, there, with(detail));
      for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_EQ(found[k].points[0].depth, found[k].depth) << i;
        EXPECT_LE(found[k].depth, found[0].depth);
        ++(found[k].count == 2 ? two : one);
      }
    }
  EXPECT_GE(two, 100);
  EXPECT_GE(one, 100);
}

/// Where only the margin makes the two overlap, the end is in the middle. The other one is the tip, as the point is.
TEST(ContactEnds, WithAMarginAreInTheMiddleOfAGap) {
  const Polygon box({rectangle(-1, -1, 1, 1)}), triangle({{{0.15, 1.15}, {-0.35, 0.35}, {0.45, -0.3}}});
  const Contact contact = only(box, triangle, turnedAndMoved(0, -0.6, 0.95), with(ContactDetail::GlobalDepth, 0.3));
  ASSERT_EQ(contact.count, 2u);
  EXPECT_NEAR(contact.depth, 0.65, 1e-14);
  EXPECT_LE((contact.points[0].point - Vec2(-0.15, 0.65)).norm(), 1e-12);
  EXPECT_LE((contact.points[1].point - Vec2(-0.95, 1.15)).norm(), 1e-12);
}

}  // namespace
}  // namespace tricover::support
