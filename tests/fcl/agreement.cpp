// SPDX-License-Identifier: BSD-3-Clause
// The laws that collide, distance and continuousCollide share, along random walks.
#include "managers.h"

namespace tricover_fcl::test {
namespace {

TEST(Agreement, alongWalks) {
  Random random(71);
  int hits = 0, queries = 0;
  for (int walk = 0; walk < scaledCount(150); ++walk) {
    const double heights[3] = {0, random.real(0, 0.2), 0};
    const auto shape = [&](double height) { return shapeOf(randomPolygon(random, 1), {0, 0, height}); };
    fcl::CollisionObjectd a(shape(heights[walk % 3])), b(shape(heights[(walk + 1) % 3]));
    Vec2 place(random.real(-2, 2), random.real(-2, 2));
    double angle = 0, z = 0;
    for (int step = 0; step < 100; ++step) {
      const double stride = random.oneIn(30) ? 1 : 0.05;
      angle += stride * random.real(-1, 1);
      place = 0.98 * place + stride * Vec2(random.real(-1, 1), random.real(-1, 1));
      if (random.oneIn(10)) z = random.coin() ? 0 : random.real(-0.3, 0.3);
      a.setTransform(lifted(angle, place.x(), place.y(), z));
      a.computeAABB();
      const auto collide = [](const fcl::CollisionObjectd& p, const fcl::CollisionObjectd& q,
                              fcl::GJKSolverType solver) {
        return collides(p.collisionGeometry(), p.getTransform(), q.collisionGeometry(), q.getTransform(), solver);
      };
      // From where the objects are, straight to where they are: only the begin can be a contact.
      const auto timeOfContact = [](const fcl::CollisionObjectd& p, const fcl::CollisionObjectd& q,
                                    fcl::GJKSolverType solver) {
        const Impact impact = impactOf(p.collisionGeometry(), p.getTransform(), p.getTransform(), q.collisionGeometry(),
                                       q.getTransform(), q.getTransform(), advancing(1e-6, fcl::CCDM_TRANS, solver));
        EXPECT_EQ(impact.is_collide, impact.time_of_contact < 1);
        return impact.time_of_contact;
      };
      const bool hit = collide(a, b, fcl::GST_LIBCCD);
      ASSERT_TRUE(!hit || a.getAABB().overlap(b.getAABB()));
      ASSERT_EQ(collide(b, a, fcl::GST_INDEP), hit);
      const double apart = distanceOf(a, b, fcl::GST_LIBCCD, false);
      ASSERT_EQ(apart <= 0, hit) << walk << " " << step;
      ASSERT_EQ(distanceOf(b, a, fcl::GST_INDEP, false), apart);
      // Copies' poses are at other places: nothing is remembered of them.
      ASSERT_EQ(distanceOf(fcl::CollisionObjectd(a), fcl::CollisionObjectd(b), fcl::GST_INDEP, false), apart);
      const double time = timeOfContact(a, b, fcl::GST_LIBCCD);
      ASSERT_EQ(time == 0, hit) << walk << " " << step;
      ASSERT_EQ(timeOfContact(b, a, fcl::GST_INDEP), time);
      if (step % 10 == 0) {
        const double with_sign = distanceOf(a, b, fcl::GST_LIBCCD, true);
        ASSERT_EQ(distanceOf(b, a, fcl::GST_INDEP, true), with_sign) << walk << " " << step;
        ASSERT_TRUE(hit ? with_sign <= 0 : with_sign == apart);
      }
      hits += hit;
      ++queries;
    }
  }
  EXPECT_GT(hits, queries * 2 / 10);
  EXPECT_LT(hits, queries * 8 / 10);
}

}  // namespace
}  // namespace tricover_fcl::test
