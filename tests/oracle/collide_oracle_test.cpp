// SPDX-License-Identifier: BSD-3-Clause
// collide() against the exact reference: every family, both orders, both strategies, cold and with caches that saw
// other poses and other pairs.
#include <gtest/gtest.h>

#include <cstdio>
#include <utility>

#include "exact_reference.h"
#include "families.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "stages.h"
#include "strategies.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/prepare.h"

namespace tricover::support {
namespace {

constexpr int kCases = 5000;
constexpr double kRareOutcome = 0.15;

/// b near where it is: certificates about these poses are about to be used at the case's own.
Pose elsewhere(Random& random, const Case& c) {
  const double size = std::min(c.a.radius(), c.b.radius()) * (random.coin() ? 1e-3 : 1.0);
  Pose result = pose(random.real(-1, 1) * (random.coin() ? 1e-3 : 1.0), 0, 0) * c.pose_b;  // as rigid as that is
  const Vec2 moved = c.pose_b.translation() + Vec2(random.real(-size, size), random.real(-size, size));
  if (moved.allFinite()) result.translation() = moved;
  return result;
}

/// The first way of asking that gives another answer than `truth`; empty if there is none.
std::string wrongWay(const Case& c, std::uint64_t seed, bool truth, StrategyCaches& old) {
  Random random(~seed);
  for (const auto stages : {detail::Stages::Edges, detail::Stages::Hierarchy}) {
    const UpTo these(stages);
    const std::string name = stages == detail::Stages::Edges ? "edges alone" : "without discs";
    if (collide(c.a, c.pose_a, c.b, c.pose_b) != truth) return name;
    if (collide(c.b, c.pose_b, c.a, c.pose_a) != truth) return name + ", swapped";
    PairCache fresh;
    for (int i = 0; i < 2; ++i)
      if (collide(c.a, c.pose_a, c.b, c.pose_b, fresh) != truth) return name + ", with a cache";
  }
  for (const Strategy strategy : {Strategy::Hierarchy, Strategy::Paper}) {
    const std::string name = nameOf(strategy);
    if (collide(strategy, c.a, c.pose_a, c.b, c.pose_b) != truth) return name + ", cold";
    if (collide(strategy, c.b, c.pose_b, c.a, c.pose_a) != truth) return name + ", cold, swapped";
    if (collide(strategy, c.a, c.pose_a, c.b, c.pose_b, old) != truth) return name + ", cache of other pairs";
    StrategyCaches fresh;
    for (int i = 0; i < 3; ++i) collide(strategy, c.a, c.pose_a, c.b, elsewhere(random, c), fresh);
    if (collide(strategy, c.a, c.pose_a, c.b, c.pose_b, fresh) != truth) return name + ", cache of other poses";
    if (collide(strategy, c.b, c.pose_b, c.a, c.pose_a, fresh) != truth) return name + ", that cache again, swapped";
  }
  if (contacts(c.a, c.pose_a, c.b, c.pose_b).empty() == truth) return "contacts";
  if (contacts(c.b, c.pose_b, c.a, c.pose_a).empty() == truth) return "contacts, swapped";
  // With the discs of those that don't meet, too.
  prepare(c.a), prepare(c.b);
  if (collide(c.a, c.pose_a, c.b, c.pose_b) != truth) return "prepared";
  if (collide(c.b, c.pose_b, c.a, c.pose_a) != truth) return "prepared, swapped";
  return {};
}

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
    const std::string wrong = wrongWay(c, seed, truth, old);
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

std::string familyName(const testing::TestParamInfo<Family>& family) { return family.param.name; }

INSTANTIATE_TEST_SUITE_P(Families, CollideOracle, testing::ValuesIn(families()), familyName);

}  // namespace
}  // namespace tricover::support
