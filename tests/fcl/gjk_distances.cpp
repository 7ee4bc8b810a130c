// SPDX-License-Identifier: BSD-3-Clause
// Distances and depths of convex polygons beside those that FCL's GJK and EPA find for prisms over them. tricover's
// distances are held to the exact reference, so a difference is FCL's error; its depths are such that a smaller one
// can't be right, because the pair still overlaps once it has been moved by that much.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ask.h"
#include "exact_reference.h"
#include "prism.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"

namespace tricover_fcl::test {
namespace {

struct Tally {
  int count = 0, off = 0;       ///< off: by more than 1e-6 of the size, which is 1
  double worst = 0, least = 0;  ///< the largest difference, and the smallest one

  void add(double error) {
    ++count;
    off += std::abs(error) > 1e-6;
    least = std::min(least, error);
    if (std::abs(error) > std::abs(worst)) worst = error;
  }
};

/// LIBCCD's by its signed distance. INDEP's EPA finds depths of the wrong sign, which makes FCL's own signed distance
/// abort on an assertion, so collide is asked for it.
double depthOf(const fcl::Convexd& a, const Transform& tf_a, const fcl::Convexd& b, const Transform& tf_b,
               fcl::GJKSolverType solver) {
  if (solver == fcl::GST_LIBCCD) return -distanceOf(solver, true, a, tf_a, b, tf_b).min_distance;
  fcl::CollisionRequestd request(1, true);
  request.gjk_solver_type = solver;
  fcl::CollisionResultd result;
  return fcl::collide(&a, tf_a, &b, tf_b, request, result) > 0 ? -result.getContact(0).penetration_depth : 0;
}

constexpr const char* kNames[] = {"LIBCCD", "INDEP"};

TEST(GjkDistances, convex) {
  registerNarrowphase();
  Tally distances[2], depths[2];
  int missed[2] = {0, 0}, alarms[2] = {0, 0};
  for (int i = 0; i < scaledCount(3000); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const auto ring = [&] {
      const int corners = random.integer(3, 12);
      return regular(corners, random.real(0.3, 1));
    };
    const Ring ring_a = ring(), ring_b = ring();
    const Polygon a({ring_a}), b({ring_b});
    const Pose pose_a = turnedAndMoved(random.real(0, 6), 0, 0);
    const Pose pose_b = turnedAndMoved(random.real(0, 6), random.real(-1.5, 1.5), random.real(-1.5, 1.5));
    // Of unequal heights, and higher than wide: the shortest way out lies in the plane.
    const auto prism_a = tricover::support::makePrism(ring_a, 8), prism_b = tricover::support::makePrism(ring_b, 16);

    const double distance = tricover::distance(a, pose_a, b, pose_b).distance;
    const mpq_class square = tricover::exact::distanceSquared(a, pose_a, b, pose_b);
    const mpq_class ours = mpq_class(distance) * mpq_class(distance);
    ASSERT_LE(abs(ours - square), square * mpq_class(2.1e-14)) << i;
    const auto penetration = tricover::penetration(a, pose_a, b, pose_b);
    ASSERT_EQ(penetration.has_value(), distance == 0) << i;
    if (penetration) {
      Pose moved = pose_b;
      moved.translation() += penetration->translation;
      EXPECT_FALSE(tricover::exact::collide(a, pose_a, b, moved)) << i;
      moved.translation() = pose_b.translation() + (1 - 1e-9) * penetration->depth * penetration->normal;
      EXPECT_TRUE(tricover::exact::collide(a, pose_a, b, moved)) << i;
    }
    for (int s = 0; s < 2; ++s) {
      const auto result = distanceOf(kSolvers[s], false, prism_a, lifted(pose_a), prism_b, lifted(pose_b));
      if ((result.min_distance <= 0) != (distance == 0))
        ++(distance == 0 ? missed : alarms)[s];
      else if (distance > 0)
        distances[s].add(result.min_distance - distance);
      else
        depths[s].add(depthOf(*prism_a, lifted(pose_a), *prism_b, lifted(pose_b), kSolvers[s]) - penetration->depth);
    }
  }
  for (int s = 0; s < 2; ++s) {
    std::printf(
        "%-6s  distances %4d, off by more than 1e-6: %d, worst %+.1e; depths %4d, off: %d, worst %+.1e; "
        "misses %d, false alarms %d\n",
        kNames[s], distances[s].count, distances[s].off, distances[s].worst, depths[s].count, depths[s].off,
        depths[s].worst, missed[s], alarms[s]);
    EXPECT_GT(distances[s].count, 3 * depths[s].count / 10);
    EXPECT_GT(depths[s].count, 3 * distances[s].count / 10);
    // FCL's tolerance is 1e-6. Less than tricover finds can't be right.
    EXPECT_GT(distances[s].least, -1e-5) << kNames[s];
    EXPECT_GT(depths[s].least, -1e-5) << kNames[s];
    EXPECT_EQ(alarms[s], 0) << kNames[s];
  }
  EXPECT_EQ(missed[0] + distances[0].off + depths[0].off, 0);
  // INDEP's GJK gives up early now and then, and takes where it is for the distance, or for being apart; so does its
  // EPA, which then finds a longer way out than there is.
  EXPECT_LT(distances[1].off, distances[1].count / 20);
  EXPECT_LT(depths[1].off, depths[1].count / 5);
  EXPECT_LT(missed[1], depths[1].count / 100);
}

}  // namespace
}  // namespace tricover_fcl::test
