// SPDX-License-Identifier: BSD-3-Clause
// depth(), excess(), hausdorffDistance() and negative margins against exact overlays: of small polygons by candidates
// and by halving, which share no idea but the overlay; of larger ones by halving; and the laws over all families.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "depth_families.h"
#include "depth_laws.h"
#include "exact_covers.h"
#include "exact_depth.h"
#include "exact_reference.h"
#include "families.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/covers.h"
#include "tricover/depth.h"
#include "tricover/scene.h"
#include "tricover/segment.h"

namespace tricover::support {
namespace {

constexpr int kFamilyCases = 60;
constexpr int kSmallCases = 500;
constexpr int kLargeCases = 40;
constexpr EdgeIndex kMostEdges = 60;  // for the oracle

const Pose kHere = Pose::Identity();

Ring gridRing(Random& random, int n) {
  Ring ring;
  for (; n > 0; --n) ring.emplace_back(random.integer(-2, 2), random.integer(-2, 2));
  return ring;
}

/// Not convex, with holes, slits, crossings, edges used twice, or without an area.
Polygon smallPolygon(Random& random) {
  const FillRule fill = random.coin() ? FillRule::EvenOdd : FillRule::NonZero;
  switch (random.integer(0, 8)) {
    case 0:
      return Polygon({star(random, random.integer(3, 6), 0.3, 2)}, fill);
    case 1:
      return Polygon({comb(2, 0.5, 0.25, 1)}, fill);
    case 2:
      return Polygon({star(random, 4, 1.2, 2), eitherWay(random, star(random, 3, 0.3, 0.9))}, fill);
    case 3: {
      Ring ring;
      for (int i = random.integer(4, 5); i > 0; --i) ring.emplace_back(random.real(-1, 1), random.real(-1, 1));
      return Polygon({ring}, fill);
    }
    case 4:
      return Polygon({gridRing(random, random.integer(4, 7))}, fill);
    case 5:
      return Polygon({rectangle(-2, -1, 1, 1), gridRing(random, 3)}, fill);
    case 6:
      return random.oneIn(4) ? point({random.real(-1, 1), 0})
                             : segment({random.real(-2, 0), 0}, {1, random.real(-1, 1)});
    case 7: {
      // A square with a slit into it and a spike out of it.
      const double x = random.real(-1, 1);
      return Polygon({{{-1, -1}, {1, -1}, {1, 1}, {x, 1}, {x, 2}, {x, random.real(-1, 1)}, {x, 1}, {-1, 1}}}, fill);
    }
    default:
      return Polygon({anyConvex(random, random.real(0.3, 2), 6)}, fill);
  }
}

Polygon maybeOutside(Random& random, const Polygon& polygon) {
  if (!random.oneIn(6)) return polygon;
  try {
    return polygon.complement();
  } catch (const std::invalid_argument&) {
    return polygon;
  }
}

Case smallCase(Random& random) {
  const bool is_turned = random.coin();
  const double far = random.oneIn(8) ? 1e3 : 0;
  const auto near = [&] {
    const double x = random.integer(-6, 6) / 4.0, y = random.integer(-6, 6) / 4.0;
    Pose at = is_turned ? pose(random.real(0, 6.3), random.real(-1.5, 1.5), random.real(-1.5, 1.5)) : pose(0, x, y);
    at.translation() += Vec2(far, -far);
    return random.oneIn(4) ? mirrored(at) : random.oneIn(8) ? distorted(random, at) : at;
  };
  const Pose pose_a = near(), pose_b = near();
  const Polygon a = maybeOutside(random, smallPolygon(random)), b = maybeOutside(random, smallPolygon(random));
  return {a, pose_a, b, pose_b};
}

/// The first few failures of a test.
class Failures {
 public:
  void add(const std::string& what, int seed, const Case& c) {
    if (what.empty() || ++count_ > 3) return;
    ADD_FAILURE() << what << ", seed " << seed << "\n" << reproduction(c);
  }
  int count() const { return count_; }

