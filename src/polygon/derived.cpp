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

std::atomic<Stages> used_stages{Stages::Paid};

/// Never destroyed: polygons may be asked while the program ends.
Turns& turns() {
  static Turns& all = *new Turns;
  return all;
}

}  // namespace

void useStages(Stages stages) { used_stages.store(stages, std::memory_order_relaxed); }

std::size_t Rent::left(std::size_t price) const {
  constexpr std::size_t kNeverPaid = std::size_t{1} << 60;
  const Stages used = used_stages.load(std::memory_order_relaxed);
  if (used != Stages::Paid && stage_ != Stages::Paid) return used < stage_ ? kNeverPaid : 0;
  const std::size_t paid = paid_.load(std::memory_order_relaxed);
  return paid < price ? price - paid : 0;
}

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
