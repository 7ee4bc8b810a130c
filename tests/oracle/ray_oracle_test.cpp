// SPDX-License-Identifier: BSD-3-Clause
// castRay() and castRayAll() against the exact reference, where signs vanish: rays through vertices, along edges, that
// start or end on them; and against collide() with the ray as a segment.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "exact_reference.h"
#include "families.h"
#include "random.h"
#include "ray_laws.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/ray.h"
#include "tricover/segment.h"

namespace tricover::support {
namespace {

constexpr int kCases = 150;
constexpr int kRaysEach = 8;

struct Tally {
  int rays = 0, misses = 0, inside = 0, hits = 0, disagreements = 0;
  int several = 0, touches = 0;  ///< rays of several intervals, and intervals of one point
};

void check(const Polygon& polygon, const Pose& pose, const Ray& ray, Tally& tally) {
  const std::optional<exact::FirstHit> truth = exact::castRay(polygon, pose, ray.from, ray.to);
  const std::optional<RayHit> hit = castRay(polygon, pose, ray.from, ray.to);
  ++tally.rays;
  ++(!truth ? tally.misses : truth->edge < 0 ? tally.inside : tally.hits);
  std::string wrong;
  if (hit.has_value() != truth.has_value())
    wrong = "hit or not";
  else if (collide(polygon, pose, segment(ray.from, ray.to), Pose::Identity()) != hit.has_value())
    wrong = "collide";
  else if (hit)
    wrong = wrongHit(polygon, pose, ray, *hit, *truth);
  const std::vector<exact::RayPart> parts = exact::castRayAll(polygon, pose, ray.from, ray.to);
  tally.several += parts.size() > 1;
  for (const exact::RayPart& part : parts) tally.touches += part.begin.fraction == part.end.fraction;
  if (wrong.empty()) {
    wrong = wrongIntervals(polygon, pose, ray, castRayAll(polygon, pose, ray.from, ray.to), parts);
    if (!wrong.empty()) wrong = "castRayAll: " + wrong;
  }
  if (wrong.empty() || ++tally.disagreements > 3) return;
  ADD_FAILURE() << wrong << ", hit " << (hit ? hit->edge : -2) << " at " << (hit ? hit->fraction : -1) << ", truth "
                << (truth ? truth->edge : -2) << " at " << (truth ? truth->fraction.get_d() : -1) << "\n"
                << reproduction({polygon, pose, segment(ray.from, ray.to), Pose::Identity()});
}

void expectAllOutcomes(const Tally& tally) {
  EXPECT_EQ(tally.disagreements, 0);
  if (tally.rays < 1000) return;
  for (const int count : {tally.misses, tally.inside, tally.hits}) EXPECT_GE(count, 0.05 * tally.rays);
  EXPECT_GE(tally.several + tally.touches, 0.01 * tally.rays);
}

class RayOracle : public testing::TestWithParam<Family> {};

TEST_P(RayOracle, AgreesWithExactRationals) {
  Tally tally;
  for (int i = 0; i < scaledCount(kCases); ++i) {
    const auto seed = static_cast<std::uint64_t>(i) + 4000000;
    const Case c = GetParam().make(seed);
    Random random(seed);
    for (int k = 0; k < kRaysEach; ++k) {
      const Ray at_a = anyRay(random, c.a, c.pose_a), at_b = anyRay(random, c.b, c.pose_b);
      if (at_a.from.allFinite() && at_a.to.allFinite()) check(c.a, c.pose_a, at_a, tally);
      if (at_b.from.allFinite() && at_b.to.allFinite()) check(c.b, c.pose_b, at_b, tally);
    }
  }
  std::printf("%-22s %6d rays %6d misses %6d inside %6d hits %6d of several parts %6d touches %4d disagreements\n",
              GetParam().name, tally.rays, tally.misses, tally.inside, tally.hits, tally.several, tally.touches,
              tally.disagreements);
  expectAllOutcomes(tally);
}

INSTANTIATE_TEST_SUITE_P(Families, RayOracle, testing::ValuesIn(families()),
                         [](const auto& family) { return family.param.name; });

/// Points, segments and rings without area, under poses of all kinds.
TEST(RayOracle, PointsAndSegments) {
  Tally tally;
  for (int i = 0; i < scaledCount(1500); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const auto grid = [&] { return Vec2(random.integer(-3, 3), random.integer(-3, 3)); };
    const Vec2 p = grid(), q = grid();
    const Polygon polygon = i % 3 == 0   ? point(p)
                            : i % 3 == 1 ? segment(p, q)
                                         : Polygon({{p, q, p, grid()}, {p, p, q}});
    Pose placed = random.coin() ? Pose::Identity() : pose(random.integer(0, 3) * M_PI / 2, random.integer(-2, 2), 1);
    if (random.oneIn(3)) placed = mirrored(distorted(random, placed));
    const Vec2 through = placed * (random.coin() ? p : q), from = random.oneIn(5) ? through : placed * grid();
    const double beyond = random.integer(0, 4) / 2.0;
    check(polygon, placed, {from, from + beyond * (placed * q - from)}, tally);
  }
  expectAllOutcomes(tally);
}

}  // namespace
}  // namespace tricover::support
