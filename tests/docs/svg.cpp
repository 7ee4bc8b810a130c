// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/svg.h"

#include <gtest/gtest.h>

#include <string>

#include "tricover/contacts.h"

namespace {

TEST(Documentation, SvgDrawing) {
  //! [svg]
  const tricover::Polygon square({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  const tricover::Pose still = tricover::Pose::Identity();
  tricover::Pose pose = still;
  pose.translation() << 3, 1;
  tricover::SvgDrawing drawing;
  drawing.polygon(square, still, "#e7e5e4");
  drawing.polygon(square, pose, "#a8a29e");
  drawing.boxes(square, pose, 0);
  drawing.hits(square, still, square, pose);
  drawing.contacts(tricover::contacts(square, still, square, pose));
  const std::string document = drawing.str();  // to be written to a file
  EXPECT_EQ(document.rfind("<svg ", 0), 0u);
  //! [svg]
}

}  // namespace
