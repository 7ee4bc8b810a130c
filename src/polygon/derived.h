// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace tricover::detail {

/// A place for what others derive from a polygon: built at the first call, by whichever thread comes first, and
/// immutable from then on. It is as small as it can be: polygons of few vertices are many.
class Derived {
 public:
  /// Only who puts it there knows its type.
  struct Thing {
    virtual ~Thing() = default;
  };

  Derived() = default;
  Derived(const Derived&) = delete;
  Derived& operator=(const Derived&) = delete;
  ~Derived() { delete ifBuilt(); }

  /// Null until it has been built.
  const Thing* ifBuilt() const { return ready_.load(std::memory_order_acquire); }

  /// What `build` returns, a unique pointer, unless another thread was first: that one is waited for. But brief is what
  /// is built in no more time than turns take: of threads that build it at once the first one's stays.
  template <typename Build>
  const Thing* built(Build build, bool is_brief = false) const {
    if (const Thing* ready = ifBuilt()) return ready;
    if (is_brief) {
      auto thing = build();
      const Thing* ready = nullptr;
      const bool is_first = ready_.compare_exchange_strong(ready, thing.get(), std::memory_order_acq_rel);
      return is_first ? thing.release() : ready;
    }
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

/// Up to which stage polygons' data is derived: by what has been paid, or, for tests, whatever has been.
enum class Stages { Paid, Edges, Hierarchy, All };
#ifdef TRICOVER_TEST_SWITCHES
/// Chooses for the whole process. What has been built stays.
void useStages(Stages stages);

extern std::atomic<Stages> used_stages;
inline Stages usedStages() { return used_stages.load(std::memory_order_relaxed); }
#else
constexpr Stages usedStages() { return Stages::Paid; }
#endif

/// What is still to be paid of the price of a stage.
inline std::size_t leftOf(Stages stage, std::size_t price, std::size_t paid) {
  constexpr std::size_t kNeverPaid = std::size_t{1} << 60;
  const Stages used = usedStages();
  if (used != Stages::Paid && stage != Stages::Paid) return used < stage ? kNeverPaid : 0;
  return paid < price ? price - paid : 0;
}

/// What queries have paid so far for doing without something that is derived. It is built when that adds up to what
/// building costs: so who asks once doesn't pay for it, and all queries together pay at most twice what the best of
/// both ways would have cost. In the cost of looking at an edge. Threads may lose each other's payments, which only
/// puts building off.
template <Stages kStage>
class Rent {
 public:
  /// What is still to be paid of a price.
  std::size_t left(std::size_t price) const { return leftOf(kStage, price, paid_.load(std::memory_order_relaxed)); }
  /// Whether what has this price is to be built now; otherwise pays what doing without it costs.
  bool isDue(std::size_t cost, std::size_t price) const {
    if (left(price) <= cost) return true;
    pay(cost);
    return false;
  }
  void pay(std::size_t cost) const {
    constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max();
    const std::size_t paid = paid_.load(std::memory_order_relaxed);
    paid_.store(static_cast<std::uint32_t>(std::min(paid + std::min(cost, kMost), kMost)), std::memory_order_relaxed);
  }

 private:
  mutable std::atomic<std::uint32_t> paid_{0};
};

}  // namespace tricover::detail
