// SPDX-License-Identifier: BSD-3-Clause
#include "tricover_fcl/polygon_object.h"

#include "shape/errors.h"

namespace tricover_fcl {
namespace {

/// Before FCL's constructor looks into it.
template <typename Shape>
const Shape& required(const Shape& shape) {
  if (!shape) refuse("shape", "there is none");
  return shape;
}

}  // namespace

template <typename S>
PolygonObject<S>::PolygonObject(const std::shared_ptr<PolygonShape<S>>& shape, const fcl::Transform3<S>& pose)
    : fcl::CollisionObject<S>(required(shape), pose) {
  computeAABB();
}

template class PolygonObject<float>;
template class PolygonObject<double>;

}  // namespace tricover_fcl
