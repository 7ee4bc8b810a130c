// SPDX-License-Identifier: BSD-3-Clause
#include <tricover/tricover.h>

#include <iostream>

int main() {
  const tricover::Polygon square({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  tricover::Pose beside = tricover::Pose::Identity();
  beside.translation().x() = 1;
  std::cout << (tricover::collide(square, tricover::Pose::Identity(), square, beside) ? "meet\n" : "miss\n");
}
