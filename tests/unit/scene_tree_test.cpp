// SPDX-License-Identifier: BSD-3-Clause
// What scenes find bodies by: the tree of boxes, and where a body is known to be clear.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "random.h"
#include "scene/box_tree.h"
#include "scene/clear_box.h"
#include "shapes.h"
#include "test_scale.h"

namespace tricover::support {
namespace {

using detail::Bounds;

Bounds anyBox(Random& random, double size) {
  const double x = random.real(-50, 50), y = random.real(-50, 50);
  if (random.oneIn(40)) {
    const double far = random.coin() ? std::numeric_limits<double>::infinity() : 1.7e308;
    return {-far, y, far, random.coin() ? far : y};
  }
  return {x, y, x + random.real(0, size), y + (random.oneIn(9) ? 0 : random.real(0, size))};
}

double gap(const Bounds& p, const Bounds& q) {
  return std::hypot(std::max({0.0, p.min_x - q.max_x, q.min_x - p.max_x}),
                    std::max({0.0, p.min_y - q.max_y, q.min_y - p.max_y}));
}

/// What is to be shown is, no more often than once, and what is near comes first within a leaf at least.
void expectAll(const detail::BoxTree& tree, const std::map<std::uint32_t, Bounds>& all, Random& random) {
  const Bounds asked = anyBox(random, 10);
  std::vector<std::uint32_t> expected, found;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [item, box] : all) {
    ASSERT_TRUE(tree.holds(item));
    ASSERT_EQ(tree.boundsOf(item).min_x, box.min_x);
    if (box.meets(asked)) expected.push_back(item);
    least = std::min(least, gap(box, asked));
  }
  tree.visit(asked, [&](std::uint32_t item) {
    found.push_back(item);
    return true;
  });
  std::sort(found.begin(), found.end());
  ASSERT_EQ(found, expected);

  const double reach = random.coin() ? std::numeric_limits<double>::infinity() : random.real(0, 20);
  found.clear();
  tree.visitNear(asked, reach, [&](std::uint32_t item) {
    found.push_back(item);
    return reach;
  });
  std::sort(found.begin(), found.end());
  ASSERT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
  for (const auto& [item, box] : all) {
    const bool shown = std::binary_search(found.begin(), found.end(), item);
    ASSERT_TRUE(shown ? gap(box, asked) <= reach * (1 + 1e-15) : !(gap(box, asked) <= reach)) << gap(box, asked);
  }

  double nearest = std::numeric_limits<double>::infinity();
  tree.visitNear(asked, nearest,
                 [&](std::uint32_t item) { return nearest = std::min(nearest, gap(all.at(item), asked)); });
  ASSERT_EQ(nearest, least);
}

TEST(BoxTree, ShowsWhatALoopShows) {
  Random random(31);
  for (int round = 0; round < scaledCount(30); ++round) {
    detail::BoxTree tree;
    std::map<std::uint32_t, Bounds> all;
    const int most = round % 3 == 0 ? 12 : 700;
    for (int step = 0; step < 40; ++step) {
      const int many = random.integer(1, most / 8);
      for (int i = 0; i < many; ++i) {
        const auto item = static_cast<std::uint32_t>(random.integer(0, most));
        const Bounds box = anyBox(random, 4);
        if (!tree.holds(item)) {
          tree.insert(item, box);
          all[item] = box;
        } else if (random.coin()) {
          tree.move(item, box);
          all[item] = box;
        } else {
          tree.remove(item);
          all.erase(item);
        }
      }
      if (random.oneIn(5)) {
        std::vector<detail::BoxTree::Entry> entries;
        for (const auto& [item, box] : all)
          if (!random.oneIn(30)) entries.push_back({box, item});
        tree.pack(entries);
        all.clear();
        for (const auto& entry : entries) all[entry.child] = entry.bounds;
        ASSERT_EQ(tree.changes(), 0u);
      }
      expectAll(tree, all, random);
    }
  }
}

/// All at one place, and where middles overflow.
TEST(BoxTree, PacksWhatCannotBeDivided) {
  for (const Bounds& box : {Bounds{1, 1, 2, 2}, {1e-320, 0, 2e-320, 0}, {-1.7e308, -1e308, 1.7e308, 1.7e308}})
    for (const std::uint32_t count : {1u, 8u, 9u, 65u, 513u, 2000u}) {
      std::vector<detail::BoxTree::Entry> entries;
      for (std::uint32_t i = 0; i < count; ++i) entries.push_back({box, i});
      if (count > 8) entries[3].bounds = {-1.7e308, 1.7e308, -1.7e308, 1.7e308};
      detail::BoxTree tree;
      tree.pack(entries);
      std::uint32_t shown = 0;
      tree.visit({-1.7e308, -1.7e308, 1.7e308, 1.7e308}, [&](std::uint32_t) { return ++shown, true; });
      EXPECT_EQ(shown, count);
    }
}

TEST(ClearBox, LearnsWhereAContainerIsClear) {
  const Polygon container({rectangle(-9, -9, 9, 9), rectangle(-7, -4, 7, 4)});
  const Pose at = turnedAndMoved(0, 100, 50);
  const detail::Bounds body{91, 41, 109, 59}, seed{95, 47, 96, 48}, in_the_wall{92, 47, 95, 48};
  detail::ClearBox clear;
  EXPECT_FALSE(clear.holds(seed));
  clear.learn(detail::dataOf(container), at, 0.5, body, in_the_wall);
  EXPECT_FALSE(clear.holds(seed));
  clear.learn(detail::dataOf(container), at, 0.5, body, seed);
  EXPECT_TRUE(clear.holds(seed));
  EXPECT_TRUE(clear.holds({93.51, 46.51, 106.49, 53.49}));
  for (const detail::Bounds& beyond :
       {detail::Bounds{93.5, 47, 96, 48}, {95, 46.5, 96, 48}, {95, 47, 106.5, 48}, {95, 47, 96, 53.5}})
    EXPECT_FALSE(clear.holds(beyond));
  clear.forget();
  EXPECT_FALSE(clear.holds(seed));
}

}  // namespace
}  // namespace tricover::support
