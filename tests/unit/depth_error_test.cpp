// SPDX-License-Identifier: BSD-3-Clause
// Penetrations that may be deeper than the shortest way, by PenetrationOptions::depth_error.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "random.h"
#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/penetration.h"

namespace tricover::support {
namespace {

const Pose kIdentity = Pose::Identity();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Pose at(double x, double y) { return pose(0, x, y); }

const Polygon& square() {
  static const Polygon polygon({rectangle(-1, -1, 1, 1)});
  return polygon;
}

/// Ten wide, with a hole of six in the middle.
const Polygon& frame() {
  static const Polygon polygon({rectangle(0, 0, 10, 10), rectangle(2, 2, 8, 8)});
  return polygon;
}

TEST(DepthError, EveryResultIsABound) {
  for (const double error : {kInfinity, 10.0, 1.0, 0.3, 0.1, 1e-3, 1e-15, 0.0}) {
    const auto p = penetration(frame(), kIdentity, square(), at(1.5, 5), {0, error});
    ASSERT_TRUE(p);
    EXPECT_GE(p->depth, 1.5 - 1e-12);
    EXPECT_LE(p->depth, 2.5 + 1e-12);
    EXPECT_LE(p->lower_bound, 1.5);
    EXPECT_LE(p->depth / (1 + error), p->lower_bound + 1e-11);
    EXPECT_EQ(p->optimal, p->depth - p->lower_bound <= 1e-11);
    Pose moved = at(1.5, 5);
    moved.translation() += p->translation;
    EXPECT_FALSE(collide(frame(), kIdentity, square(), moved));
    EXPECT_LE(p->translation.norm(), p->depth + 1e-11);
  }
  // The hulls' separating axes.
  const auto none = penetration(frame(), kIdentity, square(), at(1.5, 5), {0, kInfinity});
  EXPECT_NEAR(none->depth, 2.5, 1e-14);
  EXPECT_EQ(none->lower_bound, 0);
  EXPECT_FALSE(none->optimal);
  // Convex pairs take no search.
  EXPECT_TRUE(penetration(square(), kIdentity, square(), kIdentity, {0, kInfinity})->optimal);
}

TEST(DepthError, LessOfItIsNoWorse) {
  Random random(5);
  const Polygon a({star(random, 60, 1, 3)}), b({star(random, 60, 1, 3)});
  const auto best = penetration(a, kIdentity, b, at(0.5, 0.25));
  ASSERT_TRUE(best->optimal);
  Penetration last = *penetration(a, kIdentity, b, at(0.5, 0.25), {0, kInfinity});
  for (const double error : {2.0, 1.0, 0.3, 0.1, 0.03}) {
    const auto p = penetration(a, kIdentity, b, at(0.5, 0.25), {0, error});
    EXPECT_LE(p->depth, last.depth);
    EXPECT_GE(p->depth, best->depth);
    EXPECT_GE(p->lower_bound, last.lower_bound);
    EXPECT_LE(p->lower_bound, best->depth);
    EXPECT_LE(p->depth, (1 + error) * p->lower_bound + 1e-11);
    last = *p;
  }
  EXPECT_LT(penetration(a, kIdentity, b, at(0.5, 0.25), {0, 1})->lower_bound, 0.9 * best->depth) << "it saves nothing";
}

TEST(DepthError, IsANumberThatIsNotNegative) {
  for (const double error : {-1e-9, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(penetration(square(), kIdentity, square(), kIdentity, {0, error}), std::invalid_argument);
}

/// The named ones, as where it suffices.
TEST(DepthError, ThePointsAreOnTheEdges) {
  int unproven = 0;
  for (int i = 0; i < 40; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Polygon a({star(random, 30, 0.4, 1)}), b({star(random, 20, 0.4, 1)});
    const Pose at = pose(random.real(0, 6), random.real(-0.5, 0.5), random.real(-0.5, 0.5));
    PenetrationOptions options;
    options.depth_error = random.real(0.05, 1);
    const auto found = penetration(a, Pose::Identity(), b, at, options);
    if (!found || found->optimal) continue;
    ++unproven;
    const auto fromEdge = [](const Polygon& polygon, const Pose& of, EdgeIndex e, const Vec2& p) {
      const Vec2 v = of * polygon.edgeStart(e), w = of * polygon.edgeEnd(e), u = w - v;
      return (v + std::clamp((p - v).dot(u) / u.squaredNorm(), 0.0, 1.0) * u - p).norm();
    };
    EXPECT_LE(fromEdge(a, Pose::Identity(), found->edge_a, found->point_a), 1e-12) << i;
    EXPECT_LE(fromEdge(b, at, found->edge_b, found->point_b), 1e-12) << i;
  }
  EXPECT_GE(unproven, 10);
}

}  // namespace
}  // namespace tricover::support
