// SPDX-License-Identifier: BSD-3-Clause
// Destructors of static and thread_local objects may collide, after the thread's table of certificates is gone.
#include <tricover_fcl/collide.h>
#include <tricover_fcl/distance.h>
#include <tricover_fcl/polygon_shape.h>

#include <cstdio>
#include <cstdlib>
#include <thread>

namespace {

struct Asker {
  tricover_fcl::PolygonShaped square{tricover::Polygon({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}})};

  void ask() const {
    const fcl::Transform3d here = fcl::Transform3d::Identity();
    for (const double x : {0.5, 1.0, 3.0}) {
      fcl::Transform3d there = here;
      there.translation().x() = x;
      for (int i = 0; i < 3; ++i) {  // from the second time on a pair has a slot of its own
        fcl::CollisionResultd collision;
        fcl::DistanceResultd distance;
        tricover_fcl::collide<double>(&square, here, &square, there, fcl::CollisionRequestd(), collision);
        tricover_fcl::distance<double>(&square, here, &square, there, fcl::DistanceRequestd(), distance);
        if (collision.isCollision() == (x <= 1) && distance.min_distance == (x < 1 ? -1 : x - 1)) continue;
        std::printf("wrong at %g: %d, %g\n", x, collision.isCollision(), distance.min_distance);
        std::_Exit(1);
      }
    }
  }
  ~Asker() { ask(); }
};

const Asker asks_when_the_program_ends;

}  // namespace

int main() {
  // Made before the table, so it goes after it.
  thread_local const Asker asks_when_the_main_thread_ends;
  asks_when_the_main_thread_ends.ask();
  std::thread([] {
    thread_local const Asker asks_when_the_thread_ends;
    asks_when_the_thread_ends.ask();
  }).join();
}
