// SPDX-License-Identifier: BSD-3-Clause
// castRay()'s and castRayAll()'s laws; the truth about degenerate rays is tests/laws/ray.cpp's.
#include "tricover/ray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "exact_reference.h"
#include "hierarchy/hierarchy.h"
#include "numbers/predicates.h"
#include "overlay/plain_ray.h"
#include "random.h"
#include "refusal.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/polygon.h"

namespace tricover::support {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

/// A wall from x = 2 to 3 with a hole in it, and a post that stands in the hole.
Polygon wall() {
  return Polygon({rectangle(2, -4, 3, 4), rectangle(2.25, -1, 2.75, 1), rectangle(2.4, -0.1, 2.6, 0.1)});
}

RayHit cast(const Polygon& polygon, const Vec2& from, const Vec2& to) {
  const auto hit = castRay(polygon, Pose::Identity(), from, to);
  return hit ? *hit : RayHit{-1, Vec2::Zero(), Vec2::Zero(), -2};
}

TEST(Ray, NamesPointNormalAndEdge) {
  const RayHit hit = cast(wall(), {0, 0.5}, {4, 0.5});
  EXPECT_EQ(hit.fraction, 0.5);
  EXPECT_EQ(hit.point, Vec2(2, 0.5));
  EXPECT_EQ(hit.normal, Vec2(-1, 0));
  EXPECT_EQ(hit.edge, 3);
  const RayHit back = cast(wall(), {7, 0.5}, {-1, 0.5});
  EXPECT_EQ(back.point, Vec2(3, 0.5));
  EXPECT_EQ(back.normal, Vec2(1, 0));
  EXPECT_EQ(back.edge, 1);
  const RayHit in_hole = cast(wall(), {2.3, 0}, {5, 0});
  EXPECT_EQ(in_hole.edge, 11);  // the post's
  EXPECT_NEAR(in_hole.point.x(), 2.4, 1e-15);
  EXPECT_EQ(in_hole.point.y(), 0);
}

TEST(Ray, StartsInTheRegion) {
  for (const Vec2& from : {Vec2(2.1, 0), Vec2(2, 0), Vec2(2, 4), Vec2(2.25, 0.5), Vec2(2.5, 0)}) {
    const RayHit hit = cast(wall(), from, from + Vec2(3, 4));
    EXPECT_EQ(hit.fraction, 0);
    EXPECT_EQ(hit.point, from);
    EXPECT_EQ(hit.edge, -1);
    EXPECT_NEAR((hit.normal - Vec2(-0.6, -0.8)).norm(), 0, 1e-15);
  }
  EXPECT_EQ(cast(wall(), {2.3, 0}, {2.35, 0}).edge, -2);  // in the hole
}

/// Of edges that are met at one point the lowest number counts, however they turn and lie.
TEST(Ray, GrazesVerticesAndRunsAlongEdges) {
  EXPECT_EQ(cast(wall(), {0, 4}, {5, 4}).edge, 2);
  EXPECT_EQ(cast(wall(), {0, 4}, {5, 4}).normal, Vec2(-1, 0));  // along edge 2
  EXPECT_EQ(cast(wall(), {0, -4}, {5, -4}).edge, 0);
  EXPECT_EQ(cast(wall(), {1, 3}, {3, 5}).edge, 2);  // a corner
  EXPECT_EQ(cast(wall(), {1, 3}, {3, 5}).fraction, 0.5);
  EXPECT_EQ(cast(wall(), {1, 3}, {2, 4}).fraction, 1);
  EXPECT_EQ(cast(wall(), {1, 3}, {2, std::nextafter(4.0, 5.0)}).edge, -2);
  const Polygon twice({rectangle(0, 0, 1, 1), rectangle(0, 0, 1, 1)}, FillRule::NonZero);
  EXPECT_EQ(cast(twice, {-1, 0.3}, {2, 0.7}).edge, 3);
  const Ring bow_tie = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};  // edges 0 and 2 cross at (0.5, 0.5)
  EXPECT_EQ(cast(Polygon({bow_tie}), {0.5, 2}, {0.5, 0}).edge, 0);
  EXPECT_EQ(cast(Polygon({reversed(bow_tie)}), {0.5, 2}, {0.5, 0}).edge, 0);
}

TEST(Ray, OfLengthZeroIsAPoint) {
  const RayHit hit = cast(wall(), {2.1, 0}, {2.1, 0});
  EXPECT_EQ(hit.fraction, 0);
  EXPECT_EQ(hit.normal, Vec2::Zero());
  EXPECT_EQ(cast(wall(), {2.3, 0}, {2.3, 0}).edge, -2);
}

