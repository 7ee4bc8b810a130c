// SPDX-License-Identifier: BSD-3-Clause
// Whether areas cover a part, one area or the union of many, against exact rationals.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>

#include "covers_laws.h"
#include "random.h"
#include "reproduction.h"
#include "test_scale.h"
#include "touching_families.h"
#include "tricover/covers.h"

namespace tricover::support {
namespace {

constexpr int kCases = 600;
constexpr double kRareKind = 0.08;

class CoversOracle : public testing::TestWithParam<SheetKind> {};

TEST_P(CoversOracle, AgreesWithExactRationals) {
  const int cases = scaledCount(kCases);
  CoversCounts plain, wide;
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Sheet sheet = GetParam().make(random);
    const int before = plain.covered;
    ASSERT_EQ(wrongCovers(sheet, 0, plain), "") << GetParam().name << " seed " << i << "\n" << reproduction(sheet);
    if (plain.covered == before) continue;
    for (const double margin : {0.5, 1.0, 2.0})
      ASSERT_EQ(wrongCovers(sheet, margin, wide), "")
          << GetParam().name << " seed " << i << ", margin " << margin << "\n"
          << reproduction(sheet);
  }
  std::printf("%-8s %5d cases %5d covered %5d by several %5d with a margin %5d not\n", GetParam().name, cases,
              plain.covered, plain.unions, wide.covered, wide.not_covered);
  if (cases < 100) return;
  EXPECT_GE(plain.covered, kRareKind * cases);
  EXPECT_GE(plain.not_covered, kRareKind * cases);
  EXPECT_GT(plain.unions, cases / 200);
}

INSTANTIATE_TEST_SUITE_P(Kinds, CoversOracle, testing::ValuesIn(sheetKinds()),
                         [](const auto& kind) { return std::string(kind.param.name); });

/// Pairs that share edges and touch: one covers the other rarely, but what is left open is small.
TEST(Covers, PairsThatTouch) {
  CoversCounts counts;
  for (const Family& family : touchingFamilies()) {
    for (int i = 0; i < scaledCount(300); ++i) {
      const Case c = family.make(static_cast<std::uint64_t>(i));
      ASSERT_EQ(wrongCovers({{{c.a, c.pose_a, {}}}, c.b, c.pose_b}, 0, counts), "") << family.name << " " << i << "\n"
                                                                                    << reproduction(c);
      EXPECT_TRUE(covers(c.a, c.pose_a, c.a, c.pose_a));
    }
  }
  if (!isScaledDown()) {
    EXPECT_GT(counts.covered, 30);
  }
}

}  // namespace
}  // namespace tricover::support
