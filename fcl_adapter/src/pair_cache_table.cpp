// SPDX-License-Identifier: BSD-3-Clause
#include "pair_cache_table.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tricover_fcl {
namespace {

constexpr int kSlotBits = 13;  // 1 MiB a thread; a thousand live pairs lose one in ten to a shared slot

struct Slot {
  std::uint64_t places = 0;  ///< key of the pair and places that came here last
  tricover::PairCache facts;
};

std::uint64_t mix(std::uint64_t id, const void* place) {
  std::uint64_t h = (id * 0x9E3779B97F4A7C15u) ^ static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(place));
  h *= 0xBF58476D1CE4E5B9u;
  return h ^ (h >> 31);
}

/// The sum makes it order-free.
std::uint64_t keyOf(const tricover::Polygon& a, const void* place_a, const tricover::Polygon& b, const void* place_b) {
  return (mix(a.id(), place_a) + mix(b.id(), place_b)) * 0x9E3779B97F4A7C15u;
}

}  // namespace

tricover::PairCache& pairCache(const tricover::Polygon& a, const void* place_a, const tricover::Polygon& b,
                               const void* place_b) {
  thread_local std::vector<Slot> slots(std::size_t{1} << kSlotBits);
  const auto slot = [](std::uint64_t key) -> Slot& { return slots[static_cast<std::size_t>(key >> (64 - kSlotBits))]; };
  const std::uint64_t key = keyOf(a, place_a, b, place_b);
  Slot& own = slot(key);
  if (own.places == key) return own.facts;
  own.places = key;
  return slot(keyOf(a, nullptr, b, nullptr)).facts;
}

}  // namespace tricover_fcl
