// SPDX-License-Identifier: BSD-3-Clause
// Local depths of crates in corners: of rooms, L, U, combs and complements.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "contact_laws.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/penetration.h"

namespace tricover::support {
namespace {

const Pose kHere = Pose::Identity();
const Polygon kCorner({{{0, 0}, {9, 0}, {9, 1}, {1, 1}, {1, 9}, {0, 9}}});

Ring slots(double wall, int count, double width, double pitch, double height) {
  Ring ring = {{-wall, -wall}, {count * pitch, -wall}};
  for (int k = count - 1; k >= 0; --k) {
    const double x = k * pitch;
    ring.insert(ring.end(), {{x + pitch, height}, {x + width, height}, {x + width, 0}, {x, 0}});
  }
  ring.insert(ring.end(), {{0, height}, {-wall, height}});
  return ring;
}

/// All have a corner at the origin, with the free side above and to the right of it.
std::vector<Polygon> corners() {
  return {Polygon({{{-1, -1}, {9, -1}, {9, 0}, {0, 0}, {0, 9}, {-1, 9}}}),
          Polygon({{{-1, -1}, {9, -1}, {9, 9}, {8, 9}, {8, 0}, {0, 0}, {0, 9}, {-1, 9}}}),
          Polygon({rectangle(-1, -1, 9, 9), rectangle(0, 0, 8, 8)}), Polygon({rectangle(0, 0, 8, 8)}).complement(),
          Polygon({slots(1, 4, 4, 5, 6)})};
}

ContactOptions local() {
  ContactOptions options;
  options.detail = ContactDetail::LocalDepth;
  return options;
}

TEST(ContactCorners, IntoOneWallLeadOutOfItWhateverTheCrateRestsOn) {
  const Polygon crate({rectangle(-1, -1, 1, 1)});
  const std::vector<Contact> found = contacts(kCorner, kHere, crate, turnedAndMoved(0, 1.99, 2), local());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].depth, 0.01, 1e-14);
  EXPECT_LE((found[0].normal - Vec2(1, 0)).norm(), 1e-12);
  EXPECT_EQ(found[0].edge_a, 3);
  EXPECT_EQ(found[0].edge_b, 3);
  for (const Polygon& room : corners())
    for (const double deep : {1e-9, 1e-4, 0.01, 0.2})
      for (const double turn : {0.0, 1.0}) {
        const Pose frame = turnedAndMoved(turn, 5, -3);
        const std::vector<Contact> in_wall =
                                       contacts(room, frame, crate, frame * turnedAndMoved(0, 1 - deep, 1), local()),
                                   in_floor =
                                       contacts(room, frame, crate, frame * turnedAndMoved(0, 1, 1 - deep), local());
        ASSERT_FALSE(in_wall.empty() || in_floor.empty());
        EXPECT_NEAR(in_wall[0].depth, deep, 1e-12);
        EXPECT_LE((in_wall[0].normal - frame.linear() * Vec2(1, 0)).norm(), 1e-6);
        EXPECT_NEAR(in_floor[0].depth, deep, 1e-12);
        EXPECT_LE((in_floor[0].normal - frame.linear() * Vec2(0, 1)).norm(), 1e-6);
      }
}

TEST(ContactCorners, IntoBothWallsLeadAlongTheBisectorAndFreeTheCrateOfBoth) {
  const Polygon crate({rectangle(-1, -1, 1, 1)});
  for (const Polygon& room : corners())
    for (const double deep : {1e-9, 1e-4, 0.01, 0.2})
      for (const double other : {1.0, 0.5, 1e-3}) {
        Pose there = turnedAndMoved(0, 1 - deep, 1 - other * deep);
        const std::vector<Contact> found = contacts(room, kHere, crate, there, local());
        ASSERT_EQ(found.size(), 1u);
        EXPECT_NEAR(found[0].depth, deep * std::hypot(1, other), 1e-12);
        EXPECT_LE((found[0].normal - Vec2(1, other).normalized()).norm(), 1e-6);
        there.translation() += (found[0].depth * (1 + 1e-9) + 1e-14) * found[0].normal;
        EXPECT_FALSE(collide(room, kHere, crate, there, {0, 0, Touching::Allowed}));
      }
}

TEST(ContactCorners, AreAlikeInCornersThatAreHardlyTurned) {
  const Polygon crate({rectangle(-1, -1, 1, 1)});
  for (int i = 0; i < 400; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const double turn = random.real(-0.001, 0.001), deep = std::exp2(random.real(-12, -3));
    const std::vector<Polygon> rooms = corners();
    const Polygon& room = rooms[static_cast<std::size_t>(i) % rooms.size()];
    // Some corner of the turned crate is so deep in the left wall, and another one rests on the floor.
    const double reach = std::cos(turn) + std::abs(std::sin(turn));
    const Pose there = turnedAndMoved(turn, reach - deep, reach);
    const std::vector<Contact> found = contacts(room, kHere, crate, there, local());
    ASSERT_FALSE(found.empty());
    EXPECT_GE(found[0].depth, deep - 1e-12) << i;
    EXPECT_LE(found[0].depth, 1.42 * deep + 1e-12) << i;
    EXPECT_GE(found[0].normal.x(), 0.7) << i;
    EXPECT_EQ(wrongLocalDepths({room, kHere, crate, there}, found), "") << i;
  }
}

