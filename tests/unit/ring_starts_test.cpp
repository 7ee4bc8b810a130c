// SPDX-License-Identifier: BSD-3-Clause
// Which rings are connected, against exact rationals; and that answers don't depend on whether that is known.
#include "pair/ring_starts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "exact_reference.h"
#include "hierarchy/hierarchy.h"
#include "pair/containment.h"
#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/locate.h"
#include "tricover/prepare.h"

namespace tricover::support {
namespace {

constexpr double kAny = std::numeric_limits<double>::quiet_NaN();  ///< no bound

/// The positions of rings' first edges.
std::vector<std::uint32_t> startsOf(const Polygon& polygon, std::vector<std::uint32_t> rings) {
  for (std::uint32_t& ring : rings) ring = static_cast<std::uint32_t>(detail::dataOf(polygon).edgeBegin(ring));
  return rings;
}

/// Each group of rings whose edges meet, by its first.
std::vector<std::uint32_t> firstRings(const Polygon& polygon) {
  std::vector<std::uint32_t> ring_of, group(polygon.rings().size());
  std::iota(group.begin(), group.end(), 0u);
  for (std::uint32_t r = 0; r < group.size(); ++r) ring_of.insert(ring_of.end(), polygon.rings()[r].size(), r);
  const Pose still = Pose::Identity();
  for (const auto& [i, j] : exact::meetingEdges(polygon, still, polygon, still)) {
    const std::uint32_t g = group[ring_of[static_cast<std::size_t>(i)]],
                        h = group[ring_of[static_cast<std::size_t>(j)]];
    for (std::uint32_t& other : group) other = other == std::max(g, h) ? std::min(g, h) : other;
  }
  std::vector<std::uint32_t> firsts;
  for (std::uint32_t r = 0; r < group.size(); ++r)
    if (group[r] == r) firsts.push_back(r);
  return firsts;
}

/// Triangles on a small grid: they overlap, touch at corners or along edges, hold each other, or are apart. Beside the
/// rings that are given.
Polygon triangles(Random& random, std::vector<Ring> rings = {}) {
  const int n = random.integer(2, 25), size = random.integer(2, 12);
  for (int i = 0; i < n; ++i) {
    const double hardly_apart = random.oneIn(3) ? 1e-9 : 0;
    const Vec2 at(random.integer(0, 2 * size) + hardly_apart, random.integer(0, 2 * size));
    const double reach = random.oneIn(8) ? 20 : 1;
    rings.push_back({at, at + Vec2(reach, random.integer(0, 1)), at + Vec2(random.integer(0, 1), reach)});
  }
  return Polygon(rings, random.coin() ? FillRule::NonZero : FillRule::EvenOdd);
}

TEST(RingStarts, AreFoundByPlace) {
  std::vector<Ring> rings;
  for (int i = 0; i < 20; ++i) rings.push_back(rectangle(7 * i % 20, 0, 7 * i % 20 + 0.5, 1));
  const Polygon polygon(rings);
  const detail::RingStarts starts(detail::dataOf(polygon));
  // At 14, 0, 7 and 1, by the edges that begin there; the bound is included.
  EXPECT_EQ(starts.near({14, 0}, 0), startsOf(polygon, {2}));
  EXPECT_EQ(starts.near({0, -1}, 1.5), startsOf(polygon, {0, 3}));
  EXPECT_TRUE(starts.near({0.75, 0.5}, 0.2).empty());
  EXPECT_TRUE(starts.near({10, 0.5}, 0.4).empty());
  EXPECT_EQ(starts.near({0, 0}, kAny).size(), 20u);
}

/// Tiny rings on a small grid, many of them at one place.
Polygon crumbs(Random& random) {
  const double hardly_apart = 1e-9;  // rings of different places don't touch
  std::vector<Ring> rings;
  for (int k = random.integer(1, 60); k > 0; --k) {
    const Vec2 at(random.integer(0, 6), random.integer(0, 6));
    rings.push_back({at, at + Vec2(hardly_apart, 0), at + Vec2(0, hardly_apart)});
  }
  return Polygon(rings);
}

/// Of all; of crumbs in discs, too, that end at them.
TEST(RingStarts, AreOneAComponentAndThoseInTheDisc) {
  int rings = 0, starts_found = 0, found = 0, all = 0;
  for (int i = 0; i < scaledCount(600); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Polygon polygon = i % 2 == 0 ? triangles(random) : crumbs(random);
    const detail::RingStarts starts(detail::dataOf(polygon));
    const std::vector<std::uint32_t> firsts = firstRings(polygon);
    EXPECT_EQ(starts.near({0, 0}, kAny), startsOf(polygon, firsts)) << i;
    rings += static_cast<int>(polygon.rings().size());
    starts_found += static_cast<int>(firsts.size());
    for (int k = 0; k < (i % 2) * 10; ++k) {
      const Vec2 center(random.integer(-1, 7), random.integer(-1, 7));
      const double radius = random.integer(0, 3);
      std::vector<std::uint32_t> truth;
      for (const std::uint32_t ring : firsts)
        if ((polygon.rings()[ring].front() - center).norm() <= radius) truth.push_back(ring);
      EXPECT_EQ(starts.near(center, radius), startsOf(polygon, truth)) << i;
      found += static_cast<int>(truth.size());
      all += static_cast<int>(firsts.size());
    }
  }
  EXPECT_GE(starts_found, 0.2 * rings);
  EXPECT_LE(starts_found, 0.8 * rings);
  EXPECT_GE(found, 0.05 * all);
  EXPECT_LE(found, 0.5 * all);
}

/// Asked until the starts are known, and after.
TEST(RingStarts, ChangeNoAnswer) {
  int cases = 0, hits = 0, known = 0;
  for (int i = 0; i < scaledCount(60); ++i) {
    Random random(static_cast<std::uint64_t>(i) + 5000);
    // In the frame, or beside it.
    const Polygon a = triangles(random, {rectangle(-45, -45, 45, 45)}), b = triangles(random);
    std::vector<Pose> poses;
    std::vector<detail::Outcome> first;
    for (int k = 0; k < 30; ++k)
      poses.push_back(turnedAndMoved(random.real(0, 6), random.real(-1, 1) * 60, random.real(-1, 1) * 60));
    const auto ask = [&](const Pose& at) {
      // Only where no edges meet is there anything to find.
      if (!exact::meetingEdges(a, Pose::Identity(), b, at).empty()) return detail::Outcome();
      const Pose still = Pose::Identity();
      return detail::findContainment(detail::PosedPair(detail::dataOf(a), still, detail::dataOf(b), at));
    };
    for (const Polygon* polygon : {&a, &b}) detail::hierarchyOf(detail::dataOf(*polygon));
    for (const Pose& at : poses) first.push_back(ask(at));
    for (const Polygon* polygon : {&a, &b})
      detail::countRings(detail::dataOf(*polygon), 1000 * detail::dataOf(*polygon).path.size(), 0);
    for (std::size_t k = 0; k < poses.size(); ++k) {
      const detail::Outcome again = ask(poses[k]);
      ++cases;
      hits += again.collides;
      EXPECT_EQ(again.collides, first[k].collides);
      EXPECT_EQ(again.edge_a, first[k].edge_a);
      EXPECT_EQ(again.edge_b, first[k].edge_b);
    }
    known += detail::ringStarts(detail::dataOf(a)) != nullptr;
  }
  EXPECT_GE(hits, 0.01 * cases);
  EXPECT_LE(hits, 0.9 * cases);
  EXPECT_GE(known, scaledCount(60) / 2);
}

/// Each of many islands in turn at the end of a bar that holds no other, asked both ways.
TEST(RingStarts, AreFoundAtTheEndOfWhatHoldsThem) {
  std::vector<Ring> rings;
  for (int i = 0; i < 30; ++i) rings.push_back(rectangle(2 * i, 0, 2 * i + 0.1, 0.1));
  const Polygon islands(rings), bar({rectangle(0, 0, 1.9, 0.3)});
  detail::hierarchyOf(detail::dataOf(islands));
  detail::countRings(detail::dataOf(islands), 1000 * detail::dataOf(islands).path.size(), 0);
  ASSERT_NE(detail::ringStarts(detail::dataOf(islands)), nullptr);
  const Pose still = Pose::Identity();
  for (int i = 0; i < 30; ++i)
    for (const double x : {2 * i - 0.05, 2 * i - 1.75}) {
      const Pose at = turnedAndMoved(0, x, -0.1);
      const auto start = static_cast<std::ptrdiff_t>(5 * i);  // four edges and the closing vertex
      EXPECT_EQ(
          detail::findContainment(detail::PosedPair(detail::dataOf(islands), still, detail::dataOf(bar), at)).edge_a,
          start);
      EXPECT_EQ(
          detail::findContainment(detail::PosedPair(detail::dataOf(bar), at, detail::dataOf(islands), still)).edge_b,
          start);
    }
}

/// Where edges of all rings meet all others', finding the components ends early, with more starts than need be.
TEST(RingStarts, OfVeryManyCrossings) {
  std::vector<Ring> rings;
  for (int i = 0; i < 400; ++i) {
    rings.push_back({Vec2(0, i), Vec2(400, i), Vec2(400, i + 0.5)});
    rings.push_back({Vec2(i, -1), Vec2(i, 401), Vec2(i + 0.5, 401)});
  }
  const Polygon polygon(rings);
  EXPECT_EQ(detail::RingStarts(detail::dataOf(polygon)).near({0, 0}, kAny).front(), 0u);
}

/// S itself, where the vertices that the covering might be taken from are near S, too.
TEST(Locate, AtTheOriginOfTheCoveringBetweenVertices) {
  const Polygon waist({{{1e-3, 0}, {3, 3}, {0, 3}, {-3, 3}, {-1e-3, 0}, {-3, -3}, {0, -3}, {3, -3}}});
  EXPECT_EQ(locate(waist, waist.coveringOrigin()), Location::Inside);
  EXPECT_EQ(exact::locate(waist, waist.coveringOrigin()), Location::Inside);
}

}  // namespace
}  // namespace tricover::support
