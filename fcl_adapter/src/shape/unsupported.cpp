// SPDX-License-Identifier: BSD-3-Clause
#include "shape/unsupported.h"

#include <typeinfo>

#include "tricover_fcl/polygon_shape.h"

namespace tricover_fcl {

template <typename S>
std::string typeName(const fcl::CollisionGeometry<S>& geometry) {
  if (typeid(geometry) == typeid(PolygonShape<S>)) return "tricover_fcl::PolygonShape";
  static const char* const names[fcl::NODE_COUNT] = {
      "BV_UNKNOWN",    "BV_AABB",     "BV_OBB",     "BV_RSS",         "BV_kIOS",        "BV_OBBRSS",    "BV_KDOP16",
      "BV_KDOP18",     "BV_KDOP24",   "GEOM_BOX",   "GEOM_SPHERE",    "GEOM_ELLIPSOID", "GEOM_CAPSULE", "GEOM_CONE",
      "GEOM_CYLINDER", "GEOM_CONVEX", "GEOM_PLANE", "GEOM_HALFSPACE", "GEOM_TRIANGLE",  "GEOM_OCTREE"};
  return std::string("fcl::") + names[geometry.getNodeType()];
}

template std::string typeName(const fcl::CollisionGeometry<float>&);
template std::string typeName(const fcl::CollisionGeometry<double>&);

}  // namespace tricover_fcl
