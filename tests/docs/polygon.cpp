// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/polygon.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace {

TEST(Documentation, Polygon) {
  //! [polygon]
  // A square with a square hole. Rings run in either direction and aren't closed by a repeated vertex.
  const tricover::Polygon frame({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}});
  EXPECT_EQ(frame.vertexCount(), 8u);
  EXPECT_EQ(frame.edgeCount(), 8);                      // as signed as the edges' numbers are
  EXPECT_EQ(frame.edgeStart(5), tricover::Vec2(3, 1));  // edges are numbered through the rings
  EXPECT_EQ(frame.edgeEnd(5), tricover::Vec2(3, 3));

  const tricover::Polygon copy = frame;  // shares all data
  EXPECT_EQ(copy.id(), frame.id());

  EXPECT_THROW(tricover::Polygon({{{0, 0}, {1, 1}}}), std::invalid_argument);  // two vertices
  //! [polygon]
}

}  // namespace
