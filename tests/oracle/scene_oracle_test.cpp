// SPDX-License-Identifier: BSD-3-Clause
// Scenes of every family against loops over the functions of pairs, which have oracles of their own.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "families.h"
#include "scene_walk.h"
#include "test_scale.h"

namespace tricover::support {
namespace {

constexpr int kScenes = 4;
constexpr int kFrames = 120;

class SceneOracle : public testing::TestWithParam<Family> {};

TEST_P(SceneOracle, SaysWhatAllPairsSay) {
  int asked = 0, hits = 0, began = 0, ended = 0, free = 0, inside = 0, impacts = 0, rays = 0;
  for (int i = 0; i < kScenes; ++i) {
    const auto seed = static_cast<std::uint64_t>(i) + 100;
    std::vector<Case> cases;
    for (std::uint64_t k = 0; k < 3; ++k) cases.push_back(GetParam().make(seed * 3 + k));
    // The first one is large: its tree of boxes has several levels.
    SceneWalk walk(cases, seed, i == 0 ? 60 : 12);
    const int frames = scaledCount(i == 0 ? kFrames / 8 : kFrames);
    for (int frame = 0; frame < frames && walk.wrong.empty(); ++frame) walk.frame();
    EXPECT_EQ(walk.wrong, "") << "scene " << i;
    asked += walk.asked, hits += walk.hits, began += walk.began, ended += walk.ended;
    free += walk.free, inside += walk.inside, impacts += walk.impacts_found, rays += walk.rays;
  }
  std::printf("%-22s %6d answers %6d collisions %5d began %5d ended %5d free %5d inside %4d impacts %4d rays\n",
              GetParam().name, asked, hits, began, ended, free, inside, impacts, rays);
  if (isScaledDown()) return;
  for (const int count : {hits, began, ended, free, inside, impacts, rays}) EXPECT_GE(count, 10);
}

std::string familyName(const testing::TestParamInfo<Family>& family) { return family.param.name; }

INSTANTIATE_TEST_SUITE_P(Families, SceneOracle, testing::ValuesIn(families()), familyName);

}  // namespace
}  // namespace tricover::support
