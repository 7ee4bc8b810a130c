// SPDX-License-Identifier: BSD-3-Clause
// Every entry point says what the exact reference says, on every family: collide, boxes, distance, and margins.
#include "tricover/collide.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>

#include "ask.h"
#include "exact_reference.h"
#include "tricover/distance.h"

// float_scalar.cpp has it, as those of ask.h.
extern template std::size_t fcl::collide(const fcl::CollisionObjectf*, const fcl::CollisionObjectf*,
                                         const fcl::CollisionRequestf&, fcl::CollisionResultf&);

namespace tricover_fcl::test {
namespace {

/// A family's case as FCL has it.
template <typename S>
struct Posed {
  Shape<S> a, b;
  fcl::Transform3<S> tf_a, tf_b;
  fcl::CollisionObject<S> object_a, object_b;

  explicit Posed(const Case& c, double margin_a = 0, double margin_b = 0)
      : a(withMargin<S>(c.a, margin_a)),
        b(withMargin<S>(c.b, margin_b)),
        tf_a(lifted<S>(c.pose_a)),
        tf_b(lifted<S>(c.pose_b)),
        object_a(a, tf_a),
        object_b(b, tf_b) {}

  /// Of the boxes by which the broadphase decides.
  bool boxesOverlap() const { return object_a.getAABB().overlap(object_b.getAABB()); }
  bool tightBoxesOverlap() const { return a->boxAt(tf_a).overlap(b->boxAt(tf_b)); }

