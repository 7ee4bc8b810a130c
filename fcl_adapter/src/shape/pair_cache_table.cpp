// SPDX-License-Identifier: BSD-3-Clause
#include "shape/pair_cache_table.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace tricover_fcl {
namespace {

/// A table begins with 2^6 slots, which take less than 64 KB, and doubles while more than an eighth of them are in use:
/// a thousand live pairs lose one in ten to a shared slot.
constexpr int kFirstBits = 6, kMostBits = 13;

struct alignas(64) Slot {
  std::uint64_t owner = 0;
  tricover::PairCache cache;
};
static_assert(((sizeof(Slot) + sizeof(std::uint64_t)) << kFirstBits) <= std::size_t{1} << 16);

/// Keys are apart from the caches: places that are new all the time then touch little memory.
struct Table {
  Table() { resize(kFirstBits); }

  std::size_t slotOf(std::uint64_t key) const { return static_cast<std::size_t>(key >> (64 - bits)); }

  /// The key that came to the slot last.
  std::uint64_t& lastAt(std::uint64_t key) { return keys[slotOf(key)]; }

  /// The cache of that pair. It begins empty where the slot was another pair's: that pair's may be in back-off.
  tricover::PairCache* cacheOf(std::uint64_t key) {
    Slot* slot = &slots[slotOf(key)];
    if (slot->owner != key) {
      if (slot->owner == 0 && ++used > slots.size() / 8 && bits < kMostBits) {
        resize(bits + 1);
        slot = &slots[slotOf(key)];
      }
      slot->owner = key;
      slot->cache = {};
    }
    return &slot->cache;
  }

  void resize(int more_bits) {
    const std::vector<Slot> old_slots = std::move(slots);
    const std::vector<std::uint64_t> old_keys = std::move(keys);
    bits = more_bits;
    slots = std::vector<Slot>(std::size_t{1} << bits);
    keys = std::vector<std::uint64_t>(slots.size());
    used = 1;
    for (const std::uint64_t key : old_keys) {
      if (key != 0) lastAt(key) = key;
    }
    for (const Slot& slot : old_slots) {
      if (slot.owner == 0) continue;
      slots[slotOf(slot.owner)] = slot;
      ++used;
    }
  }

  int bits = 0;
  std::size_t used = 0;             ///< slots that have an owner, or are about to
  std::vector<std::uint64_t> keys;  ///< of the pair, with its places or without, that came to a slot last
  std::vector<Slot> slots;
};

/// A plain pointer beside its owner, because a thread_local with a destructor is asked for its state at every use.
thread_local Table* table = nullptr;

/// Plain, too: both can still be read when the owner is gone.
thread_local bool ended = false;

struct TableOwner {
  std::unique_ptr<Table> all = std::make_unique<Table>();

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
  const std::uint64_t key = keyOf(a, place_a, b, place_b);
  Slot& slot = all->slots[all->slotOf(key)];
  if (slot.owner == key) return &slot.cache;
  std::uint64_t& last = all->lastAt(key);
  if (last == key) return all->cacheOf(key);
  last = key;
  const std::uint64_t key_of_ids = keyOf(a, nullptr, b, nullptr);
  std::uint64_t& last_of_ids = all->lastAt(key_of_ids);
  if (all->slots[all->slotOf(key_of_ids)].owner == key_of_ids || last_of_ids == key_of_ids)
    return all->cacheOf(key_of_ids);
  last_of_ids = key_of_ids;
  return nullptr;
}

std::size_t pairCacheBytes() {
  return table == nullptr ? 0 : table->slots.size() * (sizeof(Slot) + sizeof(std::uint64_t));
}

}  // namespace tricover_fcl
