// SPDX-License-Identifier: BSD-3-Clause
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "studies.h"
#include "tricover/segment.h"
#include "tricover_fcl/tricover_fcl.h"

namespace tricover::bench {
namespace {

using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;

/// 500 robots on circles whose orbits cross those of their neighbours, in an FCL manager.
constexpr std::size_t kRobots = 500, kFrames = 100;
constexpr double kRadius = 20, kSpacing = 60, kOrbit = 70;

fcl::Vector3d placeOf(std::size_t robot, std::size_t frame) {
  const auto spread = [&](double step) { return std::fmod(static_cast<double>(robot) * step, 1); };
  const double turn = 2 * static_cast<double>(EIGEN_PI);
  const double angle =
      turn * (spread(0.6180339887498949) + (0.5 + spread(0.7548776662466927)) * static_cast<double>(frame) / 200);
  const double row = static_cast<double>(robot / 25), column = static_cast<double>(robot % 25);
  return {kSpacing * column + kOrbit * std::cos(angle), kSpacing * row + kOrbit * std::sin(angle), 0};
}

class Fleet {
 public:
  explicit Fleet(const Geometry& geometry) {
    for (std::size_t i = 0; i < kRobots; ++i) {
      robots_.push_back(std::make_unique<fcl::CollisionObjectd>(geometry));
      // Its number in the fleet, as a pointer into the table of robots.
      robots_[i]->setUserData(&numbers_[i]);
      numbers_[i] = static_cast<std::uint32_t>(i);
    }
    place(0);
    for (const auto& robot : robots_) manager_.registerObject(robot.get());
    manager_.setup();
  }

  void walk(const Sampling& sampling, bool narrow, Hits& hits) {
    forEachSample(sampling, kFrames, [&](std::size_t frame) {
      place(frame);
      manager_.update();
      Frame asked{frame, narrow, {}, &hits};
      manager_.collide(&asked, meet);
    });
  }

 private:
  struct Frame {
    std::size_t frame;
    bool narrow;
    fcl::CollisionResultd result;
    Hits* hits;
  };

  void place(std::size_t frame) {
    for (std::size_t i = 0; i < kRobots; ++i) {
      robots_[i]->setTranslation(placeOf(i, frame));
      robots_[i]->computeAABB();
    }
  }

  static bool meet(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
    auto& asked = *static_cast<Frame*>(data);
    static const fcl::CollisionRequestd request;
    asked.result.clear();
    if (!asked.narrow || fcl::collide(a, b, request, asked.result) == 0) return false;
    std::size_t i = *static_cast<std::uint32_t*>(a->getUserData()), j = *static_cast<std::uint32_t*>(b->getUserData());
    if (i > j) std::swap(i, j);
    asked.hits->push_back(static_cast<std::uint32_t>((asked.frame * kRobots + i) * kRobots + j));
    return false;
  }

  std::vector<std::unique_ptr<fcl::CollisionObjectd>> robots_;
  std::vector<std::uint32_t> numbers_ = std::vector<std::uint32_t>(kRobots);
  fcl::DynamicAABBTreeCollisionManagerd manager_;
};

Contender fleetContender(const char* name, Role role, const Geometry& geometry) {
  return {name, role, true, [fleet = std::make_shared<Fleet>(geometry), role](const Sampling& sampling, Hits& hits) {
            fleet->walk(sampling, role != Role::Floor, hits);
          }};
}

}  // namespace

Result measureRoundFleet(const Settings& settings) {
  const Geometry discs = std::make_shared<tricover_fcl::PolygonShaped>(
      point({0, 0}), tricover_fcl::PolygonOptions{kRadius, -kRadius, kRadius});
  const Geometry spheres = std::make_shared<fcl::Sphered>(kRadius);
  const Workload workload{"round", "fleet of 500 discs", "crowd", 1, 1, kFrames, kRobots * kRobots};
  return measure(workload,
                 {fleetContender("via FCL", Role::Ours, discs), fleetContender("FCL Sphere", Role::Rival, spheres),
                  fleetContender("manager alone", Role::Floor, spheres)},
                 settings);
}

}  // namespace tricover::bench
