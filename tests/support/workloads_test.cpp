// SPDX-License-Identifier: BSD-3-Clause
#include "workloads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/locate.h"

namespace tricover::workloads {
namespace {

double cross(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }

/// Exact on the grid, as kGrid says.
int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double area = cross(b - a, c - a);
  return (area > 0) - (area < 0);
}

double area(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) sum += cross(ring[i], ring[(i + 1) % ring.size()]);
  return sum / 2;
}

/// Of `moving` at a pose from `fixed`.
double gapAt(const Polygon& fixed, const Polygon& moving, const Pose& pose) {
  return distance(fixed, Pose::Identity(), moving, pose).distance;
}

class EveryKind : public testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(Workloads, EveryKind, testing::ValuesIn(allKinds()), [](const auto& kind) {
  std::string id = name(kind.param);
  std::replace(id.begin(), id.end(), ' ', '_');
  return id;
});

TEST_P(EveryKind, IsSimpleWithTheVerticesAskedFor) {
  for (std::size_t n = 8; n <= 1024; n *= 2) {
    for (std::uint64_t seed = 1; seed <= (n <= 128 ? 20u : 2u); ++seed) {
      SCOPED_TRACE("vertices " + std::to_string(n) + " seed " + std::to_string(seed));
      const Polygon polygon = makePolygon(GetParam(), n, seed);
      ASSERT_EQ(polygon.vertexCount(), n);
      ASSERT_EQ(polygon.rings().size(), GetParam() == Kind::WithHole ? 2u : 1u);
      EXPECT_GT(area(polygon.rings()[0]), 0);

      for (const Ring& ring : polygon.rings())
        for (std::size_t i = 0; i < ring.size(); ++i) {
          for (const double x : {ring[i].x(), ring[i].y()}) ASSERT_TRUE(std::abs(x) < 128 && std::fmod(x, kGrid) == 0);
          ASSERT_NE(orientation(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]), 0);
        }
      // Each edge meets itself and the two beside it.
      EXPECT_EQ(crossings(polygon, Pose::Identity(), polygon, Pose::Identity()).size(), 3 * n);
    }
  }
}

TEST_P(EveryKind, DependsOnItsSeedAlone) {
  EXPECT_EQ(makePolygon(GetParam(), 64, 7).rings(), makePolygon(GetParam(), 64, 7).rings());
  EXPECT_NE(makePolygon(GetParam(), 64, 7).rings(), makePolygon(GetParam(), 64, 8).rings());
}

TEST_P(EveryKind, CircularTrajectoryComesWithinTheGapAndNoNearer) {
  for (const std::size_t n : {8u, 32u, 128u}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE("vertices " + std::to_string(n) + " seed " + std::to_string(seed));
      const Polygon fixed = makePolygon(GetParam(), n, seed), moving = makePolygon(GetParam(), n, seed + 100);
      const auto poses = circularTrajectory(fixed, moving);
      ASSERT_EQ(poses.size(), kCircularPositions);
      EXPECT_NEAR(gapAt(fixed, moving, poses.front()), kGap, 1e-9);
      for (std::size_t i = 0; i < poses.size(); i += n < 100 ? 211 : 4001) {
        ASSERT_GE(gapAt(fixed, moving, poses[i]), kGap - 1e-9) << "position " << i;
        ASSERT_FALSE(collide(fixed, Pose::Identity(), moving, poses[i])) << "position " << i;
      }
      const double arm = (poses.front() * moving.coveringOrigin() - fixed.coveringOrigin()).norm();
      EXPECT_EQ(arm < fixed.radius() + moving.radius(), GetParam() != Kind::Convex) << "do the bounding discs meet?";
      const Vec2 step = poses[1] * moving.coveringOrigin() - poses[0] * moving.coveringOrigin();
      const Vec2 closing = poses.front() * moving.coveringOrigin() - poses.back() * moving.coveringOrigin();
      EXPECT_NEAR(step.norm(), closing.norm(), 1e-9) << "the last position is one step before the first";
    }
  }
}

TEST_P(EveryKind, LinearTrajectoryStartsAtTheGapAndEndsInCollision) {
  for (std::size_t n = 8; n <= 1024; n *= 2) {
    for (std::uint64_t seed = 1; seed <= (n <= 128 ? 10u : 2u); ++seed) {
      SCOPED_TRACE("vertices " + std::to_string(n) + " seed " + std::to_string(seed));
      const Polygon fixed = makePolygon(GetParam(), n, seed), moving = makePolygon(GetParam(), n, seed + 100);
      const auto poses = linearTrajectory(fixed, moving);
      ASSERT_EQ(poses.size(), kLinearPositions);
      EXPECT_NEAR(gapAt(fixed, moving, poses.front()), kGap, 1e-9);
      EXPECT_GT(gapAt(fixed, moving, poses[kLinearPositions * 9 / 10 - 2]), 0) << "before contact";
      EXPECT_EQ(gapAt(fixed, moving, poses[kLinearPositions * 9 / 10 + 2]), 0) << "after contact";
      EXPECT_EQ(gapAt(fixed, moving, poses.back()), 0);
      EXPECT_FALSE(collide(fixed, Pose::Identity(), moving, poses.front()));
      EXPECT_TRUE(collide(fixed, Pose::Identity(), moving, poses.back()));
    }
  }
}

