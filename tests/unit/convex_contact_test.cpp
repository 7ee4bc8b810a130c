// SPDX-License-Identifier: BSD-3-Clause
// The short way to the contact of two convex polygons: which faces it looks at, which pairs it answers, and that it
// answers them as penetration() does. Their laws are tests/laws/contacts.cpp's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "contact/contact_solvers.h"
#include "contact_laws.h"
#include "convex/convex_outline.h"
#include "exact_reference.h"
#include "families.h"
#include "numbers/segment.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/penetration.h"

namespace tricover::support {
namespace {

using namespace detail;

/// Two of them, somewhere; and b led away from a until it only just meets it, then back by anything from far to a last
/// bit.
Case convexPair(Random& random) {
  const auto any = [&](double size) { return Polygon({eitherWay(random, anyConvex(random, size))}); };
  Case c{any(1), randomPose(random, 2), any(random.real(0.3, 1)), randomPose(random, 2)};
  if (random.oneIn(3)) c.pose_b.linear() = c.pose_a.linear();
  if (random.oneIn(4)) c.pose_b = mirrored(c.pose_b);
  if (random.oneIn(8)) c.b = c.a;
  const Vec2 away = direction(random.oneIn(4) ? 0 : random.real(-4, 4));
  double near = contactOnWay(c, away, 4, 50).near;
  near -= random.oneIn(3) ? random.unit() : (random.coin() ? 1 : -1) * std::pow(10, random.real(-17, 0));
  c.pose_b.translation() = c.pose_a.translation() + near * away;
  // The kernel's order.
  if (detail::dataOf(c.b).unit > detail::dataOf(c.a).unit) {
    std::swap(c.a, c.b);
    std::swap(c.pose_a, c.pose_b);
  }
  return c;
}

/// How deep the other polygon reaches behind a face of an outline, in the world less a's translation; by extended
/// numbers.
long double depthBehind(const PosedPair& pair, bool of_a, std::size_t edge) {
  using Wide = Eigen::Matrix<long double, 2, 1>;
  const auto world = [&](bool a, const Vec2& p) -> Wide {
    const Pose& pose = a ? pair.pose_a : pair.pose_b;
    return pose.linear().cast<long double>() * p.cast<long double>() + pose.translation().cast<long double>() -
           pair.pose_a.translation().cast<long double>();
  };
  const std::vector<Vec2>&own = convexOutlineOf(of_a ? pair.a : pair.b).points,
        &other = convexOutlineOf(of_a ? pair.b : pair.a).points;
  const Wide from = world(of_a, own[edge]), way = world(of_a, own[edge + 1]) - from;
  const long double hand = (of_a ? pair.pose_a : pair.pose_b).linear().determinant() < 0 ? -1 : 1;
  long double depth = -INFINITY;
  for (const Vec2& p : other) {
    const Wide to = world(!of_a, p) - from;
    depth = std::max(depth, hand * (way.x() * to.y() - way.y() * to.x()) / way.norm());
  }
  return depth;
}

/// What contacts() keeps as a certificate.
TEST(SeparatingAxes, GapIsALowerBoundOfTheDistance) {
  int apart = 0, close = 0;
  for (int i = 0; i < scaledCount(4000); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Case c = convexPair(random);
    const PosedPair pair(detail::dataOf(c.a), c.pose_a, detail::dataOf(c.b), c.pose_b);
    const SeparatingAxes axes(pair);
    if (axes.verdict() != SeparatingAxes::Apart) continue;
    const double distance = exact::distanceBelow(exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b));
    ASSERT_LE(axes.gap(), distance) << "seed " << i << "\n" << reproduction(c);
    ASSERT_GE(axes.gap(), 0);
    ++apart;
    close += axes.gap() > 0.9 * distance;
  }
  EXPECT_GT(apart, scaledCount(4000) / 10);
  EXPECT_GT(close, apart / 4);
  EXPECT_LT(close, apart);
}

/// Floats leave out no face that is among the least, of few edges; nor do plain doubles, of more.
TEST(SeparatingAxes, HaveAllOfTheLeastFaces) {
  int few = 0, many = 0, several = 0, mirrored_ones = 0, aparts = 0, deep = 0, answered = 0;
  const int cases = scaledCount(4000);
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i) + 100000);
    Case c = convexPair(random);
    if (random.oneIn(6)) {  // faces are as deep as those that they look at
      c.b = c.a;
      c.pose_b.linear() = -c.pose_a.linear();
    }
    const PosedPair pair(detail::dataOf(c.a), c.pose_a, detail::dataOf(c.b), c.pose_b);
    const SeparatingAxes axes(pair);
    long double least = INFINITY;
    for (const bool of_a : {true, false})
      for (std::size_t k = 0; k < axes.side(of_a).ring.ring.size(); ++k)
        least = std::min(least, depthBehind(pair, of_a, k));
    deep += least > 1e-9L;
    if (axes.verdict() == SeparatingAxes::Unsure) continue;
    const long double doubt = 64 * axes.error();
    if (axes.verdict() == SeparatingAxes::Apart) {
      ++aparts;
      ASSERT_LT(least, 0) << reproduction(c);
      continue;
    }
    ASSERT_LE(std::abs(axes.leastDepth() - least), doubt) << reproduction(c);
    std::ptrdiff_t count = 0;
    for (const bool of_a : {true, false})
      for (std::uint32_t k = 0; k < axes.side(of_a).ring.ring.size(); ++k) {
        if (depthBehind(pair, of_a, k) > least + axes.tie()) continue;
        ++count;
        ASSERT_TRUE(std::any_of(axes.begin(), axes.end(), [&](const FaceDepth& f) {
          return f.of_a == of_a && f.edge == k;
        })) << reproduction(c);
      }
    several += count > 1;
    answered += least > 1e-9L && convexContact(pair, axes, 0).has_value();
    ++(std::max(axes.side(true).ring.ring.size(), axes.side(false).ring.ring.size()) <= 16 ? few : many);
    mirrored_ones += axes.side(false).ring.mirrors();
  }
  EXPECT_GT(few, cases / 4);
  EXPECT_GT(many, cases / 40);
  EXPECT_GT(several, cases / 30);
  EXPECT_GT(deep, cases / 4);
  EXPECT_GE(answered, 0.99 * deep);
  EXPECT_GT(mirrored_ones, cases / 20);
  EXPECT_GT(aparts, cases / 40);
}

