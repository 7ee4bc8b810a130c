// SPDX-License-Identifier: BSD-3-Clause
// Whether a point of either is in the other's interior, against exact rationals, beside whether the closed regions
// meet: every way to ask collide() and a Scene. Other queries keep to it by a law (laws_oracle_test.cpp).
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "reproduction.h"
#include "test_scale.h"
#include "touching_families.h"
#include "touching_laws.h"
#include "tricover/collide.h"
#include "tricover/segment.h"

namespace tricover::support {
namespace {

constexpr int kCases = 1500;
constexpr double kRareKind = 0.08;
const CollideOptions kOpen{0, 0, Touching::Allowed};

class TouchingOracle : public testing::TestWithParam<Family> {};

TEST_P(TouchingOracle, AgreesWithExactRationals) {
  const int cases = scaledCount(kCases);
  int overlaps = 0, touches = 0, disagreements = 0;
  StrategyCaches old;
  for (int i = 0; i < cases; ++i) {
    const Case c = GetParam().make(static_cast<std::uint64_t>(i));
    const Overlap truth = overlapOf(c);
    overlaps += truth.overlap;
    touches += truth.meet && !truth.overlap;
    ASSERT_LE(truth.overlap, truth.meet);
    Random random(~static_cast<std::uint64_t>(i));
    std::string wrong = wrongTouching(c, truth, old, random);
    if (wrong.empty()) wrong = wrongTouchingInScene(c, truth);
    if (wrong.empty()) continue;
    if (++disagreements <= 3) {
      ADD_FAILURE() << GetParam().name << " seed " << i << ": " << wrong << ", truth: meet " << truth.meet
                    << ", overlap " << truth.overlap << "\n"
                    << reproduction(c);
    }
  }
  std::printf("%-12s %6d cases %6d overlap %6d touch %4d disagreements\n", GetParam().name, cases, overlaps, touches,
              disagreements);
  EXPECT_EQ(disagreements, 0);
  if (cases >= 100) {
    EXPECT_GE(overlaps, kRareKind * cases);
    EXPECT_GE(touches, kRareKind * cases);
    EXPECT_GE(cases - overlaps - touches, kRareKind * cases);
  }
}

TEST(Touching, WhatHasNoAreaLeadsInsideOrHasNoInterior) {
  const Pose here = Pose::Identity();
  const Polygon square({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}});
  // In a corner, where no discs inside meet; it touches by its spike alone, where its ring begins.
  const Polygon aerial({{{0.5, 9}, {0.5, 8.75}, {0.25, 8.75}, {0.25, 8.25}, {0.75, 8.25}, {0.75, 8.75}, {0.5, 8.75}}});
  EXPECT_TRUE(collide(square, here, aerial, here, kOpen));
  EXPECT_TRUE(collide(square, here, point({4, 4}), here, kOpen));
  EXPECT_TRUE(collide(square, here, segment({-1, 4}, {4, 4}), here, kOpen));
  EXPECT_FALSE(collide(square, here, segment({-1, 9}, {4, 9}), here, kOpen));
  EXPECT_TRUE(collide(square, here, point({4, 4}), here, CollideOptions{0.5, 0, Touching::Allowed}));
}

INSTANTIATE_TEST_SUITE_P(Families, TouchingOracle, testing::ValuesIn(touchingFamilies()),
                         [](const auto& family) { return family.param.name; });

}  // namespace
}  // namespace tricover::support