TEST(Ray, MeetsPointsAndSegments) {
  EXPECT_EQ(cast(Polygon::point({1, 1}), {0, 0}, {4, 4}).fraction, 0.25);
  EXPECT_EQ(cast(Polygon::point({1, 1}), {0, 0}, {4, 4}).edge, 0);
  EXPECT_NEAR(cast(Polygon::point({1, 1}), {0, 0}, {4, 4}).normal.x(), -std::sqrt(0.5), 1e-15);
  EXPECT_EQ(cast(Polygon::point({1, 1}), {0, 0}, {4, std::nextafter(4.0, 5.0)}).edge, -2);
  EXPECT_EQ(cast(Polygon::segment({1, -1}, {1, 1}), {0, 0}, {4, 0}).normal, Vec2(-1, 0));
  EXPECT_EQ(cast(Polygon::segment({1, 0}, {3, 0}), {5, 0}, {1, 0}).fraction, 0.5);
}

/// Up to the limit the answer doesn't depend on it.
TEST(Ray, LimitLeavesOutWhatIsBeyondAndNothingElse) {
  Random random(2);
  int hits = 0;
  for (int i = 0; i < scaledCount(2000); ++i) {
    const Polygon polygon({star(random, random.integer(3, 200), 0.2, 1)});
    const Pose placed = randomPose(random, 1);
    const Vec2 from(random.real(-3, 3), random.real(-3, 3)), to(random.real(-3, 3), random.real(-3, 3));
    const auto all = castRay(polygon, placed, from, to);
    const auto limited = [&](double limit) {
      return detail::castPlainRay(detail::dataOf(polygon), placed, from, to, limit);
    };
    if (!all || all->edge < 0) {
      EXPECT_EQ(limited(0.5).has_value(), all.has_value());
      continue;
    }
    ++hits;
    EXPECT_FALSE(limited(std::nextafter(all->fraction, 0.0)));
    for (const double limit : {all->fraction, all->fraction * (1 + 1e-14), 2.0}) {
      const auto same = limited(limit);
      ASSERT_TRUE(same);
      EXPECT_EQ(same->edge, all->edge);
      EXPECT_EQ(same->fraction, all->fraction);
      EXPECT_EQ(same->point, all->point);
    }
  }
  EXPECT_GT(hits, scaledCount(2000) / 10);
}

/// Neither a far end nor a polygon that is far from its frame's origin costs exact arithmetic.
TEST(Ray, FiltersDecideOrdinaryRays) {
  Random random(3);
  std::uint64_t exact_calls = 0;
  int hits = 0;
  for (int i = 0; i < 1000; ++i) {
    const double offset = random.coin() ? 0 : 5e5;
    const Polygon polygon({shifted(star(random, 20, 0.5, 1), {offset, offset})});
    const Vec2 from = Vec2(offset, offset) + Vec2(random.real(-3, 3), random.real(-3, 3));
    const double angle = random.real(0, 2 * M_PI), length = random.coin() ? 10 : 1e30;
    detail::innerDiscsOf(detail::dataOf(polygon));  // whose asserts ask exact questions
    const std::uint64_t before = detail::exactCalls();
    const auto hit = castRay(polygon, Pose::Identity(), from, from + length * Vec2(std::cos(angle), std::sin(angle)));
    exact_calls += detail::exactCalls() - before;
    hits += hit && hit->edge >= 0;
  }
  EXPECT_GT(hits, 100);
  EXPECT_LE(exact_calls, 100u);  // where the ray all but runs along an edge
}

TEST(Ray, EndsMayBeAsFarApartAsDoublesGo) {
  const Polygon square({rectangle(-1, -1, 1, 1)});
  const RayHit hit = cast(square, {-kLargest, 0.5}, {kLargest, 0.5});
  EXPECT_EQ(hit.edge, 3);
  EXPECT_NEAR(hit.fraction, 0.5, 1e-14);
  EXPECT_EQ(hit.point.y(), 0.5);
  EXPECT_TRUE(hit.point.allFinite());
  EXPECT_EQ(hit.normal, Vec2(-1, 0));
  const RayHit from_above = cast(square, {0.25, 4}, {0.25, -kLargest});
  EXPECT_NEAR(from_above.point.y(), 1, 1e-14);
  EXPECT_EQ(from_above.edge, 2);
}

