// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <typeinfo>

/// Whether the call throws that very exception, and none derived from it.
template <typename Exception, typename Call>
bool throwsExactly(const Call& call) {
  try {
    call();
  } catch (const Exception& error) {
    return typeid(error) == typeid(Exception);
  } catch (...) {
  }
  return false;
}

/// The call does what a \throws of the function's comment says.
#define THROWS(header, function, exception, ...) \
  EXPECT_TRUE(throwsExactly<exception>([&] { static_cast<void>(__VA_ARGS__); })) << #__VA_ARGS__
