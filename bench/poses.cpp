// SPDX-License-Identifier: BSD-3-Clause
#include "poses.h"

#include <cstdint>
#include <stdexcept>

#include "random.h"
#include "workloads.h"

namespace tricover::bench {

std::vector<Pose> posesOf(const std::string& workload, const Polygon& fixed, const Polygon& moving) {
  constexpr std::uint64_t kSeed = 3;
  if (workload == "circular") return workloads::circularTrajectory(fixed, moving);
  if (workload == "linear") return workloads::linearTrajectory(fixed, moving);
  if (workload == "gap 0.1") return workloads::circularTrajectory(fixed, moving, 0.1);
  if (workload == "gap 0.01") return workloads::circularTrajectory(fixed, moving, 0.01);
  if (workload == "contact") return workloads::contactPoses(fixed, moving, kSeed);
  if (workload == "near") return workloads::nearPoses(fixed, moving, kSeed);
  if (workload == "overlap") return workloads::overlapPoses(fixed, moving, kSeed);
  throw std::invalid_argument("workload: no '" + workload + "'");
}

std::vector<Pose> separatedPoses(const Polygon& fixed, const Polygon& moving, double low, double high) {
  std::vector<Pose> poses = posesOf("contact", fixed, moving);
  support::Random random(5);
  for (Pose& pose : poses) {
    pose.translation() += (random.real(low, high) - 1) * (pose * moving.origin() - fixed.origin());
  }
  return poses;
}

}  // namespace tricover::bench