  /// By every entry point.
  void expectCollide(bool expected) const {
    for (const fcl::GJKSolverType solver : kSolvers) {
      fcl::CollisionRequest<S> request;
      request.gjk_solver_type = solver;
      const auto expect = [&](auto collide, const auto&... asked) {
        fcl::CollisionResult<S> result;
        EXPECT_EQ(collide(asked..., request, result), std::size_t{expected});
      };
      const auto fcls = [](auto&&... asked) { return fcl::collide<S>(asked...); };
      const auto ours = [](auto&&... asked) { return tricover_fcl::collide<S>(asked...); };
      expect(fcls, a.get(), tf_a, b.get(), tf_b);
      expect(fcls, b.get(), tf_b, a.get(), tf_a);
      expect(fcls, &object_a, &object_b);
      expect(fcls, &object_b, &object_a);
      expect(ours, a.get(), tf_a, b.get(), tf_b);
      expect(ours, &object_a, &object_b);
    }
  }
};

/// `check` of up to `most` cases of each family.
void ofEveryFamily(int most, const std::function<void(int, const Case&)>& check) {
  for (const Family& family : families()) {
    SCOPED_TRACE(family.name);
    for (int i = 0; i < most; ++i) {
      const Case c = family.make(static_cast<std::uint64_t>(i));
      check(i, c);
      if (::testing::Test::HasFailure()) {
        ADD_FAILURE() << reproduction(c);
        return;
      }
    }
  }
}

template <typename S>
void expectCollisionsAndBoxes() {
  const int count = std::max(20, scaledCount(300)), asked = std::max(20, scaledCount(200));
  int hits = 0, parted = 0, parted_tightly = 0, cases = 0, of_family = 0;
  ofEveryFamily(count, [&](int i, const Case& c) {
    const Posed<S> posed(c);
    if (!posed.tf_a.matrix().allFinite() || !posed.tf_b.matrix().allFinite()) return;  // beyond float
    const bool hit = tricover::exact::collide(c.a, flat(posed.tf_a), c.b, flat(posed.tf_b));
    if (i < asked) posed.expectCollide(hit);
    EXPECT_TRUE((posed.boxesOverlap() && posed.tightBoxesOverlap()) || !hit);
    ++cases;
    hits += hit;
    parted += !posed.boxesOverlap();
    parted_tightly += !posed.tightBoxesOverlap();
    of_family = (i == 0 ? 0 : of_family) + hit;
    if (i == count - 1 && std::is_same_v<S, double>) {  // the first of some families all overlap
      EXPECT_GT(of_family, 0);
      EXPECT_LT(of_family, count);
    }
  });
  EXPECT_GT(hits, cases / 5);
  EXPECT_LT(hits, cases * 4 / 5);
  EXPECT_GT(parted, 0);
  EXPECT_GT(parted_tightly, parted);
}

TEST(Families, collide) { expectCollisionsAndBoxes<double>(); }
TEST(Families, floatCollide) { expectCollisionsAndBoxes<float>(); }

TEST(Families, distance) {
  const int count = std::max(20, scaledCount(60));
  int overlaps = 0;
  ofEveryFamily(count, [&](int i, const Case& c) {
    const double truth = tricover::distance(c.a, c.pose_a, c.b, c.pose_b).distance;
    overlaps = (i == 0 ? 0 : overlaps) + (truth == 0);
    if (i == count - 1) {
      EXPECT_GT(overlaps, 0);
      EXPECT_LT(overlaps, count);
    }
    if (!(truth < std::numeric_limits<double>::max())) return;
    const Posed<double> posed(c);
    for (const fcl::GJKSolverType solver : kSolvers) {
      const auto geometries = distanceOf(solver, false, posed.a, posed.tf_a, posed.b, posed.tf_b);
      const auto swapped = distanceOf(solver, false, posed.b, posed.tf_b, posed.a, posed.tf_a);
      const double answer = geometries.min_distance;
      if (truth > 0)
        EXPECT_EQ(answer, truth);
      else
        EXPECT_TRUE(answer == 0 || answer == -1);
      EXPECT_EQ(swapped.min_distance, answer);
      fcl::DistanceRequestd request;
      request.gjk_solver_type = solver;
      fcl::DistanceResultd objects, ours;
      EXPECT_EQ(fcl::distance(&posed.object_a, &posed.object_b, request, objects), answer);
      EXPECT_EQ(tricover_fcl::distance(&posed.object_b, &posed.object_a, request, ours), answer);
      EXPECT_EQ(geometries.o1, posed.a.get());
      EXPECT_EQ(geometries.o2, posed.b.get());
      EXPECT_EQ(swapped.o1, posed.b.get());
      EXPECT_EQ(geometries.nearest_points[0].z(), 0);
      // As far apart as is said, but for the rounding of coordinates.
      const Vec3 &on_a = geometries.nearest_points[0], &on_b = geometries.nearest_points[1];
      const double extent = on_a.norm() + on_b.norm(), apart = std::max(answer, 0.0);
      if (extent < 1e150) {
        EXPECT_NEAR((on_a - on_b).stableNorm(), apart,
                    1e-320 + 1e-14 * (extent + apart + c.a.radius() + c.b.radius() + c.pose_a.translation().norm()));
      }
    }
  });
}

TEST(Families, marginsOfShapesAndOptions) {
  int hits = 0, cases = 0, apart_hits = 0;
  ofEveryFamily(scaledCount(40), [&](int, const Case& c) {
    const mpq_class square = tricover::exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b);
    const double gap = tricover::exact::distanceBelow(square);
    if (!(gap < 1e300)) return;
    // The largest double that isn't above the distance, and its neighbours, in two parts that add up exactly.
    for (const int steps : {-1, 0, 1}) {
      const double margin = gap > 0 ? nudged(gap, steps) : 0, of_a = margin / 2, of_b = margin - of_a;
      const bool expected = tricover::exact::within(square, mpq_class(of_a + of_b));
      const Posed<double> posed(c, of_a, of_b);
      EXPECT_EQ(meet(posed.a, posed.tf_a, posed.b, posed.tf_b), expected);
      fcl::CollisionResultd by_options;
      EXPECT_EQ(tricover_fcl::collide<double>(shapeOf(c.a).get(), posed.tf_a, posed.b.get(), posed.tf_b, {}, {of_a},
                                              by_options),
                std::size_t{expected});
      EXPECT_TRUE(!expected || posed.boxesOverlap());  // the broadphase doesn't lose the pair
      ++cases;
      hits += expected;
      apart_hits += expected && gap > 0;
    }
  });
  EXPECT_LT(hits, cases * 9 / 10);
  EXPECT_GT(apart_hits, cases / 10);
}

TEST(Collide, ignoresToleranceAndCachedGuess) {
  // A gap of one ulp, where FCL's own solvers see what their tolerance lets them see.
  const Shape<double> square = rectangular(0, 0, 1, 1);
  for (const double x : {1.0, nudged(1.0, 1)}) {
    for (const double tolerance : {1e-15, 1e-6, 1.0}) {
      fcl::CollisionRequestd request;
      request.gjk_tolerance = tolerance;
      request.enable_cached_gjk_guess = true;
      request.cached_gjk_guess = Vec3(-3, 1, 7);
      fcl::CollisionResultd result;
      EXPECT_EQ(fcl::collide(square.get(), kHere, square.get(), lifted(0, x, 0), request, result),
                std::size_t{x == 1.0});
    }
  }
}

}  // namespace
}  // namespace tricover_fcl::test
