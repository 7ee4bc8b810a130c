// SPDX-License-Identifier: BSD-3-Clause
// Whether areas cover a part, one area or the union of many, against exact rationals.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "exact_covers.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "touching_families.h"
#include "tricover/covers.h"
#include "tricover/scene.h"

namespace tricover::support {
namespace {

constexpr int kCases = 600;
constexpr double kRareKind = 0.08;

struct Sheet {
  std::vector<BodyPlacement> areas;
  Polygon part;
  Pose pose;
};

Vec2 anyPoint(Random& random, int low, int high) {
  const int x = random.integer(low, high);
  return {static_cast<double>(x), static_cast<double>(random.integer(low, high))};
}

Ring anyRing(Random& random, int low, int high) {
  Ring ring;
  for (int n = random.integer(3, 6); n > 0; --n) ring.push_back(anyPoint(random, low, high));
  return ring;
}

Ring anyRectangle(Random& random, int low, int high, int most) {
  const Vec2 p = anyPoint(random, low, high), size = anyPoint(random, 1, most);
  return eitherWay(random, rectangle(p.x(), p.y(), p.x() + size.x(), p.y() + size.y()));
}

/// Parts with and without an interior, spikes among them.
Polygon anyPart(Random& random) {
  switch (random.integer(0, 6)) {
    case 0: {
      const Vec2 p = anyPoint(random, 2, 5);
      return Polygon({{p, p, p}});
    }
    case 1: {
      const Vec2 p = anyPoint(random, 2, 5), q = anyPoint(random, 2, 5);
      return Polygon({{p, q, 0.5 * (p + q)}});
    }
    case 2:
      return Polygon({anyRectangle(random, 2, 3, 2), anyRing(random, 2, 5)}, FillRule::NonZero);
    case 3:
      return Polygon({anyRing(random, 2, 5)});
    default:
      return Polygon({anyRectangle(random, 2, 4, 2)});
  }
}

/// One pose, or the same one turned, for all: what touches still does.
void place(Random& random, Sheet& sheet) {
  Pose pose = Pose::Identity();
  if (random.coin()) pose = Eigen::Rotation2Dd(random.real(-3, 3)) * pose;
  if (random.oneIn(3)) pose.linear().col(1) *= -1;
  if (random.coin()) pose.translation() = Vec2(random.real(-9, 9), random.real(-9, 9));
  sheet.pose = pose;
  for (BodyPlacement& body : sheet.areas) body.pose = pose;
}

/// Lanes that overlap, abut or leave gaps.
Sheet lanes(Random& random) {
  Sheet sheet{{}, random.coin() ? Polygon({anyRectangle(random, 1, 2, 4)}) : anyPart(random), Pose::Identity()};
  for (int n = random.integer(1, 6); n > 0; --n) {
    const double x = random.integer(0, 5), y = random.integer(0, 5);
    const double length = random.integer(3, 9), width = random.integer(2, 4);
    const bool lies = random.coin();
    sheet.areas.push_back(
        {Polygon({eitherWay(random, rectangle(lies ? x - 3 : x, lies ? y : y - 3, lies ? x - 3 + length : x + width,
                                              lies ? y + width : y - 3 + length))}),
         Pose::Identity(),
         {}});
  }
  return sheet;
}

/// Rings of integers, with holes and seams.
Sheet rings(Random& random) {
  Sheet sheet{{}, anyPart(random), Pose::Identity()};
  for (int n = random.integer(1, 3); n > 0; --n) {
    std::vector<Ring> area{random.coin() ? anyRectangle(random, 0, 2, 8) : anyRing(random, -1, 9)};
    if (random.oneIn(3)) area.push_back(anyRing(random, 0, 8));
    sheet.areas.push_back({Polygon(area, random.coin() ? FillRule::EvenOdd : FillRule::NonZero), Pose::Identity(), {}});
  }
  return sheet;
}

/// The area's own pieces: a part that is one, or what fits exactly into a hole, beside the plug itself.
Sheet plugs(Random& random) {
  const Ring hole = anyRing(random, 1, 6);
  Sheet sheet{{{Polygon({rectangle(-2, -2, 9, 9), hole}), Pose::Identity(), {}}},
              random.coin() ? Polygon({hole}) : anyPart(random),
              Pose::Identity()};
  if (random.coin()) sheet.areas.push_back({Polygon({hole}), Pose::Identity(), {}});
  if (random.oneIn(4)) sheet.areas.push_back({Polygon({anyRing(random, 1, 6)}), Pose::Identity(), {}});
  return sheet;
}

/// Seams alone: areas without an interior, and parts along them.
Sheet bare(Random& random) {
  const Vec2 p = anyPoint(random, 0, 4), q = anyPoint(random, 0, 4), r = p + (q - p) * random.integer(1, 3);
  Sheet sheet{{}, Polygon({{p, q, p}}), Pose::Identity()};
  if (random.oneIn(4)) sheet.part = Polygon({{q, q, q}});
  if (random.oneIn(3)) sheet.part = Polygon({{p, q, p, p + Vec2(2, 1), p + Vec2(1, 2)}});
  for (int n = random.integer(1, 3); n > 0; --n) {
    const Vec2 s = p + (r - p) * 0.25 * random.integer(-1, 4), t = p + (r - p) * 0.25 * random.integer(0, 5);
    sheet.areas.push_back(
        {random.oneIn(3) ? Polygon({{s, t, s + Vec2(3, 1)}}) : Polygon({{s, t, s}}), Pose::Identity(), {}});
  }
  if (random.coin()) sheet.areas.push_back({Polygon({anyRing(random, -1, 6)}), Pose::Identity(), {}});
  return sheet;
}

struct Kind {
  const char* name;
  Sheet (*make)(Random& random);
};

class CoversOracle : public testing::TestWithParam<Kind> {};

std::string reproduction(const Sheet& sheet) {
  std::string text;
  for (const BodyPlacement& body : sheet.areas)
    text += support::reproduction(Case{body.polygon, body.pose, sheet.part, sheet.pose}) + "\n";
  return text;
}

/// Nothing where the answer is refused.
std::optional<bool> coversInScene(const Sheet& sheet, double margin) {
  Scene scene;
  scene.add(sheet.areas);
  try {
    return scene.covers(sheet.part, sheet.pose, {margin});
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

TEST_P(CoversOracle, AgreesWithExactRationals) {
  const int cases = scaledCount(kCases);
  int covered = 0, unions = 0, wide = 0, narrow = 0, refused = 0;
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    Sheet sheet = GetParam().make(random);
    place(random, sheet);
    const bool truth = exact::covers(sheet.areas, sheet.part, sheet.pose, 0);
    covered += truth;
    ASSERT_EQ(coversInScene(sheet, 0), truth) << GetParam().name << " seed " << i << "\n" << reproduction(sheet);
    bool by_one = false;
    for (const BodyPlacement& body : sheet.areas) {
      const bool alone = exact::covers({body}, sheet.part, sheet.pose, 0);
      by_one |= alone;
      ASSERT_EQ(covers(body.polygon, body.pose, sheet.part, sheet.pose), alone)
          << GetParam().name << " seed " << i << "\n"
          << reproduction(sheet);
    }
    unions += truth && !by_one;
    if (!truth) continue;
    for (const double margin : {0.5, 1.0, 2.0}) {
      const bool is_clear = exact::covers(sheet.areas, sheet.part, sheet.pose, margin);
      const std::optional<bool> found = coversInScene(sheet, margin);
      refused += !found;
      (is_clear ? wide : narrow) += 1;
      if (found) {
        ASSERT_EQ(*found, is_clear) << GetParam().name << " seed " << i << ", margin " << margin << "\n"
                                    << reproduction(sheet);
      }
    }
  }
  std::printf("%-8s %5d cases %5d covered %5d by several %5d with a margin %5d not %4d refused\n", GetParam().name,
              cases, covered, unions, wide, narrow, refused);
  if (cases < 100) return;
  EXPECT_GE(covered, kRareKind * cases);
  EXPECT_GE(cases - covered, kRareKind * cases);
  EXPECT_GT(unions, cases / 100);
  EXPECT_LE(refused, (wide + narrow) / 20);
}

INSTANTIATE_TEST_SUITE_P(Kinds, CoversOracle,
                         testing::Values(Kind{"Lanes", lanes}, Kind{"Rings", rings}, Kind{"Plugs", plugs},
                                         Kind{"Bare", bare}),
                         [](const auto& kind) { return kind.param.name; });

/// Pairs that share edges and touch: one covers the other rarely, but what is left open is small.
TEST(Covers, PairsThatTouch) {
  int covered = 0;
  for (const Family& family : touchingFamilies()) {
    for (int i = 0; i < scaledCount(300); ++i) {
      const Case c = family.make(static_cast<std::uint64_t>(i));
      const bool truth = exact::covers({{c.a, c.pose_a, {}}}, c.b, c.pose_b, 0);
      covered += truth;
      ASSERT_EQ(covers(c.a, c.pose_a, c.b, c.pose_b), truth) << family.name << " " << i << "\n"
                                                             << support::reproduction(c);
      EXPECT_TRUE(covers(c.a, c.pose_a, c.a, c.pose_a));
    }
  }
  if (!isScaledDown()) {
    EXPECT_GT(covered, 30);
  }
}

}  // namespace
}  // namespace tricover::support
