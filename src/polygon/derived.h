// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

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

  /// What `build` returns, a unique pointer, unless another thread was first: that one is waited for.
  template <typename Build>
  const Thing* built(Build build) const {
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
  mutable bool is_building_ = false;
};

}  // namespace tricover::detail
