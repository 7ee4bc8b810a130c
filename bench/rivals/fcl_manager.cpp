// SPDX-License-Identifier: BSD-3-Clause
#include "fcl_manager.h"

#include <fcl/broadphase/broadphase_SSaP.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree_array.h>
#include <fcl/broadphase/broadphase_interval_tree.h>
#include <fcl/broadphase/broadphase_spatialhash.h>

#include <stdexcept>

namespace tricover::bench {

FclManager makeFclManager(const std::string& name, const fcl::Vector3d& low, const fcl::Vector3d& high, double cell) {
  if (name == "tree") return std::make_unique<fcl::DynamicAABBTreeCollisionManagerd>();
  if (name == "array tree") return std::make_unique<fcl::DynamicAABBTreeCollisionManager_Arrayd>();
  if (name == "SSaP") return std::make_unique<fcl::SSaPCollisionManagerd>();
  if (name == "interval tree") return std::make_unique<fcl::IntervalTreeCollisionManagerd>();
  if (name == "hash") return std::make_unique<fcl::SpatialHashingCollisionManagerd<>>(cell, low, high);
  throw std::invalid_argument("manager: no '" + name + "'");
}

const std::vector<std::string>& fclManagers() {
  static const std::vector<std::string> names = {"tree", "array tree", "SSaP", "interval tree", "hash"};
  return names;
}

}  // namespace tricover::bench