/// A second component, far away: each one's exit is its own, at any detail.
TEST(ContactCorners, BesideAnotherComponentAreTheSame) {
  const Polygon crate({rectangle(-1, -1, 1, 1), rectangle(15, 15, 16, 16)});
  const Polygon room({{{0, 0}, {9, 0}, {9, 1}, {1, 1}, {1, 9}, {0, 9}}, rectangle(17.5, 17, 19, 18)});
  const std::vector<Contact> found = contacts(room, kHere, crate, turnedAndMoved(0, 1.99, 1.99), globally());
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(std::min(found[0].depth, found[1].depth), std::sqrt(2) * 0.01, 1e-12);
}

/// Crates and other bodies, somewhere deep in walls, floors and corners.
TEST(ContactCorners, PushingByThemAgainAndAgainComesToRest) {
  const int cases = scaledCount(1500);
  int wayed = 0, at_once = 0, wrong = 0;
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const std::vector<Polygon> rooms = corners();
    const Polygon& room = rooms[static_cast<std::size_t>(random.integer(0, 4))];
    const double w = random.real(0.3, 1.3), h = random.real(0.3, 1.3);
    const Polygon body({random.oneIn(3) ? Ring{{-1, -1}, {1, -1}, {1, 0}, {.3, 0}, {.3, 1}, {-.3, 1}, {-.3, 0}, {-1, 0}}
                                        : rectangle(-w, -h, w, h)});
    const double turn = random.oneIn(3) ? 0 : random.coin() ? random.real(-0.001, 0.001) : random.real(0, 6.3);
    Pose in_room = turnedAndMoved(turn, 0, 0);
    Vec2 low(9, 9);
    for (const Vec2& v : body.rings()[0]) low = low.cwiseMin(in_room * v);
    const double deep = std::exp2(random.real(-16, -2));
    in_room.translation() = Vec2(-deep, -deep * random.unit()) - low;
    if (random.oneIn(3)) in_room.translation().x() += random.unit();
    if (random.oneIn(3)) in_room.translation().y() += random.oneIn(2) ? deep : random.real(0, 4);
    const Pose frame =
        random.coin() ? kHere : turnedAndMoved(random.real(0, 6.3), random.real(-9, 9), random.real(-9, 9));
    const Case c{room, frame, body, frame * in_room};
    const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b, local());
    if (found.empty() || !(found[0].depth > 1e-9)) continue;
    // Whether a translation of at most twice the deepest depth frees the body.
    bool has_way = false;
    for (int k = 0; k < 64 && !has_way; ++k)
      for (const double share : {0.5, 1.0, 1.5, 2.0})
        has_way =
            has_way || !collide(c.a, c.pose_a, c.b, moved(c.pose_b, share * found[0].depth * direction(0.098 * k)),
                                {0, 0, Touching::Allowed});
    if (!has_way) continue;
    ++wayed;
    const int pushes = pushesUntilFree(c, 10);
    at_once += pushes == 1;
    const std::string problem = pushes > 10 ? "ten pushes don't free it" : wrongLocalDepths(c, found);
    if (!problem.empty() && ++wrong <= 3) ADD_FAILURE() << i << ": " << problem << "\n" << reproduction(c);
  }
  std::printf("%d cases, %d have a way, %d are free at once\n", cases, wayed, at_once);
  EXPECT_EQ(wrong, 0);
  EXPECT_GE(wayed, cases / 2);
  EXPECT_GE(at_once, wayed / 2);
}

/// A ring that uses an edge twice: the depth changes by no more than the pose does, as far as that moves b.
TEST(ContactCorners, AreNoNoiseWhereAnEdgeIsUsedTwice) {
  const Polygon a({{{3, -1}, {1, 0}, {1, 3}, {1, 2}, {1, -1}, {-2, -1}, {0, -2}}}),
      b({{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}});
  const std::vector<Contact> middle = contacts(a, kHere, b, turnedAndMoved(1, 1.75, 0.8725), local());
  ASSERT_FALSE(middle.empty());
  for (int i = 0; i < 400; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const auto off = [&] { return random.real(-1e-9, 1e-9); };
    const std::vector<Contact> found =
        contacts(a, kHere, b, turnedAndMoved(1 + off(), 1.75 + off(), 0.8725 + off()), local());
    ASSERT_EQ(found.size(), middle.size()) << i;
    EXPECT_NEAR(found[0].depth, middle[0].depth, 1e-7) << i;
  }
}

}  // namespace
}  // namespace tricover::support
