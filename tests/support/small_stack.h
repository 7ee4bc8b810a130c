// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pthread.h>

#include <cstddef>
#include <exception>
#include <functional>
#include <string>
#include <utility>

namespace tricover::support {

/// Calls `work` in a thread of such a stack. What went wrong; empty if nothing did.
inline std::string onStackOf(std::size_t bytes, std::function<void()> work) {
  struct Call {
    std::function<void()> work;
    std::string failure;
  } call{std::move(work), ""};
  const auto run = [](void* context) -> void* {
    Call& called = *static_cast<Call*>(context);
    try {
      called.work();
    } catch (const std::exception& error) {
      called.failure = error.what();
    }
    return nullptr;
  };
  pthread_attr_t attributes;
  pthread_t thread;
  if (pthread_attr_init(&attributes) != 0 || pthread_attr_setstacksize(&attributes, bytes) != 0 ||
      pthread_create(&thread, &attributes, run, &call) != 0)
    return "no thread";
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
  return call.failure;
}

}  // namespace tricover::support