 private:
  int count_ = 0;
};

TEST(ExactDepth, OfClosedForms) {
  const auto isAbout = [](const exact::Bracket& found, double truth) {
    return found.low <= truth + 1e-15 && found.high >= truth - 1e-15 && found.high - found.low <= 1e-15;
  };
  const Polygon a({{{0, 0}, {100, 0}, {10, 100}}}), b({{{0, 100}, {0, 10}, {80, 10}}});
  // As lines, there and back.
  const Polygon line_a({{{0, 0}, {100, 0}, {10, 100}, {100, 0}}}), line_b({{{0, 100}, {0, 10}, {80, 10}, {0, 10}}});
  EXPECT_NEAR(double(exact::excess(line_a, kHere, line_b, kHere).low), 910 / 19.0, 1e-14);
  EXPECT_NEAR(double(exact::excessByCandidates(line_a, kHere, line_b, kHere)), 910 / 19.0, 1e-14);
  EXPECT_NEAR(double(exact::excess(a, kHere, b, kHere).low), std::sqrt(500), 1e-14);
  EXPECT_TRUE(isAbout(exact::depth(box(2, 2), kHere, box(2, 2), pose(0, 1.5, 0)), 0.5));
  EXPECT_TRUE(isAbout(exact::depth(box(2, 2), kHere, box(2, 2), pose(0, 2, 0)), 0));
  EXPECT_TRUE(isAbout(exact::depth(box(4, 2), kHere, segment({0, 0.5}, {3, -1.5}), kHere), 1));
  EXPECT_TRUE(isAbout(exact::depth(box(4, 2), kHere, point({0, 0.5}), kHere), 0.5));
  EXPECT_TRUE(isAbout(exact::depth(box(4, 2).complement(), kHere, box(1, 1), pose(0, 2, 1)), std::sqrt(0.5)));
  const Polygon hole({regular(64, 4), regular(64, 3)});
  const exact::Bracket tied = exact::excess(box(1, 1), kHere, hole, kHere);
  EXPECT_NEAR(double(tied.low), 3 * std::cos(M_PI / 64), 1e-14);
  EXPECT_LE(tied.high - tied.low, 1e-15);
}

TEST(ExactDepth, HalvingAgreesWithCandidates) {
  int overlapping = 0, sticking_out = 0;
  const int cases = scaledCount(kSmallCases);
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i) + 1);
    const Case c = smallCase(random);
    const exact::Bracket deep = exact::depth(c.a, c.pose_a, c.b, c.pose_b),
                         out = exact::excess(c.a, c.pose_a, c.b, c.pose_b);
    ASSERT_EQ(out.low == 0, exact::covers({{c.b, c.pose_b, {}}}, c.a, c.pose_a, 0)) << reproduction(c);
    ASSERT_TRUE(deep.low > 0 || !exact::interiorsMeet(c.a, c.pose_a, c.b, c.pose_b)) << reproduction(c);
    ASSERT_TRUE(deep.low == 0 || exact::collide(c.a, c.pose_a, c.b, c.pose_b)) << reproduction(c);
    overlapping += deep.low > 0;
    sticking_out += out.low > 0;
    if (!std::isinf(deep.low)) {
      EXPECT_LE(deep.high - deep.low, 1e-14) << i << reproduction(c);
      EXPECT_NEAR(double(exact::depthByCandidates(c.a, c.pose_a, c.b, c.pose_b)), double(deep.low), 1e-13)
          << i << reproduction(c);
    }
    if (!std::isinf(out.low)) {
      EXPECT_LE(out.high - out.low, 1e-14) << i << reproduction(c);
      EXPECT_NEAR(double(exact::excessByCandidates(c.a, c.pose_a, c.b, c.pose_b)), double(out.low), 1e-13)
          << i << reproduction(c);
    }
  }
  std::printf("%d of %d overlap, %d stick out\n", overlapping, cases, sticking_out);
}

