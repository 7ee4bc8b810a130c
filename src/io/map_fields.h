// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/input.h"
#include "tricover/pose.h"

namespace tricover::detail {

/// What cells are, beside degrees from 1 to 99.
constexpr std::int8_t kFreeCell = 0, kOccupiedCell = 100, kUnknownCell = -1;

enum class MapMode { Trinary, Scale, Raw };

/// What a map's YAML file says.
struct MapFields {
  std::string image;
  MapMode mode = MapMode::Trinary;
  double resolution = 0;
  Pose pose;
  bool negate = false;
  double occupied_thresh = 0, free_thresh = 0;
};

/// \throws std::runtime_error for what is no map's YAML file
MapFields readMapFields(const Input& yaml);

/// The cell's value for each grey i / white of the image, i from 0 to white.
std::vector<std::int8_t> valuesOfGreys(const MapFields& fields, std::size_t white);

/// The text of the YAML file. `yaw` is what poseAt() makes the pose's rotation of.
/// \throws std::invalid_argument for an image's name that YAML doesn't keep
std::string writeMapFields(const MapFields& fields, double yaw);

}  // namespace tricover::detail
