// SPDX-License-Identifier: BSD-3-Clause
// Must not compile: see tests/unit/CMakeLists.txt.
#include "tricover/scene.h"

bool isFree(const tricover::Scene& scene, tricover::Scene::Body me) {
  return !scene.collides(scene.polygon(me), scene.pose(me), {}, me);
}
