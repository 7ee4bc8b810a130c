// SPDX-License-Identifier: BSD-3-Clause
// Asks of every law that is linked as many cases as it says, or the share of them that TRICOVER_TEST_SCALE says.
#include <gtest/gtest.h>

#include <cstdio>
#include <ostream>

#include "law.h"
#include "test_scale.h"

namespace tricover::laws {

void PrintTo(const Law& law, std::ostream* out) { *out << law.query << " " << law.family; }

namespace {

constexpr std::uint64_t kSeed = 1;

class Of : public testing::TestWithParam<Law> {};

TEST_P(Of, EveryCase) {
  const Law& law = GetParam();
  const int cases = support::scaledCount(law.cases);
  Tally tally;
  int wrong = 0;
  for (int i = 0; i < cases && wrong < 3; ++i) {
    const std::string problem = wrongCase(law, kSeed, static_cast<std::uint64_t>(i), tally);
    if (problem.empty()) continue;
    ++wrong;
    ADD_FAILURE() << problem;
  }
  std::printf("%-12s %-24s %6d cases: %s\n", law.query.c_str(), law.family.c_str(), cases, tally.line().c_str());
  if (wrong == 0 && law.cases > 1) {
    EXPECT_EQ(tally.wrongShare(law.shares, cases, support::isScaledDown()), "");
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, Of, testing::ValuesIn(allLaws()), [](const auto& law) { return law.param.family; });

}  // namespace
}  // namespace tricover::laws

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
