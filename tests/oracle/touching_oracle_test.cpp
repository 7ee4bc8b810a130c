// SPDX-License-Identifier: BSD-3-Clause
// Whether the interiors meet, against exact rationals, beside whether the closed regions do: every way of asking.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "exact_reference.h"
#include "families.h"
#include "random.h"
#include "reproduction.h"
#include "stages.h"
#include "strategies.h"
#include "test_scale.h"
#include "touching_families.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/penetration.h"
#include "tricover/scene.h"
#include "tricover/segment.h"

namespace tricover::support {
namespace {

constexpr int kCases = 1500;
constexpr double kRareKind = 0.08;

CollideOptions closed() { return {}; }
CollideOptions open(double margin = 0) { return {margin, 0, Touching::Allowed}; }

struct Truth {
  bool meet, overlap;
};

/// The first way of asking that gives another answer than the truth; empty if there is none.
std::string wrongWay(const Case& c, const Truth& truth, StrategyCaches& old) {
  for (const auto stages : {detail::Stages::Edges, detail::Stages::Hierarchy, detail::Stages::All}) {
    const UpTo these(stages);
    const std::string name = "up to stage " + std::to_string(static_cast<int>(stages));
    if (collide(c.a, c.pose_a, c.b, c.pose_b, open()) != truth.overlap) return name;
    if (collide(c.b, c.pose_b, c.a, c.pose_a, open()) != truth.overlap) return name + ", swapped";
  }
  for (const Strategy strategy : {Strategy::Hierarchy, Strategy::Paper}) {
    const std::string name = nameOf(strategy);
    if (collide(strategy, c.a, c.pose_a, c.b, c.pose_b, open()) != truth.overlap) return name + ", cold";
    if (collide(strategy, c.a, c.pose_a, c.b, c.pose_b, old, open()) != truth.overlap) return name + ", old cache";
    StrategyCaches fresh;
    for (int i = 0; i < 3; ++i) {
      if (collide(strategy, c.a, c.pose_a, c.b, c.pose_b, fresh, open()) != truth.overlap)
        return name + ", with a cache";
      if (collide(strategy, c.a, c.pose_a, c.b, c.pose_b, fresh, closed()) != truth.meet)
        return name + ", closed again";
    }
    if (collide(strategy, c.b, c.pose_b, c.a, c.pose_a, fresh, open()) != truth.overlap)
      return name + ", cache, swapped";
  }
  return {};
}

/// The same of a Scene, which has it of a query or of a body.
std::string wrongWayInScene(const Case& c, const Truth& truth) {
  SceneCache cache;
  for (const Touching of_body : {Touching::Collides, Touching::Allowed}) {
    Scene scene;
    BodyOptions body;
    body.touching = of_body;
    const auto first = scene.add(c.a, c.pose_a, body);
    const bool closed_answer = of_body == Touching::Allowed ? truth.overlap : truth.meet;
    for (int i = 0; i < 3; ++i) {
      if (scene.collides(c.b, c.pose_b, open()) != truth.overlap) return "scene";
      if (scene.collides(c.b, c.pose_b, cache, open()) != truth.overlap) return "scene, with a cache";
      if (scene.collides(c.b, c.pose_b, cache) != closed_answer) return "scene, closed, with a cache";
      if (scene.colliding(c.b, c.pose_b, open()).empty() == truth.overlap) return "colliding";
      if (scene.anyColliding(c.b, c.pose_b).has_value() != closed_answer) return "anyColliding, closed";
    }
    if (scene.collides(c.b, {c.pose_b, c.pose_b}, open()) != std::vector<bool>(2, truth.overlap)) return "many poses";
    const auto second = scene.add(c.b, c.pose_b);
    Pose aside = c.pose_a;
    aside.translation().x() += c.a.radius();
    if (!aside.translation().allFinite()) aside = c.pose_a;
    for (int i = 0; i < 3; ++i) {
      if (scene.collisions().empty() == closed_answer) return "frame " + std::to_string(i);
      scene.move(second, aside);
      if (i == 0) scene.collisions();
      scene.move(second, c.pose_b);
      scene.move(first, c.pose_a);
    }
  }
  return {};
}

/// At the margin that the distance is, if that is one, and near it.
std::string wrongMargin(const Case& c) {
  const mpq_class square = exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b);
  const double apart = exact::distanceBelow(square);
  if (!(apart > 0 && apart < 1e300)) return {};
  for (const double margin : {apart, std::nextafter(apart, 0.0), std::nextafter(apart, 2e300), 2 * apart}) {
    const bool is_below = square < mpq_class(margin) * margin;
    if (collide(c.a, c.pose_a, c.b, c.pose_b, open(margin)) != is_below) return "margin";
    PairCache cache;
    for (int i = 0; i < 2; ++i) {
      if (collide(c.b, c.pose_b, c.a, c.pose_a, cache, open(margin)) != is_below) return "margin, with a cache";
      if (collide(c.a, c.pose_a, c.b, c.pose_b, cache, {margin}) != exact::within(square, margin))
        return "margin, closed, with a cache";
    }
    if (collide(Strategy::Paper, c.a, c.pose_a, c.b, c.pose_b, open(margin)) != is_below) return "margin, paper";
    Scene scene;
    BodyOptions half;
    half.margin = margin / 2;
    scene.add(c.a, c.pose_a, half);
    if (scene.collides(c.b, c.pose_b, open(margin / 2)) != is_below) return "margin, scene";
    PenetrationOptions deep{margin, 1e3, Touching::Allowed};
    if (penetration(c.a, c.pose_a, c.b, c.pose_b, deep).has_value() != is_below) return "margin, penetration";
    ContactOptions parts;
    parts.margin = margin;
    parts.touching = Touching::Allowed;
    if (contacts(c.a, c.pose_a, c.b, c.pose_b, parts).empty() == is_below) return "margin, contacts";
  }
  return {};
}

/// What is listed, beside what is without the option, and that it is symmetric.
std::string wrongLists(const Case& c, const Truth& truth) {
  CrossingOptions inner;
  ContactOptions parts;
  PenetrationOptions deep;
  inner.touching = parts.touching = deep.touching = Touching::Allowed;
  deep.depth_error = 1e3;
  const std::vector<Crossing> found = crossings(c.a, c.pose_a, c.b, c.pose_b, inner);
  if (!found.empty() && !truth.overlap) return "crossings where interiors are apart";
  if (found.size() > crossings(c.a, c.pose_a, c.b, c.pose_b).size()) return "crossings, more than without";
  if (found.size() != crossings(c.b, c.pose_b, c.a, c.pose_a, inner).size()) return "crossings, swapped";
  for (const ContactDetail detail : {ContactDetail::Points, ContactDetail::LocalDepth}) {
    parts.detail = detail;
    PairCache cache;
    for (int i = 0; i < 2; ++i)
      if (contacts(c.a, c.pose_a, c.b, c.pose_b, cache, parts).empty() == truth.overlap)
        return "contacts, with a cache";
    const std::size_t count = contacts(c.a, c.pose_a, c.b, c.pose_b, parts).size();
    if ((count > 0) != truth.overlap) return "contacts";
    ContactOptions all;
    all.detail = detail;
    if (count > contacts(c.a, c.pose_a, c.b, c.pose_b, all).size()) return "contacts, more than without";
  }
  if (penetration(c.a, c.pose_a, c.b, c.pose_b, deep).has_value() != truth.overlap) return "penetration";
  return {};
}

class TouchingOracle : public testing::TestWithParam<Family> {};

TEST_P(TouchingOracle, AgreesWithExactRationals) {
  const int cases = scaledCount(kCases);
  int overlaps = 0, touches = 0, disagreements = 0;
  StrategyCaches old;
  for (int i = 0; i < cases; ++i) {
    const Case c = GetParam().make(static_cast<std::uint64_t>(i));
    const Truth truth{exact::collide(c.a, c.pose_a, c.b, c.pose_b), exact::interiorsMeet(c.a, c.pose_a, c.b, c.pose_b)};
    overlaps += truth.overlap;
    touches += truth.meet && !truth.overlap;
    ASSERT_LE(truth.overlap, truth.meet);
    std::string wrong = wrongWay(c, truth, old);
    if (wrong.empty()) wrong = wrongWayInScene(c, truth);
    if (wrong.empty() && i % 4 == 0) wrong = wrongLists(c, truth);
    if (wrong.empty() && !truth.meet) wrong = wrongMargin(c);
    if (wrong.empty()) continue;
    if (++disagreements <= 3) {
      ADD_FAILURE() << GetParam().name << " seed " << i << ": " << wrong << ", truth: meet " << truth.meet
                    << ", overlap " << truth.overlap << "\n"
                    << reproduction(c);
    }
  }
  std::printf("%-12s %6d cases %6d overlap %6d touch %4d disagreements\n", GetParam().name, cases, overlaps, touches,
              disagreements);
  EXPECT_EQ(disagreements, 0);
  if (cases >= 100) {
    EXPECT_GE(overlaps, kRareKind * cases);
    EXPECT_GE(touches, kRareKind * cases);
    EXPECT_GE(cases - overlaps - touches, kRareKind * cases);
  }
}

TEST(Touching, WhatHasNoAreaLeadsInsideOrHasNoInterior) {
  const Pose here = Pose::Identity();
  const Polygon square({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}});
  // In a corner, where no discs inside meet; it touches by its spike alone, where its ring begins.
  const Polygon aerial({{{0.5, 9}, {0.5, 8.75}, {0.25, 8.75}, {0.25, 8.25}, {0.75, 8.25}, {0.75, 8.75}, {0.5, 8.75}}});
  EXPECT_TRUE(collide(square, here, aerial, here, open()));
  EXPECT_FALSE(collide(square, here, point({4, 4}), here, open()));
  EXPECT_FALSE(collide(square, here, segment({-1, 4}, {4, 4}), here, open()));
  EXPECT_TRUE(collide(square, here, point({4, 4}), here, open(0.5)));
}

std::string familyName(const testing::TestParamInfo<Family>& family) { return family.param.name; }

INSTANTIATE_TEST_SUITE_P(Families, TouchingOracle, testing::ValuesIn(touchingFamilies()), familyName);

}  // namespace
}  // namespace tricover::support
