// SPDX-License-Identifier: BSD-3-Clause
// collide() against the exact reference in every family, in every way to ask it.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "collide_laws.h"
#include "exact_reference.h"
#include "families.h"
#include "random.h"
#include "reproduction.h"
#include "test_scale.h"

namespace tricover::support {
namespace {

constexpr int kCases = 5000;
constexpr double kRareOutcome = 0.15;

class CollideOracle : public testing::TestWithParam<Family> {};

TEST_P(CollideOracle, AgreesWithExactRationals) {
  const int cases = scaledCount(kCases);
  int hits = 0, disagreements = 0;
  StrategyCaches old;  // what it holds is about other pairs and other poses
  for (int i = 0; i < cases; ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    const Case c = GetParam().make(seed);
    const bool truth = exact::collide(c.a, c.pose_a, c.b, c.pose_b);
    hits += truth;
    Random random(~seed);
    const std::string wrong = wrongCollide(c, {}, {truth, truth}, old, random);
    if (wrong.empty()) continue;
    if (++disagreements <= 3) {
      ADD_FAILURE() << GetParam().name << " seed " << seed << ": " << wrong << ", truth " << truth << "\n"
                    << reproduction(c);
    }
  }
  std::printf("%-22s %6d cases %6d hits %4d disagreements\n", GetParam().name, cases, hits, disagreements);
  EXPECT_EQ(disagreements, 0);
  if (cases >= 100) {
    EXPECT_GE(hits, kRareOutcome * cases);
    EXPECT_LE(hits, (1 - kRareOutcome) * cases);
  }
}

INSTANTIATE_TEST_SUITE_P(Families, CollideOracle, testing::ValuesIn(families()),
                         [](const auto& family) { return family.param.name; });

}  // namespace
}  // namespace tricover::support
