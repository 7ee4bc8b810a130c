// SPDX-License-Identifier: BSD-3-Clause
#include <tricover/occupancy_grid_io.h>

#include <iostream>
#include <stdexcept>

int main() {
  try {
    tricover::readOccupancyMap("none.yaml");
  } catch (const std::runtime_error& error) {
    std::cout << error.what() << "\n";
  }
}
