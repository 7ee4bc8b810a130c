// SPDX-License-Identifier: BSD-3-Clause
#include "cases.h"
#include "scene_walk.h"
#include "soak.h"

namespace tricover::soak {

/// Scene beside loops over all pairs of its bodies.
void soakScene(Run& run) {
  while (run.next()) {
    Random& random = run.random();
    const char* family = nullptr;
    std::vector<Case> cases;
    for (int i = 0; i < 3; ++i) {
      const Drawn drawn = anyCase(random);
      family = drawn.family;
      cases.push_back(drawn.c);
      // In the same place, mostly.
      if (i > 0 && random.oneIn(3)) cases.back() = cases.front();
    }
    support::SceneWalk walk(cases, random.bits(), random.oneIn(20) ? 60 : 10);
    const int frames = random.integer(4, 40);
    for (int i = 0; i < frames && walk.wrong.empty(); ++i) {
      const int hits = walk.hits, asked = walk.asked;
      walk.frame();
      if (walk.asked > asked) run.count(family, walk.hits > hits);
    }
    if (!walk.wrong.empty()) run.fail(family, "a scene", walk.wrong);
  }
}

}  // namespace tricover::soak
