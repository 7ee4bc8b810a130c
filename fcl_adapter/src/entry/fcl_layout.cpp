// SPDX-License-Identifier: BSD-3-Clause
#include "tricover_fcl/fcl_layout.h"

#include <string>

#include "shape/errors.h"

namespace tricover_fcl {
namespace {

struct Measure {
  const char* what;
  std::size_t FclLayout::*value;
};

constexpr Measure kMeasures[] = {
    {"FCL's version (7: 0.7)", &FclLayout::version},
    {"the alignment of Eigen's matrices", &FclLayout::alignment},
    {"sizeof(fcl::Sphere<double>)", &FclLayout::sphere},
    {"sizeof(fcl::CollisionObject<double>)", &FclLayout::object},
    {"sizeof(fcl::CollisionRequest<double>)", &FclLayout::collision_request},
    {"sizeof(fcl::CollisionResult<double>)", &FclLayout::collision_result},
    {"sizeof(fcl::DistanceRequest<double>)", &FclLayout::distance_request},
    {"sizeof(fcl::DistanceResult<double>)", &FclLayout::distance_result},
    {"sizeof(fcl::ContinuousCollisionRequest<double>)", &FclLayout::continuous_request},
    {"sizeof(fcl::ContinuousCollisionResult<double>)", &FclLayout::continuous_result},
};

}  // namespace

void checkFclLayout(const FclLayout& seen) {
  const FclLayout built{};
  for (const Measure& measure : kMeasures) {
    if (seen.*measure.value == built.*measure.value) continue;
    refuseQuestion(measure.what,
                   "it is " + std::to_string(seen.*measure.value) + " for this program and was " +
                       std::to_string(built.*measure.value) + " when tricover was built",
                   "build both with the same FCL, and without -march=native or -mavx");
  }
}

}  // namespace tricover_fcl
