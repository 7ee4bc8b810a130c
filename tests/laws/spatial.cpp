// SPDX-License-Identifier: BSD-3-Clause
#include "spatial.h"

namespace tricover::laws {
namespace {

template <typename S>
Pose planarOf(const fcl::Transform3<S>& transform) {
  Pose pose = Pose::Identity();
  pose.linear() = transform.matrix().template topLeftCorner<2, 2>().template cast<double>();
  pose.translation() = transform.translation().template head<2>().template cast<double>();
  return pose;
}

}  // namespace

Pose planar(const fcl::Transform3<float>& transform) { return planarOf(transform); }
Pose planar(const fcl::Transform3<double>& transform) { return planarOf(transform); }

}  // namespace tricover::laws