TEST_P(EveryKind, CircularTrajectoryMayComeAsNearAsAsked) {
  for (const double gap : {0.1, 0.01}) {
    for (const std::size_t n : {8u, 64u, 1024u}) {
      SCOPED_TRACE("vertices " + std::to_string(n) + " gap " + std::to_string(gap));
      const Polygon fixed = makePolygon(GetParam(), n, 1), moving = makePolygon(GetParam(), n, 2);
      const auto poses = circularTrajectory(fixed, moving, gap);
      EXPECT_NEAR(gapAt(fixed, moving, poses.front()), gap, 1e-9);
      for (const Pose& pose : poses) ASSERT_FALSE(collide(fixed, Pose::Identity(), moving, pose));
    }
  }
}

double originDistance(const Polygon& fixed, const Polygon& moving, const Pose& pose) {
  return (pose * moving.coveringOrigin() - fixed.coveringOrigin()).norm();
}

TEST_P(EveryKind, ContactPosesAreWithinTwoPercentOfFirstContact) {
  for (const auto& [n, m] : {std::pair(8, 8), {64, 64}, {1024, 8}, {8, 512}}) {
    SCOPED_TRACE("vertices " + std::to_string(n) + " x " + std::to_string(m));
    const Polygon fixed = makePolygon(GetParam(), static_cast<std::size_t>(n), 1);
    const Polygon moving = makePolygon(GetParam(), static_cast<std::size_t>(m), 2);
    const auto poses = contactPoses(fixed, moving, 3);
    ASSERT_EQ(poses.size(), kRandomPositions);
    std::size_t hits = 0;
    for (const Pose& pose : poses) {
      const Vec2 arm = pose * moving.coveringOrigin() - fixed.coveringOrigin();
      const auto hitsAt = [&](double share) {
        Pose moved = pose;
        moved.translation() += (share - 1) * arm;
        return collide(fixed, Pose::Identity(), moving, moved);
      };
      const bool hit = hitsAt(1);
      hits += hit;
      // 1.02 / 0.98 is how far apart two of these can be on one way.
      const double reach = 1.02 / 0.98 * (1 + 1e-12);
      if (hit) {
        ASSERT_FALSE(hitsAt(reach)) << "deeper than 2 %";
        for (double share = reach; share < 3; share += 0.05) ASSERT_FALSE(hitsAt(share)) << "not the first contact";
      } else {
        bool met = false;
        for (double share = 1; !met && share > 1 / reach - 1e-4; share -= 1e-4) met = hitsAt(share);
        ASSERT_TRUE(met) << "farther than 2 %";
      }
    }
    EXPECT_GE(hits, kRandomPositions * 2 / 5);
    EXPECT_LE(hits, kRandomPositions * 3 / 5);
  }
}

TEST_P(EveryKind, NearAndOverlappingPosesAreAsFarApartAsTheySay) {
  const Polygon fixed = makePolygon(GetParam(), 64, 1), moving = makePolygon(GetParam(), 32, 2);
  const double radius = (fixed.radius() + moving.radius()) / 2;
  std::size_t near_hits = 0, overlapping_hits = 0;
  for (const Pose& pose : nearPoses(fixed, moving, 3)) {
    const double distance = originDistance(fixed, moving, pose);
    ASSERT_TRUE(distance >= 1.3 * radius - 1e-9 && distance <= 2 * radius + 1e-9);
    near_hits += collide(fixed, Pose::Identity(), moving, pose);
  }
  for (const Pose& pose : overlapPoses(fixed, moving, 3)) {
    ASSERT_LE(originDistance(fixed, moving, pose), radius + 1e-9);
    overlapping_hits += collide(fixed, Pose::Identity(), moving, pose);
  }
  EXPECT_LT(near_hits, kRandomPositions);
  EXPECT_GT(overlapping_hits, near_hits);
  EXPECT_GT(overlapping_hits, kRandomPositions / 3);
}

TEST(Workloads, RandomPosesDependOnTheirSeedAlone) {
  const Polygon fixed = makePolygon(Kind::Contour, 16, 1), moving = makePolygon(Kind::Contour, 16, 2);
  for (const auto make : {contactPoses, nearPoses, overlapPoses}) {
    const auto poses = make(fixed, moving, 7, 10), same = make(fixed, moving, 7, 10),
               other = make(fixed, moving, 8, 10);
    EXPECT_EQ(poses[9].matrix(), same[9].matrix());
    EXPECT_NE(poses[9].matrix(), other[9].matrix());
  }
}

