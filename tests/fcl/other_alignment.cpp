// SPDX-License-Identifier: BSD-3-Clause
// Its Eigen aligns as under -march=native on most machines: otherwise than in tricover and libfcl.
#include <tricover_fcl/polygon_shape.h>

#include <cstdio>
#include <stdexcept>

int main() {
  try {
    const tricover_fcl::PolygonShaped square(tricover::Polygon({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}));
    std::printf("made\n");
  } catch (const std::logic_error& error) {
    std::printf("refused: %s\n", error.what());
  }
}
