// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/config.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision_object.h>
#include <fcl/narrowphase/collision_request.h>
#include <fcl/narrowphase/collision_result.h>
#include <fcl/narrowphase/continuous_collision_request.h>
#include <fcl/narrowphase/continuous_collision_result.h>
#include <fcl/narrowphase/distance_request.h>
#include <fcl/narrowphase/distance_result.h>

#include <cstddef>

#include "tricover/export.h"

namespace tricover_fcl {

/// FCL as the code that includes this sees it. tricover must have been built with the same: another version, a patched
/// copy, or compiler flags that align Eigen's matrices otherwise (-march=native, -mavx) make types of the same names
/// that can't be exchanged. An aggregate whose defaults are what is seen here.
struct FclLayout {
  std::size_t version = FCL_MAJOR_VERSION * 100 + FCL_MINOR_VERSION;                 ///< 7 is 0.7
  std::size_t alignment = EIGEN_MAX_ALIGN_BYTES;                                     ///< of Eigen's matrices, in bytes
  std::size_t sphere = sizeof(fcl::Sphere<double>);                                  ///< in bytes
  std::size_t object = sizeof(fcl::CollisionObject<double>);                         ///< see sphere
  std::size_t collision_request = sizeof(fcl::CollisionRequest<double>);             ///< see sphere
  std::size_t collision_result = sizeof(fcl::CollisionResult<double>);               ///< see sphere
  std::size_t distance_request = sizeof(fcl::DistanceRequest<double>);               ///< see sphere
  std::size_t distance_result = sizeof(fcl::DistanceResult<double>);                 ///< see sphere
  std::size_t continuous_request = sizeof(fcl::ContinuousCollisionRequest<double>);  ///< see sphere
  std::size_t continuous_result = sizeof(fcl::ContinuousCollisionResult<double>);    ///< see sphere
};

/// Compares how the caller and tricover see FCL.
///
/// \throws std::logic_error unless the caller sees it as tricover did when it was built. The text has what differs.
///
/// \snippet fcl.cpp layout
TRICOVER_EXPORT void checkFclLayout(const FclLayout& seen = FclLayout{});

}  // namespace tricover_fcl
