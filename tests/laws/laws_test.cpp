// SPDX-License-Identifier: BSD-3-Clause
// Asks of every law that is linked as many cases as it says, or the share of them that TRICOVER_TEST_SCALE says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <ostream>

#include "law.h"
#include "test_scale.h"

namespace tricover::laws {

void PrintTo(const Law& law, std::ostream* out) { *out << law.query << " " << law.family; }

namespace {

constexpr std::uint64_t kSeed = 1;

/// What the library answers wrongly, until it is mended.
struct KnownFault {
  const char *query, *family;
  int number;
};
constexpr KnownFault kKnownFaults[] = {
    // A part of the overlap that has an area has no depth.
    {"contact_components", "rectilinear", 8798},
    // A local depth is below the overlap's width along its normal.
    {"contacts", "straight_vertices", 450},
    {"contacts", "any_rings", 411},
    {"contacts", "any_rings", 453},
};

bool isKnown(const Law& law, int number) {
  return std::any_of(std::begin(kKnownFaults), std::end(kKnownFaults), [&](const KnownFault& fault) {
    return law.query == fault.query && law.family == fault.family && number == fault.number;
  });
}

class Of : public testing::TestWithParam<Law> {};

TEST_P(Of, EveryCase) {
  const Law& law = GetParam();
  const int cases = support::scaledCount(law.cases);
  Tally tally;
  int wrong = 0;
  for (int i = 0; i < cases && wrong < 3; ++i) {
    const std::string problem = wrongCase(law, kSeed, static_cast<std::uint64_t>(i), tally);
    if (isKnown(law, i)) {
      EXPECT_NE(problem, "") << "case " << i << " is mended: it is no known fault any more";
    } else if (!problem.empty()) {
      ++wrong;
      ADD_FAILURE() << problem;
    }
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
