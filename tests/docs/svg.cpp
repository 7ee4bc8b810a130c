// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/svg.h"

#include <gtest/gtest.h>

#include <string>

#include "own_folder.h"
#include "tricover/contacts.h"
#include "tricover/polygon.h"

namespace {

TEST(Documentation, SvgDrawing) {
  const tricover::support::OwnFolder own;
  const std::string folder = own.path();
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
  drawing.save(folder + "squares.svg");
  const std::string document = drawing.str();  // what the file holds
  EXPECT_EQ(document.rfind("<svg ", 0), 0u);
  //! [svg]
}

TEST(Documentation, SvgOfAScene) {
  //! [svg scene]
  tricover::Scene scene;
  tricover::BodyOptions round;
  round.margin = 0.5;
  scene.add(tricover::Polygon({{{0, 0}, {4, 0}, {4, 1}, {0, 1}}}), tricover::Pose::Identity());
  scene.add(tricover::Polygon::point({0, 0}), tricover::Pose(Eigen::Translation2d(2, 3)), round);  // a disc
  const auto robot = tricover::Polygon::point({0, 0});
  const auto drive = tricover::Motion::translation(tricover::Pose(Eigen::Translation2d(8, 0)), {-8, 0});
  tricover::SvgDrawing drawing;
  drawing.scene(scene);
  if (const auto first = scene.firstImpact(robot, drive, {0.25})) {
    drawing.polygon(robot, drive.at(first->impact.time), "#16a34a", "#333", 0.25);
    drawing.impact(first->impact);
  }
  const std::string document = drawing.str();
  EXPECT_NE(document.find("stroke-width=\"0.5\""), std::string::npos);
  //! [svg scene]
}

}  // namespace