/// A short way of a ray so long that its length, in a polygon's units, leaves the range of doubles; and one whose
/// length does by itself.
TEST(Ray, FindsTheFirstEdgeOnRaysOfAnyLength) {
  const Ring teeth = comb(5, 2, 1, 3);
  const Polygon tiny({scaled(teeth, 1e-150)}), huge({scaled(teeth, 1e307)});
  const auto first = [](const Polygon& polygon, const Vec2& from, const Vec2& to) {
    const RayHit hit = cast(polygon, from, to);
    const auto truth = exact::castRay(polygon, Pose::Identity(), from, to);
    EXPECT_EQ(hit.edge, truth ? truth->edge : -2);
    const double fraction = truth ? truth->fraction.get_d() : -1;
    EXPECT_LE(std::abs(hit.fraction - fraction), 1e-14 * std::abs(fraction));
    return hit.edge >= 0;
  };
  int hits = 0;
  for (int i = -8; i <= 48; ++i) {
    const double y = i / 8.0, rise = 1e150 * (i % 5);
    hits += first(tiny, {-1e-149, y * 1e-150}, {1e152, rise}) + first(tiny, {3e-149, y * 1e-150}, {-1e155, -rise});
    hits += first(huge, {-1.2e308, y * 1e307}, {1.7e308, y * 1e307});
  }
  EXPECT_GT(hits, 60);
}

/// "begin edge @ x .. end edge @ x" of each interval, where x is a coordinate of the points.
std::string intervalsOf(const Polygon& polygon, const Vec2& from, const Vec2& to, double margin = 0, int axis = 0) {
  std::string text;
  const auto end = [&](const RayHit& hit) {
    char number[64];
    std::snprintf(number, sizeof number, "%d@%.9g", static_cast<int>(hit.edge), hit.point[axis]);
    return std::string(number);
  };
  for (const RayInterval& part : castRayAll(polygon, Pose::Identity(), from, to, {margin}))
    text += (text.empty() ? "" : " ") + end(part.begin) + ".." + end(part.end);
  return text;
}

TEST(RayAll, PassesWallsAndHoles) {
  EXPECT_EQ(intervalsOf(wall(), {0, 0}, {4, 0}), "3@2..7@2.25 11@2.4..9@2.6 5@2.75..1@3");
  EXPECT_EQ(intervalsOf(wall(), {4, 0}, {0, 0}), "1@3..5@2.75 9@2.6..11@2.4 7@2.25..3@2");
  EXPECT_EQ(intervalsOf(wall(), {2.5, 0}, {2.8, 0}), "-1@2.5..9@2.6 5@2.75..-1@2.8");
  EXPECT_EQ(intervalsOf(wall(), {2.3, 0}, {2.35, 0}), "");
  EXPECT_EQ(intervalsOf(wall(), {0, 5}, {4, 5}), "");
  const auto parts = castRayAll(wall(), Pose::Identity(), {0, 0.5}, {4, 0.5});
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].begin.normal, Vec2(-1, 0));
  EXPECT_EQ(parts[0].end.normal, Vec2(1, 0));
  EXPECT_EQ(parts[0].end.fraction, 0.5625);
}

/// A touched vertex and a spike are single points or run along; where rings of the region touch, the interval goes on.
TEST(RayAll, TouchesVerticesAndRunsAlongEdges) {
  EXPECT_EQ(intervalsOf(wall(), {1, 3}, {3, 5}), "2@2..2@2");
  EXPECT_EQ(intervalsOf(wall(), {1, 3}, {2, 4}), "2@2..-1@2");
  EXPECT_EQ(intervalsOf(wall(), {2, 4}, {1, 3}), "-1@2..2@2");
  EXPECT_EQ(intervalsOf(wall(), {2, 4}, {1, 5}), "-1@2..2@2");
  EXPECT_EQ(intervalsOf(wall(), {0, 4}, {5, 4}), "2@2..1@3");
  EXPECT_EQ(intervalsOf(wall(), {2.2, 4}, {2.7, 4}), "-1@2.2..-1@2.7");
  EXPECT_EQ(intervalsOf(wall(), {0, 1}, {5, 1}), "3@2..1@3");  // along the hole's edge
  const Polygon spiked({{{0, 0}, {1, 0}, {1, 1}, {3, 1}, {1, 1}, {1, 2}, {0, 2}}});
  EXPECT_EQ(intervalsOf(spiked, {-1, 1}, {4, 1}), "6@0..2@3");
  EXPECT_EQ(intervalsOf(spiked, {2, 0}, {2, 2}, 0, 1), "2@1..2@1");
  EXPECT_EQ(intervalsOf(spiked, {2, 1}, {4, 1}), "-1@2..2@3");
  const Polygon abutting({rectangle(0, 0, 1, 1), rectangle(1, 0, 2, 1), rectangle(3, 1, 4, 2)});
  EXPECT_EQ(intervalsOf(abutting, {-1, 0.5}, {5, 0.5}), "3@0..5@2");
  EXPECT_EQ(intervalsOf(abutting, {-1, 1}, {5, 1}), "2@0..5@2 8@3..8@4");
  const Polygon twice({rectangle(0, 0, 1, 1), rectangle(0, 0, 1, 1)});  // even-odd: edges alone
  EXPECT_EQ(intervalsOf(twice, {-1, 0.5}, {5, 0.5}), "3@0..3@0 1@1..1@1");
  EXPECT_EQ(intervalsOf(Polygon::segment({1, 0}, {3, 0}), {0, 0}, {4, 0}), "0@1..0@3");
  EXPECT_EQ(intervalsOf(Polygon::segment({1, 0}, {3, 0}), {2, 0}, {1, 0}), "-1@2..-1@1");
  EXPECT_EQ(intervalsOf(Polygon::point({1, 0}), {0, 0}, {4, 0}), "0@1..0@1");
}

