// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/version.h"

#include <gtest/gtest.h>

#include <string>

namespace {

TEST(Documentation, Version) {
  //! [version]
  const std::string headers = std::to_string(TRICOVER_VERSION_MAJOR) + "." + std::to_string(TRICOVER_VERSION_MINOR) +
                              "." + std::to_string(TRICOVER_VERSION_PATCH);
  EXPECT_EQ(tricover::version(), headers);  // the library is that of the headers
  //! [version]
}

}  // namespace
