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
    std::vector<Vec2> place = {{-1, 0}, {1.2, 0}, {0, 1.5}};
    for (int step = 0; step < 400; ++step) {
      const double stride = random.oneIn(40) ? 1 : 0.02;
      for (std::size_t i = 0; i < 3; ++i) {
        angle[i] += stride * random.real(-1, 1);
        place[i] = 0.999 * place[i] + stride * Vec2(random.real(-1, 1), random.real(-1, 1));
        objects[i].setTransform(lifted(turnedAndMoved(angle[i], place[i].x(), place[i].y())));
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

/// Polygons' ids and poses' addresses, which differ from run to run: of tests about slots neither is real.
std::uint64_t id(std::uint64_t k) { return (std::uint64_t{0x12345} << 20) + k; }
const void* place(std::uintptr_t k) { return reinterpret_cast<const void*>(0x10000 + k); }

/// The slot of places that aren't new.
tricover::PairCache* slotOf(std::uint64_t a, const void* place_a, std::uint64_t b, const void* place_b) {
  pairCache(a, place_a, b, place_b);
  return pairCache(a, place_a, b, place_b);
}

/// On a thread whose table is new.
template <typename Test>
void onNewTable(const Test& test) {
  std::thread([&] { test(); }).join();
}

/// A thread whose table is as large as it becomes: slots stay where they are.
void growTable() {
  for (std::uintptr_t k = 0; k < 1 << 12; ++k) slotOf(id(0), place(k), id(1), nullptr);
}

TEST(Coherence, aPairHasOneSlotInEitherOrder) {
  onNewTable([] { EXPECT_EQ(slotOf(id(1), place(0), id(2), place(4)), slotOf(id(2), place(4), id(1), place(0))); });
}

/// However the two share cells of the table: of one pair in 64 its places' key and its ids' key do.
TEST(Coherence, everyPairHasACacheFromItsSecondTimeOn) {
  for (std::uint64_t k = 0; k < 1000; ++k) {
    onNewTable([k] {
      EXPECT_EQ(pairCache(id(k), place(8 * k), id(k + 1), place(400)), nullptr) << k;
      tricover::PairCache* const own = pairCache(id(k), place(8 * k), id(k + 1), place(400));
      ASSERT_NE(own, nullptr) << k;
      for (int time = 0; time < 5; ++time) ASSERT_EQ(pairCache(id(k + 1), place(400), id(k), place(8 * k)), own) << k;
    });
  }
}

/// As the pairs of a frame do, also where the table has fewer slots than they are when they begin.
TEST(Coherence, pairsThatTakeTurnsGetCaches) {
  for (const std::uint64_t pairs : {2, 3, 10, 100, 1000}) {
    for (const bool are_of_one_model : {true, false}) {
      for (std::uint64_t first = 0; first < (pairs < 10 ? 100 : 2); ++first) {
        std::uint64_t with_own = 0;
        onNewTable([&] {
          for (int frame = 0; frame < 1000; ++frame) {
            std::set<const tricover::PairCache*> caches;
            for (std::uint64_t k = 0; k < pairs; ++k) {
              const std::uint64_t model = are_of_one_model ? 0 : 2 * (1000 * first + k);
              caches.insert(pairCache(id(model), place(16 * (1000 * first + k)), id(model + 1), place(1)));
            }
            with_own = caches.size() - caches.count(nullptr);
          }
        });
        ASSERT_GE(with_own, pairs < 10 ? pairs : pairs * 4 / 5) << pairs << " from " << first;
      }
    }
  }
}

TEST(Coherence, newPlacesShareTheirPairsSlot) {
  onNewTable([] {
    std::set<const tricover::PairCache*> slots;
    // The table keeps nothing of a pair that is asked once.
    EXPECT_EQ(pairCache(id(1), place(0), id(2), place(0)), nullptr);
    for (std::uintptr_t k = 1; k < 100; ++k) slots.insert(pairCache(id(1), place(0), id(2), place(4 * k)));
    EXPECT_EQ(slots.size(), 1u);
    EXPECT_NE(*slots.begin(), nullptr);
    EXPECT_EQ(pairCache(id(1), place(0), id(3), place(0)), nullptr);
    EXPECT_NE(*slots.begin(), slotOf(id(1), place(0), id(3), place(0)));
  });
}

TEST(Coherence, aSlotThatWasAnotherPairsBeginsEmpty) {
  onNewTable([] {
    growTable();
    const auto rests = [](tricover::PairCache& slot) -> std::uint8_t& {
      return tricover::detail::contentsOf(slot).collision.back_off.left;
    };
    for (const void* of_c : {static_cast<const void*>(nullptr), place(0)}) {
      tricover::PairCache* const slot = slotOf(id(11), nullptr, id(12), nullptr);
      rests(*slot) = 200;
      int met = 0;
      for (std::uintptr_t k = 0; k < 1 << 17 && met == 0; ++k) {
        tricover::PairCache* const of_other = slotOf(id(11), place(k), id(13), of_c);
        ASSERT_EQ(rests(*of_other), 0);
        met += of_other == slot;
      }
      EXPECT_EQ(met, 1);
      // It is the first pair's again, and has to begin anew.
      EXPECT_EQ(slotOf(id(11), nullptr, id(12), nullptr), slot);
      EXPECT_EQ(rests(*slot), 0);
    }
  });
}

TEST(Coherence, fclCallsFillThePairsSlot) {
  onNewTable([] {
    Random random(13);
    const Polygon a = randomPolygon(random, 1), b = randomPolygon(random, 1);
    const fcl::CollisionObjectd object_a(shapeOf(a)), object_b(shapeOf(b), lifted(0, 1.7, 0));
    for (int time = 0; time < 2; ++time) {
      fcl::CollisionResultd result;
      fcl::collide(&object_b, &object_a, fcl::CollisionRequestd(), result);
    }
    tricover::PairCache* const slot = pairCache(a.id(), &object_a.getTransform(), b.id(), &object_b.getTransform());
    ASSERT_NE(slot, nullptr);
    const tricover::detail::Certificate& certificate = tricover::detail::contentsOf(*slot).collision;
    EXPECT_EQ((std::set<std::uint64_t>{certificate.first_id, certificate.second_id}),
              (std::set<std::uint64_t>{a.id(), b.id()}));
  });
}

TEST(Coherence, aTableIsSmallUntilUsed) {
  std::size_t at_first = 0, grown = 0;
  onNewTable([&] {
    for (std::uintptr_t k = 0; k < 3; ++k) slotOf(id(1), place(k), id(2), place(k));
    at_first = pairCacheBytes();
    growTable();
    grown = pairCacheBytes();
  });
  EXPECT_GT(at_first, 0u);
  EXPECT_LE(at_first, std::size_t{1} << 16);
  EXPECT_GT(grown, std::size_t{1} << 20);
  EXPECT_LE(grown, std::size_t{5} << 20);
}

TEST(Coherence, aPairKeepsItsCacheWhileTheTableGrows) {
  onNewTable([] {
    Random random(19);
    const Polygon a = randomPolygon(random, 1), b = randomPolygon(random, 1);
    const auto slot = [](std::uintptr_t k) { return slotOf(id(1), place(k), id(2), nullptr); };
    for (std::uintptr_t k = 0; k < 64; ++k)
      tricover::collide(a, Pose::Identity(), b, turnedAndMoved(0, 9, 0), *slot(k));
    int kept = 0;
    for (std::uintptr_t k = 0; k < 64; ++k) {
      const auto& certificate = tricover::detail::contentsOf(*slot(k)).collision;
      kept += certificate.first_id == a.id() || certificate.first_id == b.id();
    }
    EXPECT_GE(kept, 40);  // some share a slot
  });
}

TEST(Coherence, slotsSpread) {
  onNewTable([] {
    growTable();
    // A fleet of one model: 45 pairs of the same ids.
    const auto object = [](std::size_t i) { return place(i * sizeof(fcl::CollisionObjectd)); };
    std::set<const tricover::PairCache*> slots;
    for (std::size_t i = 0; i < 10; ++i)
      for (std::size_t j = 0; j < i; ++j) slots.insert(slotOf(id(4), object(i), id(4), object(j)));
    EXPECT_GE(slots.size(), 43u);

    slots.clear();
    for (std::uint64_t i = 0; i < 40; ++i)
      for (std::uint64_t j = 0; j < i; ++j) slots.insert(slotOf(id(i), nullptr, id(j), nullptr));
    EXPECT_GE(slots.size(), 700u);  // of 780 pairs
  });
}

}  // namespace
}  // namespace tricover_fcl::test