TEST(RayAll, OfLengthZeroIsAPoint) {
  const auto parts = castRayAll(wall(), Pose::Identity(), {2, 0}, {2, 0});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].begin.fraction, 0);
  EXPECT_EQ(parts[0].end.fraction, 1);
  EXPECT_EQ(parts[0].end.edge, -1);
  EXPECT_EQ(intervalsOf(wall(), {2.3, 0}, {2.3, 0}), "");
}

/// As above for the first edge: what winds around the ray's start is known however short or long the ray is.
TEST(RayAll, OfAnyLength) {
  const Polygon teeth({comb(5, 2, 1, 3)});
  const auto first = exact::castRayAll(teeth, Pose::Identity(), {-1, 2}, {12, 2});
  EXPECT_GT(first.size(), 3u);
  int inside = 0;
  for (const double length : {1e-300, 1e-30, 1.0, 20.0, 1e30, 1e300})
    for (int i = 0; i < 200; ++i) {
      const Vec2 from(i / 16.0, 1 + i % 7 / 4.0), to = from + length * Vec2(i % 3 - 1, i % 2);
      const auto parts = castRayAll(teeth, Pose::Identity(), from, to);
      const auto truth = exact::castRayAll(teeth, Pose::Identity(), from, to);
      ASSERT_EQ(parts.size(), truth.size()) << length << ", " << i;
      for (std::size_t k = 0; k < parts.size(); ++k) {
        EXPECT_EQ(parts[k].begin.edge, truth[k].begin.edge);
        EXPECT_EQ(parts[k].end.edge, truth[k].end.edge);
        const double end = truth[k].end.fraction.get_d();
        EXPECT_NEAR(parts[k].end.fraction, end, 1e-12 * end);
      }
      inside += !parts.empty() && parts[0].begin.edge < 0;
    }
  EXPECT_GT(inside, 300);
  EXPECT_LT(inside, 900);
  EXPECT_EQ(intervalsOf(Polygon({rectangle(-1, -1, 1, 1)}), {-kLargest, 0.5}, {kLargest, 0.5}, 0, 1), "3@0.5..1@0.5");
}

