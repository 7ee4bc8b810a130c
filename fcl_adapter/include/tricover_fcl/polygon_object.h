// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/collision_object.h>

#include <memory>

#include "tricover/export.h"
#include "tricover_fcl/polygon_shape.h"

namespace tricover_fcl {

/// An fcl::CollisionObject whose box is that of PolygonShape::boxAt(): tight however it is turned, where FCL's is a
/// cube around the shape's origin. A broadphase manager then shows its callback fewer pairs.
///
/// As with FCL's, call computeAABB() after the object was moved and before a manager is updated. FCL's is not virtual:
/// called through a pointer to fcl::CollisionObject it makes FCL's own box, which is wide, but as right. Nor is its
/// destructor: what owns a PolygonObject must know it by its own class (a std::shared_ptr does, if it was made by
/// std::make_shared<PolygonObject>).
///
/// \snippet fcl.cpp object
template <typename S>
class TRICOVER_EXPORT PolygonObject final : public fcl::CollisionObject<S> {
 public:
  /// Makes an object from a shape and its pose.
  /// \throws std::invalid_argument where there is no shape
  explicit PolygonObject(const std::shared_ptr<PolygonShape<S>>& shape,
                         const fcl::Transform3<S>& pose = fcl::Transform3<S>::Identity());

  const PolygonShape<S>& shape() const { return static_cast<const PolygonShape<S>&>(*this->cgeom); }  ///< As given.

  /// The box where the object is now.
  void computeAABB() { this->aabb = shape().boxAt(this->t); }
};

using PolygonObjectf = PolygonObject<float>;   ///< For FCL's float types.
using PolygonObjectd = PolygonObject<double>;  ///< For FCL's double types.

extern template class PolygonObject<float>;
extern template class PolygonObject<double>;

}  // namespace tricover_fcl
