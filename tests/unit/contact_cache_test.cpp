// SPDX-License-Identifier: BSD-3-Clause
// contacts() with a cache: the same bits as without, on walks that rest, slide, turn, part and jump, and with other
// polygons' cache; and that its certificates answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "families.h"
#include "polygon/cache_access.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/contacts.h"
#include "tricover/penetration.h"

namespace tricover::support {
namespace {

bool same(const std::vector<Contact>& found, const std::vector<Contact>& expected) {
  return std::equal(found.begin(), found.end(), expected.begin(), expected.end(), [](auto& p, auto& q) {
    return p.point == q.point && p.normal == q.normal && p.depth == q.depth && p.edge_a == q.edge_a &&
           p.edge_b == q.edge_b;
  });
}

/// How a body goes on from pose to pose.
void step(Random& random, int manner, double length, const Vec2& along, Case& c) {
  if (manner == 0 || manner == 3) c.pose_b.translation() += length * along;
  if (manner == 1) turn(c.pose_b, length);
  if (manner == 2) c.pose_b.translation() += length * direction(random.real(0, 6.3));
  if (manner == 3) turn(c.pose_a, length);
  if (random.oneIn(100))
    c.pose_b.translation() = c.pose_a.translation() + random.unit() * direction(random.real(0, 6.3));
}

struct Tally {
  int queries = 0, overlaps = 0, apart = 0, apart_kept = 0, wrong = 0;
};

void walk(int seed, bool convex, Tally& tally, PairCache& cache) {
  Random random(static_cast<std::uint64_t>(seed));
  const double size = random.real(0.1, 1);
  const auto any = [&] {
    return convex ? eitherWay(random, anyConvex(random, 1)) : star(random, random.integer(4, 9), 0.5, 1);
  };
  Case c{Polygon({any()}), randomPose(random, 3), Polygon({scaled(any(), size)}), randomPose(random, 0)};
  if (random.oneIn(6)) c.b = c.a;
  if (random.oneIn(4)) c.pose_b.linear() = c.pose_a.linear();
  if (random.oneIn(6)) c.pose_a = mirrored(c.pose_a);
  if (random.oneIn(6)) c.pose_b = throughFloat(c.pose_b);
  Vec2 along = direction(random.real(0, 6.3));
  c.pose_b.translation() = c.pose_a.translation() + random.real(0.1, 1.2 + size) * along;
  // As a body that rests on another: out of it until they only just overlap, then along the way across.
  if (const auto deep = penetration(c.a, c.pose_a, c.b, c.pose_b); deep && deep->optimal && random.coin()) {
    c.pose_b.translation() += 0.97 * deep->translation;
    along = Vec2(-deep->normal.y(), deep->normal.x());
  }
  const int manner = random.integer(0, 3);
  const double length = 0.002 * size * (random.coin() ? 1 : -1) * (random.oneIn(4) ? 10 : 1);
  const bool swaps = random.oneIn(4);
  const detail::PairCacheContents& certificates = detail::contentsOf(cache);
  for (int i = 0; i < 60; ++i, step(random, manner, length, along, c)) {
    const std::vector<Contact> expected = contacts(c.a, c.pose_a, c.b, c.pose_b);
    const auto uses = certificates.collision.uses;
    std::vector<Contact> found =
        swaps && i % 2 ? contacts(c.b, c.pose_b, c.a, c.pose_a, cache) : contacts(c.a, c.pose_a, c.b, c.pose_b, cache);
    if (swaps && i % 2)
      for (Contact& contact : found) {
        contact.normal = -contact.normal;
        std::swap(contact.edge_a, contact.edge_b);
      }
    ++tally.queries;
    (expected.empty() ? tally.apart : tally.overlaps)++;
    tally.apart_kept += expected.empty() && certificates.collision.uses == uses + 1;
    // Of a polygon and itself at one place the order is the caller's.
    if (c.a.id() == c.b.id() && found.size() == expected.size() && c.pose_a.matrix() == c.pose_b.matrix()) continue;
    if (!same(found, expected) && ++tally.wrong <= 3)
      ADD_FAILURE() << "walk " << seed << ", step " << i << ": " << found.size() << " and " << expected.size() << "\n"
                    << reproduction(c);
  }
}

TEST(ContactCache, ChangesNoContactOfConvexPairs) {
  Tally tally;
  PairCache others;
  const int walks = scaledCount(600);
  for (int i = 0; i < walks; ++i) {
    PairCache own;
    walk(i, true, tally, i % 4 == 0 ? others : own);
  }
  std::printf("%d queries, %d overlap, %d apart, %d of them by certificates, %d wrong\n", tally.queries, tally.overlaps,
              tally.apart, tally.apart_kept, tally.wrong);
  EXPECT_EQ(tally.wrong, 0);
  if (walks >= 50) {
    EXPECT_GE(tally.overlaps, 0.2 * tally.queries);
    EXPECT_GE(tally.apart, 0.1 * tally.queries);
    EXPECT_GE(tally.apart_kept, 0.4 * tally.apart);
  }
}

TEST(ContactCache, ChangesNoContactOfStars) {
  Tally tally;
  const int walks = scaledCount(30);
  for (int i = 0; i < walks; ++i) {
    PairCache cache;
    walk(i, false, tally, cache);
  }
  EXPECT_EQ(tally.wrong, 0);
  if (walks >= 20) {
    EXPECT_GE(tally.overlaps, 0.2 * tally.queries);
    EXPECT_GE(tally.apart_kept, 0.3 * tally.apart);
  }
}

}  // namespace
}  // namespace tricover::support