/// Areas of such sizes have no squares, or a diagonal has none and areas are still numbers.
TEST(ConvexContact, OfHugeAndTinyTriangles) {
  const struct {
    Ring a, b;
    double depth;
  } pairs[] = {{{{-1, -1}, {1, 2}, {-3, 1}}, {{-2, -3}, {-1, 1}, {1, 0}}, 4 / std::sqrt(13)},
               {{{0, 0}, {1, 1}, {0, 1}}, {{0.05, 0.6}, {-0.3, 0.7}, {-0.3, 0.5}}, 0.05}};
  for (const double size : {1e100, 1.2e154, 1e300, 1e-100, 1e-170, 1e-280})
    for (const auto& [a, b, depth] : pairs) {
      const Polygon p({scaled(a, size)}), q({scaled(b, size)});
      const auto found = contacts(p, Pose::Identity(), q, Pose::Identity(), globally());
      const auto way = penetration(p, Pose::Identity(), q, Pose::Identity());
      ASSERT_TRUE(way && found.size() == 1);
      EXPECT_NEAR(found[0].depth / size, depth, 1e-12) << size;
      EXPECT_NEAR(way->depth / size, depth, 1e-12) << size;
    }
}

/// A needle thinner than what coordinates are rounded by, which leads along the normal: its other end was passed by.
TEST(ConvexContact, OfANeedleInABoxIsOnTheNeedle) {
  const Polygon box({rectangle(-14, -14, 14, 14)});
  Pose upright = Pose::Identity();
  upright.matrix().topRows<2>() << 0, -1, 1.75, 1, 0, 2.5;
  for (const double width : {1e-27, 1e-20})
    for (const double length : {1e-11, 1e-9, 1e-6, 1e-3}) {
      const Polygon needle({{{-length, 0}, {0, -width}, {length, 0}, {0, width}}});
      const std::vector<Contact> found =
                                     contacts(box, Pose::Identity(), needle, turnedAndMoved(0, 10.25, 4.5), globally()),
                                 above = contacts(box, Pose::Identity(), needle, upright, globally());
      ASSERT_EQ(found.size() + above.size(), 2u);
      EXPECT_EQ(found[0].normal, Vec2(1, 0));
      EXPECT_NEAR(found[0].depth, 3.75 + length, 1e-14);
      EXPECT_NEAR((found[0].point - Vec2(10.25, 4.5)).norm(), 0, 1e-14);
      EXPECT_NEAR((above[0].normal - Vec2(0, 1)).norm(), 0, 1e-14);
      EXPECT_NEAR((above[0].point - Vec2(1.75, 2.5)).norm(), 0, 1e-14);
    }
}

/// Of the edges at the deepest vertex the one that is more across the normal, whichever way round the ring runs.
TEST(ConvexContact, NamesTheFlatterEdgeAtAVertex) {
  const Polygon box({rectangle(0, 0, 4, 4)});
  const Pose here = Pose::Identity();
  for (const auto& [ring, edge] : {std::pair(Ring{{1, 3.6}, {3, 3.5}, {3, 6}, {1, 6}}, 0),
                                   {Ring{{1, 3.5}, {3, 3.6}, {3, 6}, {1, 6}}, 0},
                                   {Ring{{1, 6}, {3, 6}, {3, 3.5}, {1, 3.6}}, 2}}) {
    const Polygon leaning({ring});
    const PosedPair pair(detail::dataOf(box), here, detail::dataOf(leaning), here);
    const std::optional<Contact> found = convexContact(pair, SeparatingAxes(pair), 0);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->normal, Vec2(0, 1));
    EXPECT_NEAR(found->depth, 0.5, 1e-15);
    EXPECT_EQ(found->edge_a, 2);
    EXPECT_EQ(found->edge_b, edge);
  }
}

}  // namespace
}  // namespace tricover::support
