// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "own_folder.h"
#include "tricover/occupancy_grid_io.h"

namespace tricover {

using Cells = std::vector<std::int8_t>;

/// A map of 3 x 2 cells, of which a test replaces what it is about.
class MapFolder : public testing::Test {
 protected:
  void SetUp() override { write("map.pgm", "P2\n# by hand\n3 2\n255\n0 254 205\n254 0 254\n"); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  /// The map of the usual keys, one of which may be another line, or none.
  OccupancyMap map(const std::string& key = "", const std::string& line = "") const {
    std::string text;
    for (const std::string usual : {"image: map.pgm", "resolution: 0.05", "origin: [-1.5, 2.0, 0.5]  # in metres",
                                    "negate: 0", "occupied_thresh: 0.65", "free_thresh: 0.196", "mode: 'trinary'"})
      text += (!key.empty() && usual.rfind(key, 0) == 0 ? line : usual) + "\n";
    write("map.yaml", text);
    return readOccupancyMap(path("map.yaml"));
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  template <typename Error = std::runtime_error, typename Call>
  static std::string errorOf(Call&& call) {
    try {
      call();
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }
  std::string errorWith(const std::string& key, const std::string& line) const {
    return errorOf([&] { map(key, line); });
  }
  std::string errorOfImage(const std::string& image) const {
    write("map.pgm", image);
    return errorOf([&] { map(); });
  }

  support::OwnFolder own_;
  const std::filesystem::path folder_ = own_.path();
};

}  // namespace tricover
