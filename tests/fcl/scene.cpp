// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"

namespace tricover_fcl::test {

template <typename S>
tricover::Pose flat(const fcl::Transform3<S>& transform) {
  tricover::Pose pose = tricover::Pose::Identity();
  pose.matrix().topLeftCorner<2, 2>() = transform.matrix().template topLeftCorner<2, 2>().template cast<double>();
  pose.translation() = transform.translation().template head<2>().template cast<double>();
  return pose;
}

template tricover::Pose flat(const fcl::Transform3<float>&);
template tricover::Pose flat(const fcl::Transform3<double>&);

}  // namespace tricover_fcl::test
