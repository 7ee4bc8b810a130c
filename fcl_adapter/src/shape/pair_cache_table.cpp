// SPDX-License-Identifier: BSD-3-Clause
#include "shape/pair_cache_table.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace tricover_fcl {
namespace {

/// A table begins with 2^6 slots, which take less than 64 KB. It doubles while more than an eighth of them are in use,
/// or pairs take turns in one: a thousand live pairs lose one in ten to a shared slot of the largest.
constexpr int kFirstBits = 6, kMostBits = 13;

struct alignas(64) Slot {
  std::uint64_t owner = 0;
  tricover::PairCache cache;
};
static_assert(((sizeof(Slot) + 2 * sizeof(std::uint64_t)) << kFirstBits) <= std::size_t{1} << 16);

/// The keys that came last, each in a cell of its own or shared. Apart from the caches: places that are new all the
/// time then touch little memory.
struct Seen {
  std::uint64_t& cellOf(std::uint64_t key) { return cells[static_cast<std::size_t>(key >> (64 - bits))]; }

  /// Whether the key came before, as far as the cells remember. Keys that take turns in a cell never find themselves
  /// there, so the cells double when as many of them were taken from other keys.
  bool test(std::uint64_t key) {
    if (cellOf(key) == key) return true;
    if (cellOf(key) != 0 && ++taken > cells.size() && bits < kMostBits) {
      const std::vector<std::uint64_t> old = std::exchange(cells, std::vector<std::uint64_t>(cells.size() * 2));
      ++bits;
      taken = 0;
      for (const std::uint64_t known : old)
        if (known != 0) cellOf(known) = known;
    }
    cellOf(key) = key;
    return false;
  }

  int bits = kFirstBits;
  std::size_t taken = 0;
  std::vector<std::uint64_t> cells = std::vector<std::uint64_t>(std::size_t{1} << kFirstBits);
};

struct Table {
  Table() { resize(kFirstBits); }

  Slot& slotAt(std::uint64_t key) { return slots[static_cast<std::size_t>(key >> (64 - bits))]; }

  /// The cache of that pair. It begins empty where the slot was another pair's: that pair's may be in back-off.
  tricover::PairCache* cacheOf(std::uint64_t key) {
    Slot* slot = &slotAt(key);
    if (slot->owner != key) {
      ++(slot->owner == 0 ? used : taken);
      if ((used > slots.size() / 8 || taken > slots.size()) && bits < kMostBits) {
        resize(bits + 1);
        slot = &slotAt(key);
      }
      slot->owner = key;
      slot->cache = {};
    }
    return &slot->cache;
  }

  void resize(int more_bits) {
    const std::vector<Slot> old_slots = std::move(slots);
    bits = more_bits;
    slots = std::vector<Slot>(std::size_t{1} << bits);
    used = 1, taken = 0;
    for (const Slot& slot : old_slots) {
      if (slot.owner == 0) continue;
      slotAt(slot.owner) = slot;
      ++used;
    }
  }

  int bits = 0;
  std::size_t used = 0;   ///< slots that have an owner, or are about to
  std::size_t taken = 0;  ///< how often a slot of this table was another pair's
  std::vector<Slot> slots;
  Seen pairs, ids;  ///< keys of pairs with their places, and without: neither takes the other's cells
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
std::uint64_t keyOf(std::uint64_t id_a, const void* place_a, std::uint64_t id_b, const void* place_b) {
  const std::uint64_t sum = mix(id_a * 0xBF58476D1CE4E5B9u, place_a) + mix(id_b * 0xBF58476D1CE4E5B9u, place_b);
  return (sum ^ (sum >> 32)) * 0x9E3779B97F4A7C15u;
}

}  // namespace

tricover::PairCache* pairCache(std::uint64_t id_a, const void* place_a, std::uint64_t id_b, const void* place_b) {
  Table* const all = table != nullptr ? table : makeTable();
  if (all == nullptr) return nullptr;
  const std::uint64_t key = keyOf(id_a, place_a, id_b, place_b);
  Slot& slot = all->slotAt(key);
  if (slot.owner == key) return &slot.cache;
  if (all->pairs.test(key)) return all->cacheOf(key);
  const std::uint64_t of_ids = keyOf(id_a, nullptr, id_b, nullptr);
  return all->slotAt(of_ids).owner == of_ids || all->ids.test(of_ids) ? all->cacheOf(of_ids) : nullptr;
}

std::size_t pairCacheBytes() {
  if (table == nullptr) return 0;
  return table->slots.size() * sizeof(Slot) +
         (table->pairs.cells.size() + table->ids.cells.size()) * sizeof(std::uint64_t);
}

}  // namespace tricover_fcl