TEST(DepthOracle, SmallPolygonsAgreeWithTheOracle) {
  int overlapping = 0, inner = 0, of_a = 0, infinite = 0;
  Failures failures;
  const int cases = scaledCount(kSmallCases);
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i) + 1);
    const Case c = smallCase(random);
    const Depth found = depth(c.a, c.pose_a, c.b, c.pose_b);
    std::string wrong = wrongDepth(c, found);
    if (wrong.empty()) wrong = wrongLargest(c, found.depth, exact::depth(c.a, c.pose_a, c.b, c.pose_b));
    if (wrong.empty()) wrong = wrongBesideOthers(random, c, found);
    if (wrong.empty()) wrong = wrongMargins(random, c);
    failures.add(wrong, i, c);
    overlapping += found.depth > 0;
    infinite += std::isinf(found.depth);
    inner += found.depth > 0 && !std::isinf(found.depth) && (found.is_point_of_a ? found.edge_a : found.edge_b) == -1;
    of_a += found.depth > 0 && found.is_point_of_a;
  }
  std::printf("%d of %d overlap, %d infinite, %d with a deepest point inside, %d of a\n", overlapping, cases, infinite,
              inner, of_a);
  EXPECT_EQ(failures.count(), 0);
  if (isScaledDown()) return;
  EXPECT_GT(overlapping, 0.3 * cases);
  EXPECT_LT(overlapping, 0.7 * cases);
  EXPECT_GT(inner, 0);
  EXPECT_GT(of_a, 0.2 * overlapping);
  EXPECT_LT(of_a, 0.8 * overlapping);
}

TEST(DepthOracle, ExcessOfSmallPolygonsAgreesWithTheOracle) {
  int sticking_out = 0, covered = 0, inner = 0;
  Failures failures;
  const int cases = scaledCount(kSmallCases);
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i) + 1);
    Case c = smallCase(random);
    if (random.oneIn(3)) c = {Polygon({anyConvex(random, 0.3, 6)}), c.pose_a, c.b, c.pose_b};
    const Excess found = excess(c.a, c.pose_a, c.b, c.pose_b);
    std::string wrong = wrongExcess(c, found);
    if (wrong.empty()) wrong = wrongLargest(c, found.distance, exact::excess(c.a, c.pose_a, c.b, c.pose_b));
    if (wrong.empty()) wrong = wrongBesideOthers(random, c, found);
    if (wrong.empty()) wrong = wrongCoversButFor(c, found);
    failures.add(wrong, i, c);
    sticking_out += found.distance > 0;
    covered += found.distance == 0;
    inner += found.distance > 0 && !std::isinf(found.distance) && found.edge == -1;
  }
  std::printf("%d of %d stick out, %d are covered, %d farthest inside\n", sticking_out, cases, covered, inner);
  EXPECT_EQ(failures.count(), 0);
  if (isScaledDown()) return;
  EXPECT_GT(covered, 0.08 * cases);
  EXPECT_GT(inner, 0);
}

TEST(DepthOracle, LargerOutlinesAgreeWithTheOracle) {
  Failures failures;
  int overlapping = 0;
  const int cases = scaledCount(kLargeCases);
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i) + 1);
    const auto outline = [&] {
      const int n = random.integer(20, 60);
      return random.coin() ? Polygon({star(random, n, 1.7, 2)})
                           : Polygon({star(random, n, 1.7, 2), star(random, 10, 0.5, 1)});
    };
    const Case c{outline(), kHere, outline(),
                 pose(random.real(0, 6.3), random.real(-2.5, 2.5), random.real(-2.5, 2.5))};
    const Depth found = depth(c.a, c.pose_a, c.b, c.pose_b);
    std::string wrong = wrongDepth(c, found);
    if (wrong.empty()) wrong = wrongLargest(c, found.depth, exact::depth(c.a, c.pose_a, c.b, c.pose_b));
    if (wrong.empty())
      wrong =
          wrongLargest(c, excess(c.a, c.pose_a, c.b, c.pose_b).distance, exact::excess(c.a, c.pose_a, c.b, c.pose_b));
    failures.add(wrong, i, c);
    overlapping += found.depth > 0;
  }
  std::printf("%d of %d overlap\n", overlapping, cases);
  EXPECT_EQ(failures.count(), 0);
}

