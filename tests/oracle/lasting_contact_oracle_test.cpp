// SPDX-License-Identifier: BSD-3-Clause
// Bodies that start in contact, and contact that lasts: shifts against exact intervals, any motion against exact
// distances at many times.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "exact_shifts.h"
#include "lasting_contact_laws.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/segment.h"

namespace tricover::support {
namespace {

double anyError(Random& random) { return std::pow(10, -random.integer(2, 12)); }

/// A crate that slides along a floor past a gap in it, falls short of a wall, and passes a post at its margin.
TEST(LastingContactOracle, KnowsIntervalsByHand) {
  const Polygon floor({rectangle(-10, -1, 0, 0), rectangle(3, -1, 10, 0)});
  MovingCase c{floor, {}, Polygon({rectangle(-1, 0, 0, 1)}), Motion::translation(Pose::Identity(), {8, 0})};
  const auto contacts = [&](double margin) {
    return exact::contactsOfShifts(c.a, c.motion_a, c.b, c.motion_b, margin);
  };
  auto times = contacts(0);
  ASSERT_EQ(times.size(), 2u);
  EXPECT_EQ(times[0].begin, 0);
  EXPECT_EQ(times[0].end, mpq_class(1, 8));
  EXPECT_EQ(times[1].begin, mpq_class(3, 8));
  EXPECT_EQ(times[1].end, 1);
  c = {point({0, 0}), {}, point({0, 0}), Motion::translation(tricover::pose(-5, 3), {10, 0})};
  times = contacts(5);
  ASSERT_EQ(times.size(), 1u);
  EXPECT_EQ(times[0].begin, mpq_class(1, 10));
  EXPECT_EQ(times[0].end, mpq_class(9, 10));
  EXPECT_EQ(contacts(3).size(), 1u);
  EXPECT_EQ(contacts(2).size(), 0u);
  // Held all of the time; and in a hole.
  c = {Polygon({rectangle(-9, -9, 9, 9), rectangle(-3, -3, 3, 3)}), {}, box(1, 1), Motion::still(tricover::pose(6, 0))};
  ASSERT_EQ(contacts(0).size(), 1u);
  EXPECT_EQ(contacts(0)[0].end, 1);
  c.motion_b = Motion::translation(Pose::Identity(), {5, 0});
  ASSERT_EQ(contacts(0).size(), 1u);
  EXPECT_EQ(contacts(0)[0].begin, mpq_class(1, 2));
}

/// Asks wrong(case, time error, counts) of so many cases, each drawn by anyCase(random) from a seed of its own.
template <typename AnyCase, typename Wrong>
LastingCounts countContacts(int cases, std::uint64_t seed, const AnyCase& anyCase, const Wrong& wrong) {
  LastingCounts counts;
  int failures = 0;
  for (int i = 0; i < cases && failures < 5; ++i) {
    Random random(static_cast<std::uint64_t>(i) + seed);
    const MovingCase c = anyCase(random);
    const double error = anyError(random);
    const std::string problem = wrong(c, error, counts);
    if (problem.empty()) continue;
    ++failures;
    ADD_FAILURE() << i << ": " << problem << ", time error " << error << ", margin " << c.margin << "\n"
                  << reproduction(c);
  }
  std::printf("%d cases, %d in contact at first, %d later, %d never, %d for long\n", counts.cases, counts.at_begin,
              counts.later, counts.none, counts.lasting);
  return counts;
}

TEST(LastingContactOracle, ShiftsAgreeWithExactIntervals) {
  const int cases = scaledCount(6000);
  const LastingCounts counts = countContacts(cases, 37000, anyShiftFromContact, wrongWithShifts);
  if (cases < 400) return;
  EXPECT_GT(counts.at_begin, cases / 3);
  EXPECT_LT(counts.at_begin, 95 * cases / 100);
  EXPECT_GT(counts.later, cases / 40);
  EXPECT_GT(counts.none, cases / 100);
  EXPECT_GT(counts.lasting, cases / 4);
}

TEST(LastingContactOracle, MotionsAgreeWithSamples) {
  const int cases = scaledCount(1500);
  const LastingCounts counts = countContacts(
      cases, 73000, anyMotionFromContact,
      [](const MovingCase& c, double error, LastingCounts& all) { return wrongWithSamples(c, error, 60, all); });
  if (cases < 400) return;
  EXPECT_GT(counts.at_begin, cases / 3);
  EXPECT_LT(counts.at_begin, 95 * cases / 100);
  EXPECT_GT(counts.later, cases / 20);
  EXPECT_GT(counts.lasting, cases / 4);
}

}  // namespace
}  // namespace tricover::support
