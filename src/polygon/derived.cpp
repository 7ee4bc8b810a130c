// SPDX-License-Identifier: BSD-3-Clause
#include "polygon/derived.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <vector>

namespace tricover::detail {
namespace {

/// Of all polygons, and held for moments only.
struct Turns {
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

/// Never destroyed: polygons may be asked while the program ends.
Turns& turns() {
  static Turns& all = *new Turns;
  return all;
}

}  // namespace

#ifdef TRICOVER_TEST_SWITCHES
std::atomic<Stages> used_stages{Stages::Paid};

void useStages(Stages stages) { used_stages.store(stages, std::memory_order_relaxed); }
#endif

/// Whether it is this thread's turn to build. Otherwise it has been built, by another one that may have been waited
/// for.
bool Derived::begin() const {
  Turns& all = turns();
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
  Turns& all = turns();
  const std::lock_guard<std::mutex> lock(all.mutex);
  all.building.erase(std::find(all.building.begin(), all.building.end(), this));
  ready_.store(thing, std::memory_order_release);
  if (all.waiting > 0) all.ended.notify_all();
}

}  // namespace tricover::detail
