// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "hierarchy/simd.h"

namespace {

struct OnPortableLanes : testing::Environment {
  void SetUp() override { tricover::detail::usePortableLanes(true); }
};

[[maybe_unused]] testing::Environment* const registered = testing::AddGlobalTestEnvironment(new OnPortableLanes);

}  // namespace
