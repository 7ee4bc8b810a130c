// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/polygon.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tricover/collide.h"
#include "tricover/distance.h"
#include "tricover/locate.h"

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

TEST(Documentation, PolygonOfRawVertices) {
  //! [raw]
  // One ring, wherever its vertices are.
  const tricover::Vec2 corners[] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const tricover::Polygon square(corners, 4);
  EXPECT_EQ(square.area(), 16);
  //! [raw]
}

TEST(Documentation, PolygonMeasures) {
  //! [measures]
  const tricover::Polygon frame({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}});
  EXPECT_EQ(frame.area(), 12);  // the hole isn't of the region, whichever way its ring runs
  EXPECT_EQ(frame.centroid(), tricover::Vec2(2, 2));
  EXPECT_EQ(frame.bounds().max(), tricover::Vec2(4, 4));
  EXPECT_FALSE(frame.isConvex());
  EXPECT_EQ(frame.translated({1, 0}).scaled(0.5).bounds().min(), tricover::Vec2(0.5, 0));
  EXPECT_EQ(frame.transformed(tricover::poseAt(5, 0)).bounds().max(), tricover::Vec2(9, 4));
  const Eigen::AlignedBox2d around = frame.bounds(tricover::poseAt(5, 0));  // but for rounding, outwards
  EXPECT_TRUE(around.contains(tricover::Vec2(9, 4)));
  EXPECT_NEAR(around.max().x(), 9, 1e-14);
  //! [measures]
}

TEST(Documentation, PolygonComplement) {
  //! [complement]
  const tricover::Polygon lane({{{0, 0}, {20, 0}, {20, 4}, {0, 4}}}), car = tricover::Polygon::box(4, 2);
  const tricover::Polygon outside = lane.complement();  // all of the plane but the lane's inside
  EXPECT_FALSE(tricover::collide(outside, tricover::poseAt(0, 0), car, tricover::poseAt(10, 2)));
  EXPECT_TRUE(tricover::collide(outside, tricover::poseAt(0, 0), car, tricover::poseAt(10, 3.5)));
  EXPECT_EQ(tricover::distance(outside, tricover::poseAt(0, 0), car, tricover::poseAt(10, 2)).distance, 1);
  EXPECT_EQ(tricover::locate(outside, {1e9, 0}), tricover::Location::Inside);
  //! [complement]
}

TEST(Documentation, PolygonSimplified) {
  //! [simplified]
  const tricover::Polygon rough({{{0, 0}, {1, 0.01}, {2, 0}, {2, 1}, {1, 0.99}, {0, 1}}});
  EXPECT_EQ(rough.simplified(0.02).vertexCount(), 4u);
  EXPECT_EQ(rough.simplified(0.005).vertexCount(), 6u);
  const tricover::Polygon cover =
      rough.simplified(0.02, tricover::Simplify::Outwards);  // of four vertices, too, and all of `rough` is in it
  EXPECT_EQ(cover.vertexCount(), 4u);
  EXPECT_NE(tricover::locate(cover, {1, 0}), tricover::Location::Outside);
  EXPECT_NE(tricover::locate(cover, {1, 1}), tricover::Location::Outside);
  //! [simplified]
}

}  // namespace
