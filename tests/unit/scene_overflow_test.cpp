// SPDX-License-Identifier: BSD-3-Clause
// Bodies of a size, or as far away, that sums of coordinates overflow.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/scene.h"
#include "tricover/time_of_impact.h"

namespace tricover::support {
namespace {

const Polygon kSquare({rectangle(-1, -1, 1, 1)});

/// Bodies that overflow have boxes without ends. Their boxes meet every body, but they themselves don't.
TEST(Scene, MeetsWhatOverflows) {
  const Polygon spike({{{-1, -1}, {1, -1}, {0, 1e308}}});
  Pose turned = turnedAndMoved(0, 5, 0);
  turned.linear() << 0, 1, 1, 0;
  Scene scene;
  const Scene::Body a = scene.add(kSquare, turnedAndMoved(0, 5, 0)), b = scene.add(kSquare, turnedAndMoved(0, 9, 9));
  EXPECT_EQ(scene.colliding(spike, turned), (std::vector<Scene::Body>{a}));
  const Scene::Body c = scene.add(spike, turned);
  EXPECT_EQ(scene.collisions(), (std::vector<BodyPair>{{a, c}}));
  scene.remove(a);
  EXPECT_TRUE(scene.colliding(spike, turnedAndMoved(0, -5, 0)).empty());
  EXPECT_TRUE(scene.collisions().empty());
  EXPECT_EQ(scene.colliding(kSquare, turnedAndMoved(0, 8, 8)), (std::vector<Scene::Body>{b}));
}

/// On its way into the world a coordinate overflows that comes back: its box must not stay at infinity.
TEST(Scene, MeetsWhatComesBackFromBeyondTheLargestDouble) {
  const Polygon corner({rectangle(1.69e308, 1.69e308, 1.7e308, 1.7e308)}),
      here({rectangle(0.6e308, -1e307, 0.8e308, 1e307)});
  Scene scene;
  const Scene::Body right = scene.add(corner, turnedAndMoved(-M_PI / 4, -1.7e308, 0));
  EXPECT_EQ(scene.colliding(here, turnedAndMoved(0, 0, 0)), std::vector<Scene::Body>{right});
  scene.remove(right);
  const Scene::Body up = scene.add(corner, turnedAndMoved(M_PI / 4, 0, -1.7e308));
  EXPECT_EQ(scene.colliding(here, turnedAndMoved(M_PI / 2, 0, 0)), std::vector<Scene::Body>{up});
}

TEST(Scene, OfAPolygonThatIsTooLargeForItsBoxes) {
  const Polygon huge({rectangle(-1.7e308, -1.7e308, 1.7e308, 1.7e308)}),
      far({rectangle(1.6e308, 1.6e308, 1.65e308, 1.65e308)});
  Scene scene;
  scene.add(huge, turnedAndMoved(0, 0, 0));
  scene.add(far, turnedAndMoved(0, 0, 0));
  EXPECT_EQ(scene.collisions().size(), 1u);
  EXPECT_TRUE(scene.collides(far, turnedAndMoved(0, 0, 0)));
  EXPECT_EQ(scene.colliding(kSquare, turnedAndMoved(0, -1e308, 1e308)).size(), 1u);
}

/// The way that a body moves in all, and the square of each step, are above the largest double.
TEST(Scene, FollowsHugeBodies) {
  Scene scene;
  scene.add(Polygon({rectangle(-1e307, -1e307, 1e307, 1e307)}), turnedAndMoved(0, -8e307, 0));
  const Scene::Body there = scene.add(Polygon({rectangle(-1e306, -1e306, 1e306, 1e306)}), turnedAndMoved(0, -7e307, 0));
  int hits = 0;
  for (int frame = 0; frame < 150; ++frame) {
    const int way = frame < 100 ? frame % 50 : frame - 100;
    const double x = (frame / 50 % 2 == 0 ? -8e307 + 3e306 * way : 7e307 - 3e306 * way);
    scene.move(0, turnedAndMoved(0, x, 0));
    const bool hit = collide(scene.polygon(0), scene.pose(0), scene.polygon(there), scene.pose(there));
    ASSERT_EQ(!scene.collisions().empty(), hit) << "frame " << frame;
    hits += hit;
  }
  EXPECT_GT(hits, 3);
  EXPECT_LT(hits, 100);
}

/// A size and a step that overflow say nothing of each other: the step is a jump.
TEST(Scene, FollowsBodiesWhoseSizeOverflows) {
  BodyOptions wide;
  wide.margin = 1e308;
  Scene scene;
  const Scene::Body a = scene.add(Polygon({rectangle(-1e308, 0, 1e308, 1e308)}), turnedAndMoved(0, 0, 1), wide),
                    b = scene.add(Polygon({rectangle(-1, -1.1e308, 1, -1e308)}), turnedAndMoved(0, 0, 0));
  EXPECT_TRUE(scene.collisions().empty());
  scene.move(a, turnedAndMoved(0, 1e200, 1));
  EXPECT_TRUE(scene.collisions().empty());
  scene.move(a, turnedAndMoved(0, 1e200, 0));
  EXPECT_EQ(scene.collisions(), (std::vector<BodyPair>{{a, b}}));
}

/// Times of impact know nothing of a polygon whose radius is above the largest unit, and report whatever is asked.
/// Impacts of scenes are the same: its box must not leave anything out.
TEST(Scene, ReportsTheImpactsOfWhatIsAboveTheLargestUnit) {
  const Polygon huge({{{0x1.529e7dd968fbep+1021, -0x1.e197746867ccap+1020},
                       {0x1.1df1ed1dfda18p+1021, -0x1.1df1ed1dfda18p+1021},
                       {0x1.9dde2809b933ep+1021, -0x1.0ee5317aba632p+1022},
                       {0x1.da111696c62d7p+1021, -0x1.8ed16c6675f57p+1021}}},
                     FillRule::EvenOdd),
      other({{{0x1.c37dfd21e14fdp+1019, 0x1.6931974e4dd98p+1017},
              {0x1.f0a4300bab0bp+1020, -0x1.0ee5317aba632p+1020},
              {0x1.ffb0ebaeee497p+1020, -0x1.2cfea8c140dfep+1018},
              {0x1.b471417e9e117p+1020, 0x1.c37dfd21e14fdp+1019}}},
            FillRule::EvenOdd);
  Pose far = Pose::Identity(), there = Pose::Identity();
  far.matrix().topRows<2>() << 0x1.fdf0286065c03p-1, -0x1.6f3a10c379e5ap-4, -0x1.c6d2a73618d38p+1003,
      0x1.6f3a10c379e5ap-4, 0x1.fdf0286065c03p-1, -0x1.9285ddd048ea6p+1002;
  there.matrix().topRows<2>() << 0x1.fdbdfa24c0a89p-1, -0x1.803fd6927ecc7p-4, 0x1.ec0f0d248048dp+1008,
      0x1.803fd6927ecc7p-4, 0x1.fdbdfa24c0a89p-1, 0x1.2d366ce6fd6ddp+1009;
  const Motion still = Motion::still(far), here = Motion::still(there), origin = Motion::still(turnedAndMoved(0, 0, 0));
  Motion turning = still;
  turning.angle = 3;
  turning.pivot = huge.origin();
  Scene scene;
  const Scene::Body a = scene.add(huge, far), b = scene.add(other, there), c = scene.add(kSquare, origin.start);
  for (const Motion& motion : {still, turning}) {
    const auto with_b = timeOfImpact(huge, motion, other, here), with_c = timeOfImpact(huge, motion, kSquare, origin);
    EXPECT_EQ(scene.impacts({{a, motion}}).size(), (with_b ? 1u : 0u) + (with_c ? 1u : 0u));
    EXPECT_EQ(scene.firstImpact(huge, motion, {}, {~0u, a}).has_value(), with_b || with_c);
  }
  const auto of_still = timeOfImpact(huge, still, kSquare, origin);
  scene.remove(b);
  EXPECT_EQ(scene.impacts({{c, origin}}).size(), of_still ? 1u : 0u);
  EXPECT_EQ(scene.firstImpact(kSquare, origin, {}, {~0u, c}).has_value(), of_still.has_value());
}

}  // namespace
}  // namespace tricover::support
