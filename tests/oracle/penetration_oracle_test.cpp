// SPDX-License-Identifier: BSD-3-Clause
// penetration() against brute force on rationals, and its promises: the translation parts them, shorter ones don't,
// swapping the operands mirrors the result.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>
#include <vector>

#include "contact_laws.h"
#include "exact_penetration.h"
#include "exact_reference.h"
#include "families.h"
#include "penetration_laws.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/penetration.h"

namespace tricover::support {
namespace {

constexpr int kFamilyCases = 300;
constexpr int kBruteForceCases = 600;
constexpr int kConvexCases = 3000;

class PenetrationFamilies : public testing::TestWithParam<Family> {};

TEST_P(PenetrationFamilies, KeepsItsPromises) {
  int overlapping = 0, deep = 0, optimal = 0, broken = 0;
  const int cases = scaledCount(kFamilyCases);
  for (int i = 0; i < cases; ++i) {
    const auto seed = static_cast<std::uint64_t>(i) + 77;
    Random random(seed);
    Case c = GetParam().make(seed);
    const double smaller = std::min(c.a.radius(), c.b.radius());
    // Contacts are shallow; half of them are pushed together.
    if (i % 2 == 0) {
      const Vec2 way = c.pose_a * c.a.origin() - c.pose_b * c.b.origin();
      const double apart = way.stableNorm();
      if (apart > 0 && std::isfinite(apart))
        c.pose_b.translation() += way * (std::min(smaller / apart, 1.0) * random.unit());
    }
    const auto p = penetration(c.a, c.pose_a, c.b, c.pose_b);
    std::string what = wrongPenetration(random, c, 0, p, 8);
    if (what.empty() && p) what = wrongSwapped(c, *p);
    if (what.empty() && i % 25 == 0) {
      const double size = std::min(std::max(c.a.radius(), c.b.radius()), 1e140), margin = random.unit() * size;
      what = wrongPenetration(random, c, margin, penetration(c.a, c.pose_a, c.b, c.pose_b, {margin}), 2);
      if (!what.empty()) what += " with the margin " + hex(margin);
    }
    if (!what.empty() && ++broken <= 3) ADD_FAILURE() << what << "\n" << reproduction(c);
    if (!p) continue;
    ++overlapping;
    deep += p->depth > 1e-6 * smaller;
    optimal += p->optimal;
  }
  EXPECT_EQ(broken, 0);
  std::printf("%d of %d overlap, %d deep, %d optimal\n", overlapping, cases, deep, optimal);
  if (cases == kFamilyCases) {
    EXPECT_GT(overlapping, cases / 4);
    EXPECT_GT(deep, cases / 10);
  }
  EXPECT_GE(optimal, 0.98 * overlapping);
}

INSTANTIATE_TEST_SUITE_P(All, PenetrationFamilies, testing::ValuesIn(families()),
                         [](const auto& family) { return family.param.name; });

/// A few vertices, most of them not convex, with holes and with outlines that cross themselves.
Polygon smallPolygon(Random& random) {
  const FillRule fill = random.coin() ? FillRule::EvenOdd : FillRule::NonZero;
  switch (random.integer(0, 4)) {
    case 0:
      return Polygon({star(random, random.integer(4, 6), 0.3, 2)}, fill);
    case 1:
      return Polygon({comb(2, 0.5, 0.25, 1)}, fill);
    case 2: {
      Ring hole = reversed(star(random, 3, 0.3, 0.9));
      return Polygon({star(random, 4, 1.2, 2), hole}, fill);
    }
    case 3: {
      Ring ring;
      for (int i = random.integer(4, 5); i > 0; --i) ring.emplace_back(random.real(-1, 1), random.real(-1, 1));
      return Polygon({ring}, fill);
    }
    default: {
      Ring ring;
      for (int i = random.integer(4, 6); i > 0; --i) ring.emplace_back(random.integer(-2, 2), random.integer(-2, 2));
      return Polygon({ring}, fill);
    }
  }
}

TEST(PenetrationOracle, SmallPolygonsAgreeWithBruteForce) {
  int overlapping = 0, below_hulls = 0, broken = 0;
  double worst = 0;
  for (int i = 0; i < scaledCount(kBruteForceCases); ++i) {
    const auto seed = static_cast<std::uint64_t>(i) + 1;
    Random random(seed);
    const bool turned = random.coin();
    const auto anyPoseNear = [&] {
      const double x = random.integer(-4, 4) / 4.0, y = random.integer(-4, 4) / 4.0;
      Pose result = turned ? pose(random.real(0, 6.3), random.real(-1, 1), random.real(-1, 1)) : pose(0, x, y);
      return random.oneIn(4) ? mirrored(result) : result;
    };
    const Case c{smallPolygon(random), anyPoseNear(), smallPolygon(random), anyPoseNear()};
    const auto p = penetration(c.a, c.pose_a, c.b, c.pose_b);
    ASSERT_EQ(p.has_value(), exact::collide(c.a, c.pose_a, c.b, c.pose_b)) << reproduction(c);
    if (!p) continue;
    ++overlapping;
    const double bound = (1 + 1e-9) * exact::hullDepth(c.a, c.pose_a, c.b, c.pose_b);
    below_hulls += p->depth < (1 - 1e-9) * bound;
    EXPECT_TRUE(p->optimal) << reproduction(c);
    const double truth = exact::penetrationDepth(c.a, c.pose_a, c.b, c.pose_b, bound);
    const double error = std::abs(p->depth - truth) / (c.a.radius() + c.b.radius());
    worst = std::max(worst, error);
    std::string what = error <= 1e-11 ? wrongPenetration(random, c, 0, p, 64) : "depth";
    if (what.empty()) what = wrongSwapped(c, *p);
    if (!what.empty() && ++broken <= 3)
      ADD_FAILURE() << what << ": depth " << hex(p->depth) << ", truth " << hex(truth) << ", seed " << seed << "\n"
                    << reproduction(c);
  }
  EXPECT_EQ(broken, 0);
  std::printf("%d overlap, %d less deep than their hulls; worst error %.2g of the size\n", overlapping, below_hulls,
              worst);
  EXPECT_GT(below_hulls, overlapping / 3);
  EXPECT_GT(overlapping, scaledCount(kBruteForceCases) / 2);
}

/// Searches so long that the regions are covered by discs.
TEST(PenetrationOracle, ManyVerticesDeepInEachOther) {
  for (int i = 0; i < scaledCount(6); ++i) {
    Random random(static_cast<std::uint64_t>(i) + 1);
    const auto outline = [&] { return Polygon({star(random, 250, 1.9, 2), reversed(star(random, 20, 0.2, 0.5))}); };
    const Case c{outline(), pose(1, 3e5, -2e5), outline(), pose(random.real(0, 6.3), 3e5, -2e5 + random.unit())};
    const auto p = penetration(c.a, c.pose_a, c.b, c.pose_b);
    ASSERT_TRUE(p);
    EXPECT_TRUE(p->optimal);
    ASSERT_EQ(wrongPenetration(random, c, 0, p, 200), "") << reproduction(c);
  }
}

/// Squares of size 1 in a grid of pitch 2, some left out: translations overlap on whole cells of that grid, each by as
/// many pairs of squares as are that far from each other. The nearest cell that none is on is known.
TEST(PenetrationOracle, OfRepeatedPartsLeadsToTheNearestCellThatIsFree) {
  int overlapping = 0, far = 0;
  for (int i = 0; i < scaledCount(40); ++i) {
    Random random(static_cast<std::uint64_t>(i) + 1);
    const int n = random.integer(4, 12), cells = 2 * n + 1;
    const double share = random.real(0.3, 1);
    std::vector<std::pair<int, int>> places[2];
    std::vector<Ring> rings[2];
    for (const int side : {0, 1})
      for (int k = 0; k < n * n; ++k) {
        if (k > 0 && random.unit() > share) continue;
        const int x = k % n, y = k / n;
        places[side].emplace_back(x, y);
        rings[side].push_back(rectangle(2 * x, 2 * y, 2 * x + 1, 2 * y + 1));
      }
    std::vector<char> taken(static_cast<std::size_t>(cells * cells));
    for (const auto& [x, y] : places[0])
      for (const auto& [u, v] : places[1]) taken[static_cast<std::size_t>((y - v + n) * cells + x - u + n)] = true;
    const Vec2 shift(random.real(-1, 1), random.real(-1, 1));
    double truth = 4 * n;
    for (int x = -n; x <= n; ++x)
      for (int y = -n; y <= n; ++y)
        if (!taken[static_cast<std::size_t>((y + n) * cells + x + n)])
          truth = std::min(truth, ((shift - 2 * Vec2(x, y)).cwiseAbs().cwiseMax(1) - Vec2(1, 1)).norm());
    const Pose frame = random.coin() ? Pose::Identity() : pose(random.real(0, 6.3), 5, -7);
    const Case c{Polygon(rings[0]), frame, Polygon(rings[1]), moved(frame, frame.linear() * shift)};
    const auto p = penetration(c.a, c.pose_a, c.b, c.pose_b);
    ASSERT_EQ(p.has_value(), truth > 0) << i;
    if (!p) continue;
    ++overlapping;
    far += truth > 4;
    EXPECT_TRUE(p->optimal) << i;
    EXPECT_NEAR(p->depth, truth, 1e-11 * n) << i;
    EXPECT_EQ(wrongSwapped(c, *p), "") << i;
    EXPECT_EQ(wrongPenetration(random, c, 0, p, 64), "") << i;
  }
  std::printf("%d overlap, %d by many squares\n", overlapping, far);
  if (scaledCount(40) == 40) {
    EXPECT_GE(overlapping, 20);
    EXPECT_GE(far, 10);
  }
}

/// A polygon of 1e-11 beside one of 1, of which soak found that a shorter way than the one that was said to be optimal
/// parts them: between edges so close together that what lies between them was never sampled.
TEST(PenetrationOracle, AWayBetweenEdgesThatAreCloseTogetherIsFound) {
  const Polygon a({{{-0x1.00f8dd2c678a6p-41, 0x1.bc2d38ad0ed9cp-41},
                    {-0x1.7ba2bb4aae467p-39, 0x1.c049f42ddd318p-41},
                    {-0x1.14aa9de57e3ecp-37, 0x1.bc1b15702f636p-41},
                    {-0x1.1ee36f5ee6551p-37, 0x1.b6dabb11a988p-41},
                    {-0x1.5f0ff0c765ae4p-38, 0x1.b09b3a8efdbdbp-41},
                    {-0x1.c6520f3a68e84p-40, 0x1.b2311b5527982p-41}},
                   {{0x1.738922b887af1p-40, -0x1.4f6a94a8f6398p-39},
                    {-0x1.02386faf6ce2cp-38, 0x1.4a2a9ff617a36p-40},
                    {-0x1.3b903ec5d76f7p-38, 0x1.83bce2d17a15fp-40},
                    {-0x1.64472a1a86899p-38, 0x1.ab6035e21e491p-40},
                    {-0x1.3b990f2be4387p-39, -0x1.0073eebccb683p-39},
                    {0x1.e3fd9d2dc9fd8p-40, 0x1.7908851848953p-40},
                    {-0x1.7d19d1d6bd1eep-43, 0x1.5f9312576c341p-41},
                    {0x1.208dac988a35dp-40, 0x1.84135534da99p-39},
                    {-0x1.d5962760d6209p-40, 0x1.eb9c2988e2273p-40}},
                   {{0x1.1108d1d45d67ep-39, 0x1.716eac8be9c7bp-39},
                    {-0x1.888a7d4a82f86p-38, 0x1.57592bb8a4a7ep-38},
                    {0x1.7ba219ad2870cp-40, 0x1.17520895fa426p-41}}},
                  FillRule::EvenOdd);
  const Pose pose_a =
      pose(0x1.1a62633145c07p-54, 0x1p+0, -0x1.0495fbd43a622p+1, 0x1p+0, -0x1.1a62633145c07p-54, 0x1.91682f665e0aap+2);
  const Polygon b({{{0x1.8f38a723df3f6p-1, 0x1.db0e6109bfba8p-1},
                    {-0x1.17ac29407c11p-3, -0x1.fe95c008ecf18p-2},
                    {0x1.1d2cbccaefe64p-1, 0x1.3b082cddba532p-1},
                    {-0x1.464fef9f350ap-3, 0x1.0426dbca9c4dp-1},
                    {0x1.9b29bc668ae7p-3, 0x1.6a67be2acfd1p-2},
                    {-0x1.f5171869325ap-4, 0x1.3d089fa3cee02p-1},
                    {-0x1.d6e999cb73394p-1, -0x1.41ae0fc08192p-3}}},
                  FillRule::NonZero);
  const Pose pose_b = pose(0x1p+0, 0x0p+0, -0x1.4be12b06f59f3p+1, 0x0p+0, 0x1p+0, 0x1.6a0729caa7394p+2);
  const auto p = penetration(a, pose_a, b, pose_b);
  ASSERT_TRUE(p);
  const Vec2 way = 9.75e-12 * Vec2(std::cos(0.2), std::sin(0.2));
  ASSERT_FALSE(exact::collide(a, pose_a, b, moved(pose_b, way)));
  EXPECT_LE(p->depth, way.norm());
  EXPECT_LE(p->lower_bound, way.norm());
}

/// A polygon of 4e-11, whose edges make lines that are taken for one, in one of 80: it leaves past its nearest edge.
TEST(PenetrationOracle, AWayPastLinesThatAreTakenForOneIsFound) {
  const Polygon a({{{0x1.31562653a5387p+5, 0x1.ca01397d77d4ap+4},
                    {0x1.31562653a5387p+5, -0x1.31562653a5387p+5},
                    {0x1.31562653a5387p+3, -0x1.31562653a5387p+3},
                    {0x0p+0, 0x1.ca01397d77d4ap+4},
                    {-0x1.ca01397d77d4ap+4, -0x1.ca01397d77d4ap+4},
                    {-0x1.ca01397d77d4ap+4, 0x1.ca01397d77d4ap+4},
                    {-0x1.ca01397d77d4ap+4, 0x1.31562653a5387p+3},
                    {0x1.31562653a5387p+4, -0x1.31562653a5387p+4}}},
                  FillRule::EvenOdd);
  const Pose pose_a = pose(0x1p+0, -0x0p+0, 0x1.3397f83709da6p+7, 0x0p+0, 0x1p+0, 0x1.15d13e9afa134p+6);
  const Polygon b({{{-0x1.7e4bbfc970b09p-36, 0x1.75bf4a6f6e2b8p-40},
                    {0x1.e4781ada59ed2p-36, -0x1.726607e9a004fp-41},
                    {-0x1.95c0d8aba319ap-39, -0x1.2ba75b13f5896p-36},
                    {0x1.003c110a1eae5p-35, -0x1.956ce4494df8cp-38},
                    {0x1.08caef9321663p-35, 0x1.5d3cadb65ec1fp-35},
                    {0x1.bd1b5c7567316p-36, -0x1.338228c8d5ee7p-37},
                    {0x1.32e298c768353p-37, -0x1.cfd3424fd530cp-40}}},
                  FillRule::EvenOdd);
  const Pose pose_b = pose(0x1.ffd3c2076e867p-1, -0x1.a9a88387cde2dp-6, 0x1.2c40a706d47d7p+7, 0x1.a9a88387cde2dp-6,
                           0x1.ffd3c2076e867p-1, 0x1.6ac6ad402f2f2p+6);
  const auto p = penetration(a, pose_a, b, pose_b);
  ASSERT_TRUE(p);
  const Vec2 way = 0.02 * Vec2(-0.894427191, 0.4472135955);
  ASSERT_FALSE(exact::collide(a, pose_a, b, moved(pose_b, way)));
  EXPECT_LE(p->depth, way.norm());
}

/// Beside an edge of 1e-9: brute force has to look nearer than that.
TEST(PenetrationOracle, BruteForceSeesTheNextFaceAsAnother) {
  const Polygon a({{{0x1.3f0a7b3c0c3c4p-3, -0x1.f9bfcee85dc07p-1},
                    {-0x1.dda3c39fd0a9dp-1, 0x1.70ce109c008acp-2},
                    {-0x1.dda3c21a14b97p-1, 0x1.70ce142e33bc4p-2},
                    {0x1.fffbce3af32dcp-1, 0x1.3461798049ea8p-9},
                    {0x1.fffdf6f2e55a3p-1, 0x1.31b51e8205fcp-9}}},
                  FillRule::NonZero);
  const Pose pose_a =
      pose(0x1.c94344a253c13p-1, -0x1.ccac21c639c3p-2, 0x0p+0, 0x1.ccac21c639c3p-2, 0x1.c94344a253c13p-1, 0x0p+0);
  const Polygon b({{{-0x1.b2cb9415a91eep-3, -0x1.b2cb9415a91eep-1},
                    {0x1.b2cb9415a91eep-3, 0x1.b2cb9415a91eep-2},
                    {-0x1.b2cb9415a91eep-3, 0x1.b2cb9415a91eep-3},
                    {-0x1.b2cb9415a91eep-1, -0x1.b2cb9415a91eep-1},
                    {-0x1.b2cb9415a91eep-1, 0x1.b2cb9415a91eep-2},
                    {-0x1.4618af103ed72p-1, 0x0p+0}}},
                  FillRule::EvenOdd);
  const Pose pose_b = pose(0x1p+0, 0x0p+0, -0x1.90d5cfbfa4c9ep-1, 0x0p+0, 0x1p+0, 0x1.809aebc50cf3cp-1);
  const auto p = penetration(a, pose_a, b, pose_b);
  ASSERT_TRUE(p);
  EXPECT_NEAR(p->depth, exact::penetrationDepth(a, pose_a, b, pose_b, 1), 1e-16);
}

TEST(PenetrationOracle, ConvexPairsAreExactToRounding) {
  int overlapping = 0, shallow = 0;
  double worst = 0;
  for (int i = 0; i < scaledCount(kConvexCases); ++i) {
    Random random(static_cast<std::uint64_t>(i) + 1);
    const double scale = std::ldexp(1.0, random.integer(-3, 3) * (random.oneIn(3) ? 100 : 1));
    const double offset = random.oneIn(4) ? 1e9 : 1;
    const auto convex = [&] { return eitherWay(random, anyConvex(random, random.real(0.1, 2) * scale, 12)); };
    Case c{Polygon({convex()}), randomPose(random, offset * scale), Polygon({convex()}), randomPose(random, 0)};
    const Vec2 way = pose(random.real(0, 6.3), 0, 0).linear().col(0) * (random.unit() * (c.a.radius() + c.b.radius()));
    c.pose_b.translation() = c.pose_a.translation() + way;
    if (random.coin())
      if (const auto deep = penetration(c.a, c.pose_a, c.b, c.pose_b))
        c.pose_b.translation() += (1 - std::exp2(random.real(-40, 0))) * deep->translation;
    const auto p = penetration(c.a, c.pose_a, c.b, c.pose_b);
    ASSERT_EQ(p.has_value(), exact::collide(c.a, c.pose_a, c.b, c.pose_b)) << reproduction(c);
    if (!p) continue;
    ++overlapping;
    shallow += p->depth < 1e-3 * scale;
    const double truth = exact::distanceBelow(exact::convexPenetrationSquared(c.a, c.pose_a, c.b, c.pose_b));
    worst = std::max(worst, std::abs(p->depth - truth) / truth);
    EXPECT_LE(std::abs(p->depth - truth), 1e-14 * truth) << reproduction(c);
    EXPECT_TRUE(p->optimal && p->lower_bound == p->depth);
    EXPECT_EQ(wrongPenetration(random, c, 0, p, 8) + wrongSwapped(c, *p), "") << reproduction(c);
  }
  std::printf("%d overlap, %d shallow; worst relative error %.2g\n", overlapping, shallow, worst);
  EXPECT_GT(overlapping, scaledCount(kConvexCases) / 3);
  EXPECT_GT(shallow, 0);
}

TEST(ConvexPenetration, AnEdgeAsShortAsAnUlpHasADirection) {
  const Polygon a({{{0x1.6f0162db005e8p-2, -0x1.c45915f50a2dep-1},
                    {-0x1.aae001de5d8aep-1, -0x1.0b8a668433c89p-1},
                    {-0x1.a7e031af1c978p-5, 0x1.e3e36b1c9619bp-1},
                    {0x1.b1383d9efa2cfp-1, 0x1.8d5be81265534p-2},
                    {0x1.b1384573d6861p-1, 0x1.8d5bdbf212c45p-2},
                    {0x1.c468ef2d5a797p-1, 0x1.c47dbabf05efep-3}}});
  const Pose pose_a =
      pose(0x1.c49c483786082p-1, -0x1.deb27cc02b8b3p-2, 0x0p+0, 0x1.deb27cc02b8b3p-2, 0x1.c49c483786082p-1, 0x0p+0);
  const Polygon b({{{0x1.4d507e1461a11p-1, 0x0p+0},
                    {0x1.4d507e1461a12p-2, 0x1.7a593731e3ffdp-3},
                    {-0x1.4d507e1461a0ep-2, 0x1.7a593731e3fffp-3},
                    {-0x1.4d507e1461a11p-1, 0x1.e1e7d7b867078p-56},
                    {-0x1.4d507e18742fbp-2, -0x1.7a59372d44957p-3},
                    {-0x1.4d507e0c3c84dp-2, -0x1.7a593731e3ffcp-3},
                    {0x1.4d507e1461a11p-2, -0x1.7a593731e3ffdp-3},
                    {0x1.4d507e1461a12p-2, -0x1.7a593731e3ffdp-3}}});
  const Pose pose_b = pose(-0x1.ef1c780d0c76cp-1, 0x1.04b258affea67p-2, 0x1.e40eedade9c03p-2, -0x1.04a2ef76ae28p-2,
                           -0x1.ef257f6a191ddp-1, -0x1.be8931b6a88a7p-1);
  const auto p = penetration(a, pose_a, b, pose_b);
  ASSERT_TRUE(p);
  const double truth = exact::distanceBelow(exact::convexPenetrationSquared(a, pose_a, b, pose_b));
  EXPECT_LE(std::abs(p->depth - truth), 1e-15 * truth);
}

}  // namespace
}  // namespace tricover::support
