// SPDX-License-Identifier: BSD-3-Clause
// What the adapter remembers between calls never shows in an answer.
#include <fcl/narrowphase/collision.h>

#include <cstdint>
#include <set>
#include <thread>

#include "polygon/cache_access.h"
#include "scene.h"
#include "shape/pair_cache_table.h"
#include "tricover/collide.h"
#include "tricover_fcl/collide.h"

namespace tricover_fcl::test {
namespace {

TEST(Coherence, walksAnswerAsColdQueriesInEitherOrder) {
  Random random(11);
  int hits = 0, queries = 0;
  for (int walk = 0; walk < 20; ++walk) {
    // Two objects of one polygon, and a third: pairs that only their places tell apart.
    const Shape<double> model = shapeOf(randomPolygon(random, 1)), other = shapeOf(randomPolygon(random, 1.5));
    std::vector<fcl::CollisionObjectd> objects(2, fcl::CollisionObjectd(model));
    objects.emplace_back(other);
    std::vector<double> angle(3);
    std::vector<tricover::Vec2> place = {{-1, 0}, {1.2, 0}, {0, 1.5}};
    for (int step = 0; step < 400; ++step) {
      const double stride = random.oneIn(40) ? 1 : 0.02;
      for (std::size_t i = 0; i < 3; ++i) {
        angle[i] += stride * random.real(-1, 1);
        place[i] = 0.999 * place[i] + stride * tricover::Vec2(random.real(-1, 1), random.real(-1, 1));
        objects[i].setTransform(lifted(tricover::support::pose(angle[i], place[i].x(), place[i].y())));
      }
      for (std::size_t i = 0; i < 3; ++i) {
        const fcl::CollisionObjectd *a = &objects[i], *b = &objects[(i + 1) % 3];
        if (random.coin()) std::swap(a, b);
        const auto polygon = [](const fcl::CollisionObjectd* object) {
          return static_cast<const PolygonShaped*>(object->collisionGeometry().get())->polygon();
        };
        const bool cold = tricover::collide(polygon(a), flat(a->getTransform()), polygon(b), flat(b->getTransform()));
        fcl::CollisionResultd result;
        ASSERT_EQ(fcl::collide(a, b, fcl::CollisionRequestd(), result), std::size_t{cold}) << walk << " " << step;
        hits += cold;
        ++queries;
      }
    }
  }
  EXPECT_GT(hits, queries * 3 / 10);
  EXPECT_LT(hits, queries * 7 / 10);
}

using Place = const void*;

/// The slot of places that aren't new.
tricover::PairCache* slotOf(const tricover::Polygon& a, Place place_a, const tricover::Polygon& b, Place place_b) {
  pairCache(a, place_a, b, place_b);
  return pairCache(a, place_a, b, place_b);
}

/// A thread whose table is as large as it becomes: slots stay where they are.
void growTable() {
  Random random(17);
  const tricover::Polygon a = randomPolygon(random, 1), b = randomPolygon(random, 1);
  static const char places[1 << 12] = {};
  for (const char& place : places) slotOf(a, &place, b, nullptr);
}

TEST(Coherence, aPairHasOneSlotInEitherOrder) {
  Random random(12);
  const tricover::Polygon a = randomPolygon(random, 1), b = randomPolygon(random, 1);
  const int places[2] = {};
  EXPECT_EQ(slotOf(a, &places[0], b, &places[1]), slotOf(b, &places[1], a, &places[0]));
}

TEST(Coherence, newPlacesShareTheirPairsSlot) {
  Random random(15);
  const tricover::Polygon a = randomPolygon(random, 1), b = randomPolygon(random, 1), c = randomPolygon(random, 1);
  const int places[100] = {};
  std::set<const tricover::PairCache*> slots;
  // Of a pair that is asked once nothing is kept.
  EXPECT_EQ(pairCache(a, places, b, places), nullptr);
  for (const int& place : places) slots.insert(pairCache(a, places, b, &place + 1));
  EXPECT_EQ(slots.size(), 1u);
  EXPECT_NE(*slots.begin(), nullptr);
  EXPECT_EQ(pairCache(a, places, c, places), nullptr);
  EXPECT_NE(*slots.begin(), slotOf(a, places, c, places));
}

TEST(Coherence, aSlotThatWasAnotherPairsBeginsEmpty) {
  Random random(16);
  const tricover::Polygon a = randomPolygon(random, 1), b = randomPolygon(random, 1), c = randomPolygon(random, 1);
  growTable();
  static const char places[1 << 17] = {};
  const auto rests = [](tricover::PairCache& slot) -> std::uint8_t& {
    return tricover::detail::contentsOf(slot).collision.back_off.left;
  };
  for (Place of_c : {Place(nullptr), Place(&places[0])}) {
    tricover::PairCache* const slot = slotOf(a, nullptr, b, nullptr);
    rests(*slot) = 200;
    int met = 0;
    for (const char& place : places) {
      tricover::PairCache* const of_other = slotOf(a, &place, c, of_c);
      ASSERT_EQ(rests(*of_other), 0);
      met += of_other == slot;
      if (met > 0) break;
    }
    EXPECT_EQ(met, 1);
    // It is the first pair's again, and has to begin anew.
    EXPECT_EQ(slotOf(a, nullptr, b, nullptr), slot);
    EXPECT_EQ(rests(*slot), 0);
  }
}

TEST(Coherence, fclCallsFillThePairsSlot) {
  Random random(13);
  const tricover::Polygon a = randomPolygon(random, 1), b = randomPolygon(random, 1);
  const fcl::CollisionObjectd object_a(shapeOf(a)), object_b(shapeOf(b), lifted(0, 1.7, 0));
  for (int time = 0; time < 2; ++time) {
    fcl::CollisionResultd result;
    fcl::collide(&object_b, &object_a, fcl::CollisionRequestd(), result);
  }
  const tricover::detail::Certificate& certificate =
      tricover::detail::contentsOf(*slotOf(a, &object_a.getTransform(), b, &object_b.getTransform())).collision;
  EXPECT_EQ((std::set<std::uint64_t>{certificate.first_id, certificate.second_id}),
            (std::set<std::uint64_t>{a.id(), b.id()}));
}

TEST(Coherence, aTableIsSmallUntilUsed) {
  Random random(18);
  const Shape<double> a = shapeOf(randomPolygon(random, 1)), b = shapeOf(randomPolygon(random, 1));
  std::size_t at_first = 0, grown = 0;
  std::thread([&] {
    for (int time = 0; time < 3; ++time) {
      const fcl::CollisionObjectd object_a(a), object_b(b);
      fcl::CollisionResultd result;
      tricover_fcl::collide(&object_a, &object_b, fcl::CollisionRequestd(), result);
    }
    at_first = pairCacheBytes();
    growTable();
    grown = pairCacheBytes();
  }).join();
  EXPECT_GT(at_first, 0u);
  EXPECT_LE(at_first, std::size_t{1} << 16);
  EXPECT_GT(grown, std::size_t{1} << 20);
  EXPECT_LE(grown, std::size_t{5} << 20);
}

TEST(Coherence, aPairKeepsItsCacheWhileTheTableGrows) {
  std::thread([] {
    Random random(19);
    const tricover::Polygon a = randomPolygon(random, 1), b = randomPolygon(random, 1);
    // Addresses that no run chooses anew, and that nobody reads.
    const auto place = [](std::uintptr_t k) { return reinterpret_cast<const void*>(0x10000 + k); };
    for (std::uintptr_t k = 0; k < 64; ++k) {
      tricover::PairCache* const slot = slotOf(a, place(k), b, nullptr);
      tricover::collide(a, tricover::Pose::Identity(), b, tricover::support::pose(0, 9, 0), *slot);
    }
    int kept = 0;
    for (std::uintptr_t k = 0; k < 64; ++k) {
      const auto& certificate = tricover::detail::contentsOf(*slotOf(a, place(k), b, nullptr)).collision;
      kept += certificate.first_id == a.id() || certificate.first_id == b.id();
    }
    EXPECT_GE(kept, 40);  // some share a slot
  }).join();
}

TEST(Coherence, slotsSpread) {
  growTable();
  // A fleet of one model: 45 pairs of the same ids.
  Random random(14);
  const tricover::Polygon model = randomPolygon(random, 1);
  const auto place = [](std::size_t i) {
    return reinterpret_cast<const void*>(0x10000 + i * sizeof(fcl::CollisionObjectd));
  };
  std::set<const tricover::PairCache*> slots;
  for (std::size_t i = 0; i < 10; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      slots.insert(slotOf(model, place(i), model, place(j)));
    }
  }
  EXPECT_GE(slots.size(), 43u);

  slots.clear();
  std::vector<tricover::Polygon> polygons;
  for (int i = 0; i < 40; ++i) polygons.push_back(randomPolygon(random, 1));
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) slots.insert(slotOf(polygons[i], nullptr, polygons[j], nullptr));
  }
  EXPECT_GE(slots.size(), 700u);  // of 780 pairs
}

}  // namespace
}  // namespace tricover_fcl::test
