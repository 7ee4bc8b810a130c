// SPDX-License-Identifier: BSD-3-Clause
// castRayAll() with a margin costs few looks at edges, for many intervals and where lengths are lost in rounding.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hierarchy/simd.h"
#include "shapes.h"
#include "tricover/polygon.h"
#include "tricover/ray.h"

namespace tricover::support {
namespace {

/// While one lives, counts the edges that are looked at along rays.
class CountedEdges {
 public:
  CountedEdges() { count = 0, detail::visitEdgesOnRay = &visitCounted, detail::showPairs = &showCounted; }
  ~CountedEdges() { detail::usePortableLanes(false); }
  static inline std::size_t count;

 private:
  template <typename Call>
  static void withFastest(const Call& call) {
    detail::usePortableLanes(false);
    call();
    detail::visitEdgesOnRay = &visitCounted, detail::showPairs = &showCounted;
  }
  struct Visit {
    bool (*visit)(void*, std::uint32_t);
    void* context;
  };
  static void visitCounted(const detail::Hierarchy& tree, const detail::Ray& ray, bool (*visit)(void*, std::uint32_t),
                           void* context) {
    Visit inner{visit, context};
    const auto counted = [](void* of, std::uint32_t edge) {
      ++count;
      return static_cast<Visit*>(of)->visit(static_cast<Visit*>(of)->context, edge);
    };
    withFastest([&] { detail::visitEdgesOnRay(tree, ray, counted, &inner); });
  }
  static void showCounted(const detail::Descent& descent, const detail::PairVisitor& visitor) {
    struct Counted {
      static double visit(void* of, double gap, std::uint32_t a, std::uint32_t b) {
        ++count;
        const auto& inner = *static_cast<const detail::PairVisitor*>(of);
        return inner.visit(inner.context, gap, a, b);
      }
    };
    detail::PairVisitor inner = visitor;
    withFastest([&] { detail::showPairs(descent, {&inner, &Counted::visit, nullptr}); });
  }
};

/// Each interval costs what is near it, however many there are.
TEST(RayAll, WithAMarginLooksAtAnEdgeAFewTimes) {
  constexpr int kCount = 2000;
  Ring teeth;
  std::vector<Ring> posts;
  for (int i = 0; i < kCount; ++i) {
    teeth.emplace_back(i, i % 2 == 0 ? -1 : 1);
    posts.push_back(rectangle(3 * i, 0, 3 * i + 1, 1));
  }
  teeth.emplace_back(kCount, 9);
  teeth.emplace_back(-1, 9);
  const Polygon zigzag({teeth}), row(posts);
  const auto count = [&](const Polygon& polygon, double y, double margin) {
    const CountedEdges edges;
    const auto all = castRayAll(polygon, Pose::Identity(), {-5, y}, {3 * kCount + 5, y}, {margin});
    EXPECT_LE(edges.count, 120u * kCount) << y << ", " << margin;
    return all.size();
  };
  EXPECT_EQ(count(zigzag, 0, 1e-3), kCount / 2 + 0u);
  EXPECT_EQ(count(row, 0.5, 0.25), kCount + 0u);
  EXPECT_EQ(count(row, 1.125, 0.25), kCount + 0u);
  EXPECT_EQ(count(row, 1.125, 0.125), kCount + 0u);  // along the grown boxes' sides
  EXPECT_EQ(count(row, 0.5, 1), 1u);
  EXPECT_EQ(count(row, 2, 0.5), 0u);
}

/// Where a length is lost in rounding beside another one, all within that may be one interval: at once.
TEST(RayAll, WithAMarginAtExtremeRatios) {
  const Pose here = Pose::Identity();
  const Polygon square({rectangle(-1, -1, 1, 1)});
  const auto expectBegin = [&](const Polygon& polygon, const Vec2& from, const Vec2& to, double margin) {
    const CountedEdges edges;
    const auto all = castRayAll(polygon, here, from, to, {margin});
    const auto first = castRay(polygon, here, from, to, {margin});
    EXPECT_LE(edges.count, 1000u) << from << " " << to << " " << margin;
    ASSERT_EQ(all.empty(), !first.has_value()) << from << " " << to << " " << margin;
    EXPECT_LE(all.size(), 2u);
    if (first) {
      EXPECT_EQ(all[0].begin.fraction, first->fraction);
    }
    for (const RayInterval& part : all) EXPECT_LE(part.begin.fraction, part.end.fraction);
  };
  for (const double large : {1e8, 1e20, 1e70, 1e150, 1e308})
    for (const double margin : {0.5, 0.95, 1e-9, 1e-200, 1e30}) {
      expectBegin(Polygon({{{0, 0}, {1, 0}, {large, 1}, {0, 1}}}), {-2, 0.5}, {3, 0.5}, margin);
      expectBegin(square.complement(), {0.1, -large}, {0.2, 0.1}, margin);
      expectBegin(square.complement(), {0.2, 0.1}, {0.1, -large}, margin);
      expectBegin(square, {0.2, large}, {0.1, -large}, margin);
      expectBegin(square.scaled(1 / large), {-3, 0.1}, {4, 0.1}, margin);
      expectBegin(square, {-3 / large, 0}, {4 / large, 0}, margin);
      expectBegin(Polygon::point({0, 0}), {-3, 0.1}, {4, 0.1}, margin * large < 1e308 ? margin * large : margin);
    }
  // A tiny polygon is a disc.
  const auto disc = castRayAll(square.scaled(1e-100), here, {-3, 0.3}, {7, 0.3}, {0.5});
  ASSERT_EQ(disc.size(), 1u);
  EXPECT_NEAR(disc[0].begin.fraction, 0.26, 1e-13);
  EXPECT_NEAR(disc[0].end.fraction, 0.34, 1e-13);
}

}  // namespace
}  // namespace tricover::support
