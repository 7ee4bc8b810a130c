// SPDX-License-Identifier: BSD-3-Clause
// Scenes of every family against loops over the functions of pairs, which have oracles of their own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "families.h"
#include "scene_walk.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/segment.h"

namespace tricover::support {
namespace {

constexpr int kScenes = 4;
constexpr int kFrames = 120;

class SceneOracle : public testing::TestWithParam<Family> {};

/// How often scenes were asked, and what came of it.
struct Tally {
  void walk(const std::vector<Case>& cases, std::uint64_t seed, std::size_t bodies, int frames) {
    SceneWalk walk(cases, seed, bodies);
    for (int frame = 0; frame < frames && walk.wrong.empty(); ++frame) walk.frame();
    EXPECT_EQ(walk.wrong, "") << "scene " << seed;
    asked += walk.asked, hits += walk.hits, began += walk.began, ended += walk.ended;
    free += walk.free, inside += walk.inside, impacts += walk.impacts_found, rays += walk.rays;
  }
  void expectAllOutcomes(const char* name) const {
    std::printf("%-22s %6d answers %6d collisions %5d began %5d ended %5d free %5d inside %4d impacts %4d rays\n", name,
                asked, hits, began, ended, free, inside, impacts, rays);
    if (isScaledDown()) return;
    for (const int count : {hits, began, ended, free, inside, impacts, rays}) EXPECT_GE(count, 10);
  }

  int asked = 0, hits = 0, began = 0, ended = 0, free = 0, inside = 0, impacts = 0, rays = 0;
};

TEST_P(SceneOracle, SaysWhatAllPairsSay) {
  Tally tally;
  for (std::uint64_t seed = 100; seed < 100 + kScenes; ++seed) {
    std::vector<Case> cases;
    for (std::uint64_t k = 0; k < 3; ++k) cases.push_back(GetParam().make(seed * 3 + k));
    // The first one is large: its tree of boxes has several levels.
    const bool is_large = seed == 100;
    tally.walk(cases, seed, is_large ? 60 : 12, scaledCount(is_large ? kFrames / 8 : kFrames));
  }
  tally.expectAllOutcomes(GetParam().name);
}

/// Stars and regular polygons of many sizes, a point and a segment: of some scale, far from the origin or not.
TEST(SceneCrowds, SayWhatAllPairsSay) {
  for (const auto& [unit, away] : {std::pair(1.0, 0.0), {1.0, 1e9}, {1e-200, 0.0}, {1e200, -1e202}, {1e304, 0.0}}) {
    Random random(11);
    const auto place = [&, u = unit, far = away] {
      return pose(random.real(0, 6.28), far + u * random.real(-9, 9), far + u * random.real(-9, 9));
    };
    std::vector<Case> cases;
    for (int i = 0; i < 6; ++i) {
      const Ring ring = i % 2 == 0 ? star(random, 5 + 6 * i, 0.4, 1.2) : regular(4 + i, 1);
      const Polygon other = i < 2 ? point({0, 0}) : i < 4 ? segment({-unit, 0}, {unit, 0}) : cases[0].a;
      cases.push_back({Polygon({scaled(ring, unit * (i == 5 ? 8 : 1))}), place(), other, place()});
    }
    const bool is_slow = unit > 1e300;  // where doubles overflow every sign is found exactly
    Tally tally;
    tally.walk(cases, 1, is_slow ? 15 : 40, std::max(scaledCount(is_slow ? 60 : 120), 3));
    tally.expectAllOutcomes(hex(unit).c_str());
  }
}

INSTANTIATE_TEST_SUITE_P(Families, SceneOracle, testing::ValuesIn(families()),
                         [](const auto& family) { return family.param.name; });

}  // namespace
}  // namespace tricover::support
