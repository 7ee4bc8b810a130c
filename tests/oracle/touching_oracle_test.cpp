// SPDX-License-Identifier: BSD-3-Clause
// Whether the interiors meet, against exact rationals, beside whether the closed regions do: every way of asking.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "exact_reference.h"
#include "families.h"
#include "random.h"
#include "reproduction.h"
#include "stages.h"
#include "strategies.h"
#include "test_scale.h"
#include "touching_families.h"
#include "tricover/collide.h"
#include "tricover/scene.h"

namespace tricover::support {
namespace {

constexpr int kCases = 1500;
constexpr double kRareKind = 0.08;

CollideOptions closed() { return {}; }
CollideOptions open(double margin = 0) { return {margin, 0, Touching::Allowed}; }

struct Truth {
  bool meet, overlap;
};

/// The first way of asking that gives another answer than the truth; empty if there is none.
std::string wrongWay(const Case& c, const Truth& truth, StrategyCaches& old) {
  for (const auto stages : {detail::Stages::Edges, detail::Stages::Hierarchy, detail::Stages::All}) {
    const UpTo these(stages);
    const std::string name = "up to stage " + std::to_string(static_cast<int>(stages));
    if (collide(c.a, c.pose_a, c.b, c.pose_b, open()) != truth.overlap) return name;
    if (collide(c.b, c.pose_b, c.a, c.pose_a, open()) != truth.overlap) return name + ", swapped";
  }
  for (const Strategy strategy : {Strategy::Hierarchy, Strategy::Paper}) {
    const std::string name = nameOf(strategy);
    if (collide(strategy, c.a, c.pose_a, c.b, c.pose_b, open()) != truth.overlap) return name + ", cold";
    if (collide(strategy, c.a, c.pose_a, c.b, c.pose_b, old, open()) != truth.overlap) return name + ", old cache";
    StrategyCaches fresh;
    for (int i = 0; i < 3; ++i) {
      if (collide(strategy, c.a, c.pose_a, c.b, c.pose_b, fresh, open()) != truth.overlap)
        return name + ", with a cache";
      if (collide(strategy, c.a, c.pose_a, c.b, c.pose_b, fresh, closed()) != truth.meet)
        return name + ", closed again";
    }
    if (collide(strategy, c.b, c.pose_b, c.a, c.pose_a, fresh, open()) != truth.overlap)
      return name + ", cache, swapped";
  }
  return {};
}

class TouchingOracle : public testing::TestWithParam<Family> {};

TEST_P(TouchingOracle, AgreesWithExactRationals) {
  const int cases = scaledCount(kCases);
  int overlaps = 0, touches = 0, disagreements = 0;
  StrategyCaches old;
  for (int i = 0; i < cases; ++i) {
    const Case c = GetParam().make(static_cast<std::uint64_t>(i));
    const Truth truth{exact::collide(c.a, c.pose_a, c.b, c.pose_b), exact::interiorsMeet(c.a, c.pose_a, c.b, c.pose_b)};
    overlaps += truth.overlap;
    touches += truth.meet && !truth.overlap;
    ASSERT_LE(truth.overlap, truth.meet);
    const std::string wrong = wrongWay(c, truth, old);
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

std::string familyName(const testing::TestParamInfo<Family>& family) { return family.param.name; }

INSTANTIATE_TEST_SUITE_P(Families, TouchingOracle, testing::ValuesIn(touchingFamilies()), familyName);

}  // namespace
}  // namespace tricover::support