TEST(Workloads, ConvexKindsAreConvexAndOthersAreNot) {
  for (const Kind kind : allKinds())
    for (std::size_t n = 8; n <= 1024; n *= 2) {
      if (n == 8 && kind == Kind::Contour) continue;  // may be either
      EXPECT_EQ(makePolygon(kind, n, n).isConvex(), kind == Kind::Convex || kind == Kind::Slim)
          << name(kind) << " with " << n << " vertices";
    }
}

TEST(Workloads, HoleLiesInsideTheContour) {
  const Polygon polygon = makePolygon(Kind::WithHole, 256, 3);
  EXPECT_LT(area(polygon.rings()[1]), 0);
  EXPECT_GT(area(polygon.rings()[0]) + area(polygon.rings()[1]), 0);
  EXPECT_EQ(locate(polygon, Vec2::Zero()), Location::Outside);
}

TEST(Workloads, RefusesOddAndFarVertexCounts) {
  for (const std::size_t n : {0u, 6u, 9u, 1026u})
    EXPECT_THROW(makePolygon(Kind::Contour, n, 1), std::invalid_argument) << n;
}

TEST(Workloads, OverlappingRingsDoOverlap) {
  struct Soup {
    std::size_t rings, corners;
    double squeeze;
  };
  for (const Soup& soup : {Soup{21, 3, 1}, {341, 3, 1}, {341, 3, 0.1}, {8, 8, 1}}) {
    const auto [rings, corners, squeeze] = soup;
    SCOPED_TRACE(std::to_string(rings) + " rings of " + std::to_string(corners));
    const auto make = [&soup](std::uint64_t seed) {
      return makeOverlapping(soup.rings, soup.corners, soup.squeeze, seed);
    };
    const Polygon polygon = make(1);
    EXPECT_EQ(polygon.rings(), make(1).rings());
    EXPECT_NE(polygon.rings(), make(2).rings());
    ASSERT_EQ(polygon.rings().size(), rings);
    std::size_t covered = 0;  // rings whose first vertex lies in another one
    for (std::size_t r = 0; r < polygon.rings().size(); ++r) {
      const Ring& ring = polygon.rings()[r];
      ASSERT_EQ(ring.size(), corners);
      EXPECT_GT(area(ring), 0);
      for (const Vec2& v : ring)
        for (const double x : {v.x(), v.y()}) ASSERT_TRUE(std::abs(x) < 128 && std::fmod(x, kGrid) == 0);
      std::vector<Ring> others = polygon.rings();
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(r));
      covered += locate(Polygon(others, FillRule::NonZero), ring[0]) == Location::Inside;
    }
    EXPECT_GT(2 * covered, rings);
    const auto circle = circularTrajectory(polygon, make(2), kGap, 4);
    EXPECT_NEAR(gapAt(polygon, make(2), circle.front()), kGap, 1e-9);
  }
}

TEST(Workloads, RefusesRingsThatAreNone) {
  EXPECT_THROW(makeOverlapping(1, 3, 1, 1), std::invalid_argument);
  EXPECT_THROW(makeOverlapping(2, 2, 1, 1), std::invalid_argument);
  for (const double squeeze : {0.04, 1.1, std::nan("")})
    EXPECT_THROW(makeOverlapping(2, 3, squeeze, 1), std::invalid_argument);
}

TEST(ReadPolygons, ReadsNamesRingsAndVertices) {
  std::istringstream text(
      "polygon one 1\nring 3\n0 0\n1 0\n0 1.5\npolygon two 2\nring 3\n0 0\n9 0\n0 9\nring 3\n1 1\n2 1\n1 2\n");
  const auto polygons = readPolygons(text);
  ASSERT_EQ(polygons.size(), 2u);
  EXPECT_EQ(polygons[0].name, "one");
  EXPECT_EQ(polygons[0].polygon.rings(), (std::vector<Ring>{{{0, 0}, {1, 0}, {0, 1.5}}}));
  EXPECT_EQ(polygons[1].polygon.rings().size(), 2u);
}

TEST(ReadPolygons, NamesThePolygonThatIsBroken) {
  for (const char* text : {"polygon one 1\nring 3\n0 0\n1 0\n0 x\n", "polygon one 1\nrang 3\n", "polygon one\n"}) {
    std::istringstream in(text);
    try {
      readPolygons(in);
      ADD_FAILURE() << text;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("'one'"), std::string::npos) << error.what();
    }
  }
}

TEST(ReadPolygons, ReadsTheCountries) {
  std::ifstream in(TRICOVER_COUNTRIES);
  const auto countries = readPolygons(in);
  EXPECT_EQ(countries.size(), 173u);
  std::size_t vertices = 0;
  for (const auto& [label, polygon] : countries) vertices += polygon.vertexCount();
  EXPECT_GT(vertices, 10000u);
}

}  // namespace
}  // namespace tricover::workloads
