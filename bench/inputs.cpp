// SPDX-License-Identifier: BSD-3-Clause
#include "inputs.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "random.h"

namespace tricover::bench {

const std::vector<std::string>& workloadNames() {
  static const std::vector<std::string> names = {"circular", "linear", "gap 0.1", "gap 0.01",
                                                 "contact",  "near",   "overlap"};
  return names;
}

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
    pose.translation() += (random.real(low, high) - 1) * (pose * moving.coveringOrigin() - fixed.coveringOrigin());
  }
  return poses;
}

std::vector<Motion> randomMotions(const Polygon& fixed, const Polygon& moving, double length, double most_angle,
                                  std::uint64_t seed) {
  support::Random random(seed);
  std::vector<Motion> motions;
  for (const Pose& near : separatedPoses(fixed, moving, 1.03, 1.5)) {
    Motion motion;
    motion.start = near;
    motion.pivot = moving.coveringOrigin();
    const Vec2 inwards = (fixed.coveringOrigin() - near * moving.coveringOrigin()).normalized();
    motion.shift = length * random.real(0.5, 2) * (Eigen::Rotation2Dd(random.real(-1.2, 1.2)) * inwards);
    if (most_angle > 0) motion.angle = random.real(-most_angle, most_angle);
    motions.push_back(motion);
  }
  return motions;
}

Countries readCountries() {
  std::ifstream in(TRICOVER_COUNTRIES);
  if (!in) throw std::runtime_error("cannot read " TRICOVER_COUNTRIES);
  Countries countries = workloads::readPolygons(in);
  const auto spansTheMap = [](const workloads::NamedPolygon& country) {
    return country.polygon.bounds().sizes().x() > 300;
  };
  countries.erase(std::remove_if(countries.begin(), countries.end(), spansTheMap), countries.end());
  return countries;
}

}  // namespace tricover::bench
