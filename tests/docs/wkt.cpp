// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/wkt.h"

#include <gtest/gtest.h>

#include <string>

#include "tricover/polygon.h"

namespace {

TEST(Documentation, Wkt) {
  //! [wkt]
  const std::string text = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1))";
  const tricover::Polygon polygon = tricover::parseWkt(text).polygon;
  EXPECT_EQ(polygon.area(), 15);
  EXPECT_EQ(tricover::toWkt(polygon), text);
  //! [wkt]
}

}  // namespace
