// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>

namespace tricover::detail {

/// A place for what others derive from a polygon: built at the first call, by whichever thread comes first, and
/// immutable from then on. It is as small as it can be: polygons of few vertices are many.
class Derived {
 public:
  /// Only the code that builds a thing knows its type.
  struct Thing {
    virtual ~Thing() = default;
  };

  Derived() = default;
  Derived(const Derived&) = delete;
  Derived& operator=(const Derived&) = delete;
  ~Derived() { delete ifBuilt(); }

  /// Null until it has been built.
  const Thing* ifBuilt() const { return ready_.load(std::memory_order_acquire); }

  /// Returns the T that is made of these, as built().
  template <typename T, typename... From>
  const T& made(const From&... from) const {
    return *static_cast<const T*>(built([&] { return std::make_unique<const T>(from...); }));
  }
  /// Returns what `build` returns, a unique pointer. If another thread builds it, waits for that thread.
  template <typename Build>
  const Thing* built(Build build) const {
    if (const Thing* ready = ifBuilt()) return ready;
    if (!begin()) return ifBuilt();
    try {
      end(build().release());
    } catch (...) {
      end(nullptr);
      throw;
    }
    return ifBuilt();
  }

 private:
  bool begin() const;
  void end(const Thing* thing) const;

  mutable std::atomic<const Thing*> ready_{nullptr};
};

/// Up to which stage data is derived from polygons: by what queries have cost so far (Paid) or, for tests, in any case.
enum class Stages { Paid, Edges, Hierarchy, All };
#ifdef TRICOVER_TEST_SWITCHES
/// Chooses for the whole process. What has been built stays.
void useStages(Stages stages);

extern std::atomic<Stages> used_stages;
inline Stages usedStages() { return used_stages.load(std::memory_order_relaxed); }
#else
constexpr Stages usedStages() { return Stages::Paid; }
#endif

/// Ski-rental: what queries have cost so far without something that is derived, in the cost of looking at an edge. Once
/// that adds up to the price of building it, it is built. All queries together cost at most twice what the better
/// choice would have cost. Threads may lose each other's costs, which only puts building off.
template <Stages kStage>
class SkiRental {
 public:
  /// What queries must still cost until something of this price is built.
  std::size_t left(std::size_t price) const {
    constexpr std::size_t kNever = std::size_t{1} << 60;
    const Stages used = usedStages();
    if (used != Stages::Paid && kStage != Stages::Paid) return used < kStage ? kNever : 0;
    const std::size_t so_far = cost_so_far_.load(std::memory_order_relaxed);
    return so_far < price ? price - so_far : 0;
  }
  /// Whether to build now what has this price. Otherwise adds the cost of a query without it.
  bool isDue(std::size_t cost, std::size_t price) const {
    if (left(price) <= cost) return true;
    add(cost);
    return false;
  }
  void add(std::size_t cost) const {
    constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max();
    const std::size_t so_far = cost_so_far_.load(std::memory_order_relaxed);
    cost_so_far_.store(static_cast<std::uint32_t>(std::min(so_far + std::min(cost, kMost), kMost)),
                       std::memory_order_relaxed);
  }

 private:
  mutable std::atomic<std::uint32_t> cost_so_far_{0};
};

}  // namespace tricover::detail
