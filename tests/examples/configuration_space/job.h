// SPDX-License-Identifier: BSD-3-Clause
// What is computed, and how it is cut into chunks that don't depend on each other.
#pragma once

#include <tricover/occupancy_grid_io.h>
#include <tricover/scene.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace configuration_space {

/// Headings times cells along x and y, over the whole map, in the map's own frame.
struct Size {
  std::size_t headings = 64, width = 512, height = 512;
};

using Bytes = std::vector<char>;

/// One bit a configuration, 1 where the robot collides: heading by heading, row by row from the lowest y, each row from
/// the lowest x in whole bytes, lowest bit first.
class Job {
 public:
  /// With `whole_cells`, a bit is 0 only if every pose of the cell is free, headings halfway to the next ones included.
  Job(const std::string& yaml, const Size& size, bool whole_cells)
      : size_(size), map_(tricover::readOccupancyMap(yaml).grid) {
    const auto walls = tricover::outline(map_);
    if (walls) scene_.add(*walls, tricover::Pose::Identity());
    if (whole_cells) {
      // No point of the robot is farther than this from where it is at the cell's centre. Rounded up by far.
      const double x = cellWidth(), y = cellHeight(), turn = kTurn / (2 * static_cast<double>(size.headings));
      options_.margin =
          (0.5 * std::hypot(x, y) + turn * (robot_.radius() + robot_.coveringOrigin().norm())) * (1 + 1e-12);
    }
    std::ostringstream header;
    header << "tricover configuration space 2\nmap " << std::hex << hashOf(map_) << std::dec << "\nheadings "
           << size.headings << " width " << size.width << " height " << size.height << (whole_cells ? " whole" : "")
           << "\n";
    header_ = header.str();
  }

  const Size& size() const { return size_; }
  /// The result's first lines: equal for equal jobs, wherever their maps are.
  const std::string& header() const { return header_; }
  std::size_t rowBytes() const { return (size_.width + 7) / 8; }
  /// Rows of one heading, the last ones of which may be fewer.
  std::size_t chunks() const { return size_.headings * chunksPerHeading(); }
  std::size_t chunkBytes() const { return kRows * rowBytes(); }

  /// The bytes of one chunk; missing rows are 0.
  Bytes chunk(std::size_t index) const {
    const std::size_t heading = index / chunksPerHeading(), first = index % chunksPerHeading() * kRows;
    const std::size_t last = std::min(first + kRows, size_.height);
    const double angle = kTurn * static_cast<double>(heading) / static_cast<double>(size_.headings);
    std::vector<tricover::Pose> poses(size_.width, tricover::Pose(Eigen::Rotation2Dd(angle)));
    Bytes bytes(chunkBytes());
    for (std::size_t row = first; row < last; ++row) {
      for (std::size_t i = 0; i < size_.width; ++i)
        poses[i].translation() = map_.origin + tricover::Vec2((static_cast<double>(i) + 0.5) * cellWidth(),
                                                              (static_cast<double>(row) + 0.5) * cellHeight());
      const std::vector<bool> collides = scene_.collides(robot_, poses, options_);
      for (std::size_t i = 0; i < size_.width; ++i)
        if (collides[i]) bytes[(row - first) * rowBytes() + i / 8] |= static_cast<char>(1 << i % 8);
    }
    return bytes;
  }

  /// Where a heading's row begins in the chunks, one after the other.
  std::size_t rowAt(std::size_t heading, std::size_t row) const {
    return (heading * chunksPerHeading() + row / kRows) * chunkBytes() + row % kRows * rowBytes();
  }

 private:
  static constexpr std::size_t kRows = 16;
  static constexpr double kTurn = 6.283185307179586;

  /// Of all that the result depends on (FNV-1a, 64 bits).
  static std::uint64_t hashOf(const tricover::OccupancyGrid& map) {
    std::uint64_t hash = 0xcbf29ce484222325;
    const auto add = [&hash](const void* bytes, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i)
        hash = (hash ^ static_cast<const unsigned char*>(bytes)[i]) * 0x100000001b3;
    };
    add(&map.width, sizeof map.width);
    add(&map.height, sizeof map.height);
    add(&map.resolution, sizeof map.resolution);
    add(map.cells.data(), map.cells.size());
    return hash;
  }
  std::size_t chunksPerHeading() const { return (size_.height + kRows - 1) / kRows; }
  double cellWidth() const {
    return map_.resolution * static_cast<double>(map_.width) / static_cast<double>(size_.width);
  }
  double cellHeight() const {
    return map_.resolution * static_cast<double>(map_.height) / static_cast<double>(size_.height);
  }

  Size size_;
  tricover::OccupancyGrid map_;
  tricover::Scene scene_;
  tricover::Polygon robot_{{{-0.5, -0.3},
                            {0.6, -0.3},
                            {0.6, -0.2},
                            {0, -0.2},  //
                            {0, 0.2},
                            {0.6, 0.2},
                            {0.6, 0.3},
                            {-0.5, 0.3}}};  // a forklift, in metres
  tricover::CollideOptions options_;
  std::string header_;
};

}  // namespace configuration_space
