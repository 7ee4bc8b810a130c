// SPDX-License-Identifier: BSD-3-Clause
// A car in a parking lot: is each pose inside of the drivable area, how close does the car come to its border, and when
// does the car first come near another one?
#include <tricover/tricover.h>

#include <cmath>
#include <iostream>
#include <vector>

using tricover::poseAt;

int main() {
  // Two bays are closed for works, which leaves a hole. The lane to the street is a second area, next to the lot.
  const tricover::Polygon lot({{{0, 0}, {30, 0}, {30, 12}, {0, 12}}, {{10, 7}, {14, 7}, {14, 11}, {10, 11}}});
  const tricover::Polygon lane({{{-20, 1}, {0, 1}, {0, 5}, {-20, 5}}});
  const tricover::Polygon car({{{-1, -0.9}, {3.5, -0.9}, {3.5, 0.9}, {-1, 0.9}}});  // around its rear axle

  // Poses one by one, in the lot alone, with 0.2 m to spare, and in the lot and the lane together.
  tricover::Scene drivable;
  drivable.add(lot, poseAt(0, 0));
  drivable.add(lane, poseAt(0, 0));
  for (const tricover::Pose& at : {poseAt(5, 3), poseAt(9, 5, 0.7), poseAt(2, 11.1), poseAt(-2, 3)})
    std::cout << "(" << at.translation().transpose() << "): "
              << (covers(lot, poseAt(0, 0), car, at, {0.2}) ? "in the lot with 0.2 m to spare\n"
                  : covers(lot, poseAt(0, 0), car, at)      ? "in the lot\n"
                  : drivable.covers(car, at)                ? "in the lot and the lane\n"
                                                            : "outside\n");

  // The way into a bay in 8 s, beside all that isn't drivable.
  const auto way = tricover::Trajectory::spline(
      {{0, {{4, 3}, 0, {2, 0}, 0}}, {4, {{12, 3.5}, 0.2, {2, 0.5}, 0.3}}, {8, {{18, 8}, M_PI / 2, {0, 0.5}, 0}}});
  const auto least = leastDistance(lot.complement(), poseAt(0, 0), car, way);
  std::cout << "least clearance " << least.distance << " m at " << least.time << " s\n";

  // Another car leaves its bay meanwhile, and the lot at 8 s: it is there from 1 s to 8 s.
  const auto other = tricover::Trajectory::through({{1, poseAt(22, 7.5, M_PI / 2)},
                                                    {3, poseAt(22, 2.5, M_PI / 2)},
                                                    {4, poseAt(22, 2.5, M_PI)},
                                                    {8, poseAt(5, 2.5, M_PI)}});
  tricover::ImpactOptions options;
  options.margin = 0.5;
  const std::vector<tricover::Conflict> found = conflicts(car, way, car, other.appearing().vanishing(), options);
  if (!found.empty()) std::cout << "within 0.5 m from " << found[0].impact.time << " s to " << found[0].end << " s\n";
}
