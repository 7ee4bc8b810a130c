// SPDX-License-Identifier: BSD-3-Clause
// A ship that isn't convex sails a route on a map with holes; FCL's broadphase says where it runs aground and where it
// rams a ship at anchor. `robot_in_map [picture.svg]`
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <tricover/svg.h>
#include <tricover_fcl/tricover_fcl.h>

#include <cmath>
#include <exception>
#include <iostream>
#include <memory>
#include <vector>

#include "baltic.h"
#include "picture.h"

namespace {

tricover::Pose planarPose(double x, double y, double angle) {
  tricover::Pose pose = tricover::Pose::Identity();
  pose.linear() = Eigen::Rotation2Dd(angle).toRotationMatrix();
  pose.translation() = tricover::Vec2(x, y);
  return pose;
}

void place(fcl::CollisionObjectd& object, double x, double y, double angle) {
  object.setRotation(Eigen::AngleAxisd(angle, fcl::Vector3d::UnitZ()).toRotationMatrix());
  object.setTranslation(fcl::Vector3d(x, y, 0));
  object.computeAABB();
}

int sail(const char* picture) {
  tricover_fcl::registerNarrowphase();

  // What is derived from a polygon is shared by all objects that use its shape.
  const auto hull = std::make_shared<tricover_fcl::PolygonShaped>(baltic::ship());
  fcl::CollisionObjectd coast(std::make_shared<tricover_fcl::PolygonShaped>(baltic::land()));
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> anchored;
  fcl::DynamicAABBTreeCollisionManagerd manager;
  manager.registerObject(&coast);
  tricover::SvgDrawing drawing;
  drawing.polygon(baltic::land(), tricover::Pose::Identity(), "#e7e5e4");
  for (const baltic::Berth& berth : baltic::anchored()) {
    anchored.push_back(std::make_unique<fcl::CollisionObjectd>(hull));
    place(*anchored.back(), berth.x, berth.y, berth.angle);
    manager.registerObject(anchored.back().get());
    drawing.polygon(baltic::ship(), planarPose(berth.x, berth.y, berth.angle), "#a8a29e");
  }
  manager.setup();

  const std::vector<tricover::Vec2> route = {{330, 660},   {40, 300},    {140, 60},   {-10, -300},
                                             {-270, -520}, {-300, -400}, {-430, -120}};
  fcl::CollisionObjectd ship(hull);
  int positions = 0, aground = 0, rammed = 0;
  for (std::size_t leg = 0; leg + 1 < route.size(); ++leg) {
    const tricover::Vec2 way = route[leg + 1] - route[leg];
    const double angle = std::atan2(way.y(), way.x());
    const int steps = static_cast<int>(way.norm() / 10);
    for (int step = 0; step < steps; ++step) {
      const tricover::Vec2 at = route[leg] + way * step / steps;
      place(ship, at.x(), at.y(), angle);
      fcl::DefaultCollisionData<double> data;
      data.request.num_max_contacts = 1 + anchored.size();
      data.request.enable_contact = true;
      manager.collide(&ship, &data, fcl::DefaultCollisionFunction);
      bool on_coast = false;
      for (std::size_t i = 0; i < data.result.numContacts(); ++i) {
        const fcl::Contactd& contact = data.result.getContact(i);
        if (contact.o1 == coast.collisionGeometry().get() || contact.o2 == coast.collisionGeometry().get())
          on_coast = true;
      }
      const bool hit = data.result.isCollision();
      positions += 1;
      aground += on_coast;
      rammed += hit && !on_coast;
      drawing.polygon(baltic::ship(), planarPose(at.x(), at.y(), angle), hit ? "#dc2626" : "#16a34a");
    }
  }
  std::cout << positions << " positions: " << aground << " aground, " << rammed << " in another ship\n";
  savePicture(drawing, picture);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return sail(argc > 1 ? argv[1] : "robot_in_map.svg");
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << "\n";
    return 1;
  }
}