/// The distance from a union is the least of the distances, and that from rings of the non-zero rule.
TEST(DepthOracle, UnionsCoverAllButTheExcess) {
  int gaps = 0;
  const int cases = scaledCount(kSmallCases / 2);
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i) + 1);
    std::vector<Ring> rings;
    Scene scene;
    for (int n = random.integer(1, 4); n > 0; --n) {
      const Vec2 center(random.real(-1, 1), random.real(-1, 1));
      rings.push_back(random.coin() ? star(random, 6, 0.5, 1.5, center) : shifted(rectangle(-1, -0.5, 1, 0.5), center));
      scene.add(Polygon({rings.back()}), kHere);
    }
    const Polygon area(rings, FillRule::NonZero), part({star(random, 5, 0.3, 1.2)});
    const Pose at = pose(random.real(0, 6.3), random.real(-1, 1), random.real(-1, 1));
    const auto truth = static_cast<double>(exact::excess(part, at, area, kHere).low);
    EXPECT_NEAR(excess(part, at, area, kHere).distance, truth, 1e-14) << i;
    EXPECT_EQ(scene.covers(part, at), truth == 0) << i;
    if (truth == 0) continue;
    ++gaps;
    for (const double factor : {0.5, 1 - 1e-9, 1 + 1e-9, 2.0}) {
      EXPECT_EQ(scene.covers(part, at, {-factor * truth}), factor > 1) << i << ", " << factor;
      EXPECT_EQ(covers(area, kHere, part, at, {-factor * truth}), factor > 1) << i << ", " << factor;
    }
  }
  std::printf("%d of %d have gaps\n", gaps, cases);
}

class DepthFamilies : public testing::TestWithParam<Family> {};

TEST_P(DepthFamilies, KeepTheLaws) {
  Failures failures;
  int asked = 0, overlapping = 0, covered = 0;
  const int cases = scaledCount(kFamilyCases);
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i) + 5);
    const Case c = pushedTogether(random, GetParam().make(static_cast<std::uint64_t>(i) + 5));
    // Sums of coordinates must not overflow here.
    if (!(depthPrecision(c) < 1e292)) continue;
    ++asked;
    const Depth found = depth(c.a, c.pose_a, c.b, c.pose_b);
    const Excess out = excess(c.a, c.pose_a, c.b, c.pose_b);
    std::string wrong = wrongDepth(c, found);
    if (wrong.empty()) wrong = wrongBesideOthers(random, c, found);
    if (wrong.empty()) wrong = wrongMargins(random, c);
    if (wrong.empty()) wrong = wrongExcess(c, out);
    if (wrong.empty()) wrong = wrongBesideOthers(random, c, out);
    if (wrong.empty()) wrong = wrongCoversButFor(c, out);
    if (wrong.empty() && c.a.edgeCount() + c.b.edgeCount() <= kMostEdges) {
      wrong = wrongLargest(c, found.depth, exact::depth(c.a, c.pose_a, c.b, c.pose_b));
      if (wrong.empty()) wrong = wrongLargest(c, out.distance, exact::excess(c.a, c.pose_a, c.b, c.pose_b));
    }
    failures.add(wrong, i, c);
    overlapping += found.depth > 0;
    covered += out.distance == 0;
  }
  std::printf("%-22s %d of %d overlap, %d covered, %d failures\n", GetParam().name, overlapping, asked, covered,
              failures.count());
  EXPECT_EQ(failures.count(), 0);
  if (isScaledDown()) return;
  EXPECT_GT(overlapping, asked / 5);
  EXPECT_LT(overlapping, 0.97 * asked + 1);
}

INSTANTIATE_TEST_SUITE_P(All, DepthFamilies, testing::ValuesIn(families()),
                         [](const auto& family) { return family.param.name; });
INSTANTIATE_TEST_SUITE_P(Own, DepthFamilies, testing::ValuesIn(depthFamilies()),
                         [](const auto& family) { return family.param.name; });

}  // namespace
}  // namespace tricover::support
