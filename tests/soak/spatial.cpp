// SPDX-License-Identifier: BSD-3-Clause
#include "spatial.h"

namespace tricover::soak {

Pose planar(const fcl::Transform3<float>& transform) {
  Pose pose = Pose::Identity();
  pose.linear() = transform.matrix().topLeftCorner<2, 2>().cast<double>();
  pose.translation() = transform.translation().head<2>().cast<double>();
  return pose;
}

}  // namespace tricover::soak
