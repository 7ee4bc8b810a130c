// SPDX-License-Identifier: BSD-3-Clause
#include "polygon/derived.h"

#include <condition_variable>
#include <mutex>

namespace tricover::detail {
namespace {

/// Of all polygons, and held for moments only.
struct Turns {
  std::mutex mutex;
  std::condition_variable ended;
};

/// Never destroyed: polygons may be asked while the program ends.
Turns& turns() {
  static Turns& all = *new Turns;
  return all;
}

}  // namespace

/// Whether it is this thread's turn to build. Otherwise it has been built, by another one that may have been waited
/// for.
bool Derived::begin() const {
  std::unique_lock<std::mutex> lock(turns().mutex);
  turns().ended.wait(lock, [&] { return !is_building_; });
  is_building_ = ifBuilt() == nullptr;
  return is_building_;
}

void Derived::end(const Thing* thing) const {
  {
    const std::lock_guard<std::mutex> lock(turns().mutex);
    is_building_ = false;
    ready_.store(thing, std::memory_order_release);
  }
  turns().ended.notify_all();
}

}  // namespace tricover::detail
