// SPDX-License-Identifier: BSD-3-Clause
#include "polygons/pair_cache_table.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace tricover_fcl {
namespace {

constexpr int kSlotBits = 13;  // a thousand live pairs lose one in ten to a shared slot

template <typename Cache>
struct alignas(64) Slot {
  std::uint64_t places = 0;  ///< key of the pair and places that came here last
  Cache facts;
};
static_assert(sizeof(Slot<tricover::PairCache>) == 192);  // so 1.5 MiB a thread

template <typename Cache>
using Table = std::array<Slot<Cache>, std::size_t{1} << kSlotBits>;

/// A plain pointer beside its owner, because a thread_local with a destructor is asked for its state at every use.
template <typename Cache>
thread_local Table<Cache>* table = nullptr;

/// Plain, too: both can still be read when the owner is gone.
template <typename Cache>
thread_local bool ended = false;

template <typename Cache>
struct TableOwner {
  std::unique_ptr<Table<Cache>> slots = std::make_unique<Table<Cache>>();

  TableOwner() { table<Cache> = slots.get(); }
  ~TableOwner() {
    table<Cache> = nullptr;
    ended<Cache> = true;
  }
};

template <typename Cache>
Table<Cache>* makeTable() {
  if (ended<Cache>) return nullptr;
  thread_local const TableOwner<Cache> owner;
  return table<Cache>;
}

std::uint64_t mix(std::uint64_t id, const void* place) {
  const std::uint64_t h = (id + reinterpret_cast<std::uintptr_t>(place)) * 0x9E3779B97F4A7C15u;
  return h ^ (h >> 29);
}

/// The sum makes it order-free.
std::uint64_t keyOf(const tricover::Polygon& a, const void* place_a, const tricover::Polygon& b, const void* place_b) {
  return (mix(a.id() * 0xBF58476D1CE4E5B9u, place_a) + mix(b.id() * 0xBF58476D1CE4E5B9u, place_b)) *
         0x9E3779B97F4A7C15u;
}

}  // namespace

template <typename Cache>
Cache* pairCache(const tricover::Polygon& a, const void* place_a, const tricover::Polygon& b, const void* place_b) {
  Table<Cache>* const slots = table<Cache> != nullptr ? table<Cache> : makeTable<Cache>();
  if (slots == nullptr) return nullptr;
  const auto slot = [&](std::uint64_t key) -> Slot<Cache>& {
    return (*slots)[static_cast<std::size_t>(key >> (64 - kSlotBits))];
  };
  const std::uint64_t key = keyOf(a, place_a, b, place_b);
  Slot<Cache>& own = slot(key);
  if (own.places == key) return &own.facts;
  own.places = key;
  return &slot(keyOf(a, nullptr, b, nullptr)).facts;
}

#define TRICOVER_INSTANTIATE(Cache) \
  template Cache* pairCache(const tricover::Polygon&, const void*, const tricover::Polygon&, const void*);
TRICOVER_INSTANTIATE(tricover::PairCache)
TRICOVER_INSTANTIATE(tricover::DistanceCache)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
