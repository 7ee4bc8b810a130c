// SPDX-License-Identifier: BSD-3-Clause
// A car in a parking lot: is each pose inside of the drivable area, how close does the car come to its border on an arc
// into a bay, and when does it first come near another car? usage: parking [parking.html], a recording
#include <tricover/tricover.h>

#include <cmath>
#include <iostream>

using namespace tricover;

int main(int argc, char** argv) {
  // Two bays are closed for works, which leaves a hole. The lane to the street is a second area, next to the lot.
  const Polygon lot({{{0, 0}, {30, 0}, {30, 12}, {0, 12}}, {{10, 7}, {14, 7}, {14, 11}, {10, 11}}});
  const Polygon car({{-1, -0.9}, {3.5, -0.9}, {3.5, 0.9}, {-1, 0.9}});  // around its rear axle
  const Pose here = poseAt(0, 0);
  Scene drivable;
  drivable.add({{lot, here, {}}, {Polygon({{-20, 1}, {0, 1}, {0, 5}, {-20, 5}}), here, {}}});
  for (const Pose& at : {poseAt(5, 3), poseAt(9, 5, 0.7), poseAt(2, 11.1), poseAt(-2, 3)})
    std::cout << "(" << at.translation().transpose() << "): "
              << (covers(lot, here, car, at, {0.2}) ? "in the lot with 0.2 m to spare\n"
                  : covers(lot, here, car, at)      ? "in the lot\n"
                  : drivable.covers(car, at)        ? "in the lot and the lane\n"
                                                    : "outside\n");

  // Straight on for 4 s, and by an arc of 5 m radius into a bay in 4 more.
  const auto straight = Motion::translation(poseAt(4, 3), {9, 0}), arc = Motion::arc(poseAt(13, 3), {13, 8}, M_PI / 2);
  const Trajectory way({{0, 4, straight}, {4, 8, arc}});
  const LeastDistance least = leastDistance(lot.complement(), here, car, way);
  std::cout << "least clearance " << least.distance << " m at " << least.time << " s\n";

  // Another car leaves the lot meanwhile: it is there from 1 s to 8 s.
  const auto other = Trajectory::through({{1, poseAt(24, 7.5, -M_PI / 2)}, {8, poseAt(5, 2.5, -M_PI)}});
  Scene cars;
  const auto mine = cars.add(car, way.at(0), {0.25}), its = cars.add(car, other.at(1), {0.25});
  const std::vector<BodyTrajectory> moving{{mine, way}, {its, other.appearing().vanishing()}};
  const std::vector<PairConflict> conflicts = cars.conflicts(moving);
  const Conflict& first = conflicts.at(0).conflict;
  std::cout << "within 0.5 m from " << first.impact.time << " s to " << first.end << " s\n";

  SceneRecording recording("A parking lot");
  recording.trajectories(cars, moving);
  recording.conflicts(conflicts);
  recording.nearest(least);
  recording.save(argc > 1 ? argv[1] : "parking.html");
}