TEST(RayAll, MeetsAMargin) {
  const Polygon posts({rectangle(0, 0, 1, 1), rectangle(3, 0, 4, 1), rectangle(10, 0, 11, 1)});
  EXPECT_EQ(intervalsOf(posts, {-5, 0.5}, {15, 0.5}, 0.5), "3@-0.5..1@1.5 7@2.5..5@4.5 11@9.5..9@11.5");
  EXPECT_EQ(intervalsOf(posts, {-5, 0.5}, {15, 0.5}, 2), "3@-2..5@6 11@8..9@13");
  EXPECT_EQ(intervalsOf(posts, {0.5, 0.5}, {3.5, 0.5}, 0.5), "-1@0.5..1@1.5 7@2.5..-1@3.5");
  EXPECT_EQ(intervalsOf(posts, {-5, 1.5}, {15, 1.5}, 0.25), "");
  EXPECT_EQ(intervalsOf(posts, {0.5, 0.5}, {0.5, 0.5}, 0.25), "-1@0.5..-1@0.5");
  const auto parts = castRayAll(posts, Pose::Identity(), {-5, 0.5}, {15, 0.5}, {0.5});
  EXPECT_NEAR((parts[1].begin.normal - Vec2(-1, 0)).norm() + (parts[1].end.normal - Vec2(1, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR(parts[1].end.fraction, 9.5 / 20, 1e-13);
  // Along the outline of the grown region, and beside it.
  EXPECT_FALSE(castRayAll(posts, Pose::Identity(), {-5, 1.5}, {15, 1.5}, {0.5}).empty());
  EXPECT_EQ(intervalsOf(posts, {-5, 1.501}, {15, 1.501}, 0.5), "");
  // Longer than a double.
  const Polygon huge({rectangle(-1e306, -1e306, 1e306, 1e306), rectangle(1e307, -1, 1.1e307, 1)});
  const auto far = castRayAll(huge, Pose::Identity(), {-kLargest, 0}, {kLargest, 0}, {1e305});
  ASSERT_EQ(far.size(), 2u);
  EXPECT_EQ(castRay(huge, Pose::Identity(), {-kLargest, 0}, {kLargest, 0}, {1e305})->fraction, far[0].begin.fraction);
  EXPECT_EQ(castRayAll(posts, turnedAndMoved(kLargest / 2, 1, 0), {-kLargest, 0}, {kLargest, 0}, {0.5}).size(), 1u);
  EXPECT_NEAR(far[0].begin.point.x() / 1e306, -1.1, 1e-6);
  EXPECT_NEAR(far[0].end.point.x() / 1e306, 1.1, 1e-6);
  EXPECT_NEAR(far[1].end.point.x() / 1e306, 11.1, 1e-6);
}

TEST(Ray, RefusesWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Pose sheared = Pose::Identity();
  sheared.linear() << 1, 1, 0, 1;
  const auto message = [&](const Pose& pose, const Vec2& from, const Vec2& to) {
    EXPECT_EQ(refusal([&] { castRayAll(wall(), pose, from, to); }), refusal([&] { castRay(wall(), pose, from, to); }));
    return refusal([&] { castRay(wall(), pose, from, to); });
  };
  EXPECT_NE(message(Pose::Identity(), {nan, 0}, {0, 0}).find("from"), std::string::npos);
  EXPECT_NE(message(Pose::Identity(), {0, 0}, {0, HUGE_VAL}).find("to: "), std::string::npos);
  EXPECT_NE(message(sheared, {0, 0}, {1, 0}).find("pose"), std::string::npos);
}

/// Found by soak: b's area is exactly 0 where the ray ends at an edge's start, which says nothing of a's.
TEST(Ray, AlongAnEdgeThatStartsWhereItEndsMeetsTheOtherEndFirst) {
  const Vec2 p(-0x1.ebe2b64f9edcp-7, 0x1.752b056a8b158p-3);
  const RayHit hit = cast(Polygon({{p, -2 * p, 2 * p, p}}), {0x1.336db1f1c3498p+0, -0x1.d275c6c52ddaep+3}, p);
  EXPECT_EQ(hit.edge, 0);
  EXPECT_LT(hit.fraction, 0.97);
}

/// The grown region's outline is straight beside edges and round at vertices.
TEST(Ray, MeetsAMargin) {
  const Polygon square({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}});
  const auto cast = [&](const Vec2& from, const Vec2& to) { return castRay(square, Pose::Identity(), from, to, {1}); };
  const auto side = cast({-5, 1}, {5, 1});
  ASSERT_TRUE(side);
  EXPECT_NEAR(side->fraction, 0.4, 1e-13);
  EXPECT_NEAR((side->normal - Vec2(-1, 0)).norm(), 0, 1e-13);
  EXPECT_EQ(side->edge, 3);
  const double at = 3 + std::sqrt(0.5);
  const auto corner = cast({5, 5}, {0, 0});
  ASSERT_TRUE(corner);
  EXPECT_NEAR((corner->point - Vec2(at - 1, at - 1)).norm(), 0, 1e-12);
  EXPECT_FALSE(cast({-5, 3.001}, {5, 3.001}));
  EXPECT_TRUE(cast({-5, 3}, {5, 3}));
  EXPECT_EQ(cast({-0.5, 1}, {-9, 1})->fraction, 0);
  for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (const bool all : {false, true})
      EXPECT_THROW(all ? void(castRayAll(square, Pose::Identity(), {0, 0}, {1, 1}, {bad}))
                       : void(castRay(square, Pose::Identity(), {0, 0}, {1, 1}, {bad})),
                   std::invalid_argument);
}

}  // namespace
}  // namespace tricover::support
