// SPDX-License-Identifier: BSD-3-Clause
#include "shape/pair_cache_table.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace tricover_fcl {
namespace {

constexpr int kSlotBits = 13;  // a thousand live pairs lose one in ten to a shared slot

struct alignas(64) Slot {
  /// They begin empty where the slot was another pair's, whose facts may have been of no use to that one and rest.
  tricover::PairCache* of(std::uint64_t key) {
    if (owner != key) {
      owner = key;
      facts = {};
    }
    return &facts;
  }

  std::uint64_t owner = 0;
  tricover::PairCache facts;
};
static_assert(sizeof(Slot) == 576);  // so 4.5 MiB a thread

/// Keys are apart from the facts: places that are new all the time then touch little memory.
struct Table {
  static constexpr std::size_t kSlots = std::size_t{1} << kSlotBits;

  std::array<std::uint64_t, kSlots> keys{};  ///< of the pair, with its places or without, that came here last
  std::array<Slot, kSlots> slots;
};

/// A plain pointer beside its owner, because a thread_local with a destructor is asked for its state at every use.
thread_local Table* table = nullptr;

/// Plain, too: both can still be read when the owner is gone.
thread_local bool ended = false;

struct TableOwner {
  std::unique_ptr<Table> all{new Table};  // whose slots needn't be zeroed first

  TableOwner() { table = all.get(); }
  ~TableOwner() {
    table = nullptr;
    ended = true;
  }
};

Table* makeTable() {
  if (ended) return nullptr;
  thread_local const TableOwner owner;
  return table;
}

std::uint64_t mix(std::uint64_t id, const void* place) {
  const std::uint64_t h = (id + reinterpret_cast<std::uintptr_t>(place)) * 0x9E3779B97F4A7C15u;
  return h ^ (h >> 29);
}

/// The sum makes it order-free; mixed once more, so that of two places that are alike not all pairs are.
std::uint64_t keyOf(const tricover::Polygon& a, const void* place_a, const tricover::Polygon& b, const void* place_b) {
  const std::uint64_t sum = mix(a.id() * 0xBF58476D1CE4E5B9u, place_a) + mix(b.id() * 0xBF58476D1CE4E5B9u, place_b);
  return (sum ^ (sum >> 32)) * 0x9E3779B97F4A7C15u;
}

}  // namespace

tricover::PairCache* pairCache(const tricover::Polygon& a, const void* place_a, const tricover::Polygon& b,
                               const void* place_b) {
  Table* const all = table != nullptr ? table : makeTable();
  if (all == nullptr) return nullptr;
  const auto slotOf = [](std::uint64_t key) { return static_cast<std::size_t>(key >> (64 - kSlotBits)); };
  const std::uint64_t key = keyOf(a, place_a, b, place_b);
  const std::size_t own = slotOf(key);
  if (all->keys[own] == key) return all->slots[own].of(key);
  all->keys[own] = key;
  const std::uint64_t key_of_ids = keyOf(a, nullptr, b, nullptr);
  Slot& of_ids = all->slots[slotOf(key_of_ids)];
  std::uint64_t& last = all->keys[slotOf(key_of_ids)];
  if (of_ids.owner == key_of_ids || last == key_of_ids) return of_ids.of(key_of_ids);
  last = key_of_ids;
  return nullptr;
}

}  // namespace tricover_fcl
