// SPDX-License-Identifier: BSD-3-Clause
#include "polygon/derived.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <vector>

namespace tricover::detail {
namespace {

/// Which data of all polygons is being built. The mutex is held for moments only.
struct Builds {
  std::mutex mutex;
  std::condition_variable ended;
  std::vector<const Derived*> building;
  int waiting = 0;

  bool areBuilding(const Derived* what) const {
    for (const Derived* one : building)
      if (one == what) return true;
    return false;
  }
};

/// Never destroyed: queries may run while the program ends.
Builds& builds() {
  static Builds& all = *new Builds;
  return all;
}

}  // namespace

#ifdef TRICOVER_TEST_SWITCHES
std::atomic<Stages> used_stages{Stages::Paid};

void useStages(Stages stages) { used_stages.store(stages, std::memory_order_relaxed); }
#endif

/// Returns whether this thread is to build. Otherwise another thread, which this one may have waited for, has built it.
bool Derived::begin() const {
  Builds& all = builds();
  std::unique_lock<std::mutex> lock(all.mutex);
  while (all.areBuilding(this)) {
    ++all.waiting;
    all.ended.wait(lock);
    --all.waiting;
  }
  if (ifBuilt() != nullptr) return false;
  all.building.push_back(this);
  return true;
}

void Derived::end(const Thing* thing) const {
  Builds& all = builds();
  const std::lock_guard<std::mutex> lock(all.mutex);
  all.building.erase(std::find(all.building.begin(), all.building.end(), this));
  ready_.store(thing, std::memory_order_release);
  if (all.waiting > 0) all.ended.notify_all();
}

}  // namespace tricover::detail
