// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/common/types.h>

#include "tricover/pose.h"

namespace tricover::laws {

/// The planar pose in space, at z = 0. What mirrors the plane is turned over.
template <typename S>
fcl::Transform3<S> lifted(const Pose& pose) {
  fcl::Transform3<S> transform = fcl::Transform3<S>::Identity();
  transform.matrix().template topLeftCorner<2, 2>() = pose.linear().cast<S>();
  if (pose.linear().determinant() < 0) transform(2, 2) = -1;
  transform.translation() << static_cast<S>(pose.translation().x()), static_cast<S>(pose.translation().y()), S(0);
  return transform;
}

/// What a transform does in the plane. Not inline: where GCC 12 sees double turned into float and back, its vectoriser
/// leaves out the rounding.
Pose planar(const fcl::Transform3<float>& transform);
Pose planar(const fcl::Transform3<double>& transform);

}  // namespace tricover::laws
