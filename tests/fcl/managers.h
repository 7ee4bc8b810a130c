// SPDX-License-Identifier: BSD-3-Clause
// Every broadphase manager, FCL's and ours.
#pragma once

#include <fcl/broadphase/broadphase_SSaP.h>
#include <fcl/broadphase/broadphase_SaP.h>
#include <fcl/broadphase/broadphase_bruteforce.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree_array.h>
#include <fcl/broadphase/broadphase_interval_tree.h>
#include <fcl/broadphase/broadphase_spatialhash.h>

#include <memory>
#include <vector>

#include "tricover_fcl/scene_manager.h"

namespace tricover_fcl::test {

struct Manager {
  const char* name;
  std::unique_ptr<fcl::BroadPhaseCollisionManagerd> manager;
};

inline std::vector<Manager> managersOfEveryKind() {
  std::vector<Manager> all;
  all.push_back({"DynamicAABBTree", std::make_unique<fcl::DynamicAABBTreeCollisionManagerd>()});
  all.push_back({"DynamicAABBTreeArray", std::make_unique<fcl::DynamicAABBTreeCollisionManager_Array<double>>()});
  all.push_back({"SaP", std::make_unique<fcl::SaPCollisionManagerd>()});
  all.push_back({"SSaP", std::make_unique<fcl::SSaPCollisionManagerd>()});
  all.push_back({"Naive", std::make_unique<fcl::NaiveCollisionManagerd>()});
  all.push_back({"IntervalTree", std::make_unique<fcl::IntervalTreeCollisionManagerd>()});
  // Its cells' bounds lie off the origin: an object that is one point for it, on such a bound, gets no cell.
  all.push_back({"SpatialHashing", std::make_unique<fcl::SpatialHashingCollisionManager<double>>(
                                       4, fcl::Vector3d(-41, -41, -5), fcl::Vector3d(41, 41, 5))});
  all.push_back({"Scene", std::make_unique<SceneManagerd>()});
  return all;
}

}  // namespace tricover_fcl::test
