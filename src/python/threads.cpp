// SPDX-License-Identifier: BSD-3-Clause
#include "python/threads.h"

#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace tricover_python {

void inParallel(std::size_t threads, std::size_t count, const std::function<void(std::size_t)>& task) {
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  threads = std::min(threads, count);
  std::vector<std::exception_ptr> errors(count);
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        task(i);
      } catch (...) {
        errors[i] = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < threads; ++i) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
}

std::function<void(std::size_t, const std::function<void(std::size_t)>&)> parallelOn(std::size_t threads) {
  return
      [threads](std::size_t count, const std::function<void(std::size_t)>& task) { inParallel(threads, count, task); };
}

}  // namespace tricover_python
