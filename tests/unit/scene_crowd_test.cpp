// SPDX-License-Identifier: BSD-3-Clause
// Scenes of random bodies: what they answer is what loops over the bodies answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/scene.h"
#include "tricover/segment.h"

namespace tricover::support {
namespace {

/// Bodies of all sizes that move a little or jump, come and go, in a scene of some scale far from the origin or not.
struct Crowd {
  Crowd(std::uint64_t seed, double unit_, double away_) : random(seed), unit(unit_), away(away_) {
    for (int i = 0; i < 6; ++i)
      polygons.emplace_back(std::vector<Ring>{
          scaled(i % 2 == 0 ? star(random, 5 + 6 * i, 0.4, 1.2) : regular(4 + i, 1), unit * (i == 5 ? 8 : 1))});
    polygons.push_back(point({0, 0}));
    polygons.push_back(segment({-unit, 0}, {unit, 0}));
  }

  Pose place() {
    return pose(random.real(0, 6.28), away + unit * random.real(-9, 9), away + unit * random.real(-9, 9));
  }

  void add() {
    BodyOptions options;
    if (random.coin()) options.margin = unit * random.real(0, 0.5);
    if (random.oneIn(8)) options.mask = 2;
    if (random.oneIn(4)) options.category = 3;
    bodies.push_back(scene.add(polygons[static_cast<std::size_t>(random.integer(0, 7))], place(), options));
    EXPECT_TRUE(std::is_sorted(bodies.begin(), bodies.end()) || scene.contains(bodies.back()));
  }

  void step() {
    for (const Scene::Body body : bodies) {
      if (random.oneIn(3)) continue;
      Pose next = scene.pose(body);
      const double way = random.oneIn(40) ? 5 : 0.02;
      next.translation() += unit * way * Vec2(random.real(-1, 1), random.real(-1, 1));
      next.linear() = next.linear() * Eigen::Rotation2Dd(random.real(-0.02, 0.02)).toRotationMatrix();
      scene.move(body, random.oneIn(60) ? mirrored(next) : next);
    }
    if (random.oneIn(3) && !bodies.empty()) {
      const auto at = static_cast<std::size_t>(random.integer(0, static_cast<int>(bodies.size()) - 1));
      scene.remove(bodies[at]);
      bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(at));
    }
    if (random.oneIn(3)) add();
  }

  bool collide(Scene::Body p, Scene::Body q) const {
    const BodyOptions &of_p = scene.options(p), &of_q = scene.options(q);
    if ((of_p.category & of_q.mask) == 0 || (of_q.category & of_p.mask) == 0) return false;
    CollideOptions options;
    options.margin = of_p.margin + of_q.margin;
    return tricover::collide(scene.polygon(p), scene.pose(p), scene.polygon(q), scene.pose(q), options);
  }

  Random random;
  double unit, away;
  Scene scene;
  std::vector<Polygon> polygons;
  std::vector<Scene::Body> bodies;
};

TEST(SceneCrowd, SaysOfEveryFrameWhatAllPairsSay) {
  std::size_t hits = 0, began = 0, ended = 0;
  for (const auto& [unit, away] : {std::pair(1.0, 0.0), {1.0, 1e9}, {1e-200, 0.0}, {1e200, -1e202}, {2e306, 0.0}}) {
    Crowd crowd(11, unit, away);
    const bool slow = unit > 1e300;  // where doubles overflow every sign is found exactly
    for (int i = 0; i < (slow ? 15 : 40); ++i) crowd.add();
    std::vector<BodyPair> before;
    for (int frame = 0; frame < std::max(scaledCount(slow ? 40 : 150), 3); ++frame) {
      crowd.step();
      if (frame % 3 == 1) continue;  // counts grow meanwhile
      std::vector<BodyPair> expected;
      for (const Scene::Body p : crowd.bodies)
        for (const Scene::Body q : crowd.bodies)
          if (p < q && crowd.collide(p, q)) expected.push_back({p, q});
      std::sort(expected.begin(), expected.end());
      ASSERT_EQ(crowd.scene.collisions(), expected) << "unit " << unit << " frame " << frame;
      std::vector<BodyPair> news, gone;
      std::set_difference(expected.begin(), expected.end(), before.begin(), before.end(), std::back_inserter(news));
      std::set_difference(before.begin(), before.end(), expected.begin(), expected.end(), std::back_inserter(gone));
      ASSERT_EQ(crowd.scene.began(), news);
      ASSERT_EQ(crowd.scene.ended(), gone);
      before = expected;
      hits += expected.size();
      began += news.size();
      ended += gone.size();
    }
  }
  EXPECT_GT(hits, began);
  EXPECT_GT(ended, 0u);
}

/// In and about containers, which learn where they are clear: the answers are collide()'s, up to the walls.
TEST(SceneCrowd, AnswersInContainersAsAnywhere) {
  Random random(17);
  int hits = 0, asked = 0, by_the_wall = 0;
  for (int i = 0; i < scaledCount(60); ++i) {
    const Ring hole = i % 3 == 0 ? rectangle(-7, -4, 7, 4) : star(random, i % 3 == 1 ? 9 : 40, 3, 8);
    const Polygon container({rectangle(-9, -9, 9, 9), hole});
    BodyOptions body;
    if (random.oneIn(3)) body.margin = random.real(0, 0.5);
    Scene scene;
    const Scene::Body is_in = scene.add(container, pose(random.oneIn(2) ? 0 : random.real(0, 6), 0, 0), body);
    const Polygon part({rectangle(-0.5, -0.5, 0.5, 0.5)});
    for (int k = 0; k < 100; ++k) {
      if (k == 50) scene.move(is_in, pose(random.real(0, 6), random.real(-2, 2), random.real(-2, 2)));
      CollideOptions options;
      if (random.oneIn(3)) options.margin = random.real(0, 0.5);
      Pose at = pose(0, random.real(-8, 8), random.real(-5, 5));
      if (i % 3 == 0 && random.oneIn(4)) at.translation().y() = 3.5 - body.margin - options.margin, ++by_the_wall;
      CollideOptions sum;
      sum.margin = options.margin + body.margin;
      const bool hit = collide(part, at, container, scene.pose(is_in), sum);
      ASSERT_EQ(scene.collides(part, at, options), hit) << i << " " << k;
      ASSERT_EQ(scene.colliding(part, at, options).size(), hit ? 1u : 0u);
      hits += hit;
      ++asked;
    }
  }
  EXPECT_GT(hits, asked / 4);
  EXPECT_LT(hits, 3 * asked / 4);
  EXPECT_GT(by_the_wall, 0);
}

TEST(SceneCrowd, AnswersWhatLoopsOverTheBodiesAnswer) {
  int hits = 0, free = 0, impacts = 0;
  for (const auto& [unit, away] : {std::pair(1.0, 0.0), {1.0, 1e9}, {1e-200, 0.0}}) {
    Crowd crowd(12, unit, away);
    for (int i = 0; i < 12; ++i) crowd.add();
    for (int i = 0; i < std::max(scaledCount(200), 40); ++i) {
      if (i % 4 == 0) crowd.step();
      const Polygon& polygon = crowd.polygons[static_cast<std::size_t>(crowd.random.integer(0, 4))];
      const Pose at = crowd.place();
      CollideOptions options;
      options.margin = crowd.random.coin() ? unit * crowd.random.real(0, 1) : 0;
      std::vector<Scene::Body> expected;
      double least = std::numeric_limits<double>::infinity();
      for (const Scene::Body body : crowd.bodies) {
        CollideOptions sum;
        sum.margin = options.margin + crowd.scene.options(body).margin;
        if (collide(polygon, at, crowd.scene.polygon(body), crowd.scene.pose(body), sum)) expected.push_back(body);
        DistanceOptions own;
        own.margin = crowd.scene.options(body).margin;
        least = std::min(least, distance(polygon, at, crowd.scene.polygon(body), crowd.scene.pose(body), own).distance);
      }
      std::sort(expected.begin(), expected.end());
      ASSERT_EQ(crowd.scene.colliding(polygon, at, options), expected);
      ASSERT_EQ(crowd.scene.collides(polygon, at, options), !expected.empty());
      ASSERT_EQ(crowd.scene.nearest(polygon, at)->result.distance, least);
      ++(expected.empty() ? free : hits);

      Motion motion;
      motion.start = at;
      motion.shift = unit * Vec2(crowd.random.real(-9, 9), crowd.random.real(-9, 9));
      motion.angle = crowd.random.oneIn(3) ? 0 : crowd.random.real(-4, 4);
      if (crowd.random.oneIn(3)) motion.shift_2 = -motion.shift;
      double first = std::numeric_limits<double>::infinity();
      for (const Scene::Body body : crowd.bodies) {
        ImpactOptions own;
        own.margin = crowd.scene.options(body).margin;
        const auto impact =
            timeOfImpact(polygon, motion, crowd.scene.polygon(body), Motion::still(crowd.scene.pose(body)), own);
        if (impact) first = std::min(first, impact->time);
      }
      const auto impact = crowd.scene.firstImpact(polygon, motion);
      ASSERT_EQ(impact ? impact->impact.time : std::numeric_limits<double>::infinity(), first);
      if (impact && first > 0) ++impacts;

      const Vec2 from = at.translation(), to = from + motion.shift;
      double nearest = std::numeric_limits<double>::infinity();
      for (const Scene::Body body : crowd.bodies)
        if (const auto hit = castRay(crowd.scene.polygon(body), crowd.scene.pose(body), from, to);
            hit && crowd.scene.options(body).category == 3)
          nearest = std::min(nearest, hit->fraction);
      const auto hit = crowd.scene.castRay(from, to, {}, 2);
      if (hit && crowd.scene.options(hit->body).margin == 0) {
        ASSERT_EQ(hit->hit.fraction, nearest);
      }
      ASSERT_LE(hit ? hit->hit.fraction : 2, nearest);
    }
  }
  EXPECT_GT(hits, 5);
  EXPECT_GT(free, 5);
  EXPECT_GT(impacts, 5);
}

TEST(SceneCrowd, FindsAllImpactsOfBodiesThatMove) {
  std::size_t found = 0, first = 0;
  for (int i = 0; i < scaledCount(20); ++i) {
    Crowd crowd(static_cast<std::uint64_t>(100 + i), 1, 0);
    for (int k = 0; k < 16; ++k) crowd.add();
    std::vector<BodyMotion> motions;
    std::vector<Motion> all(32);
    for (const Scene::Body body : crowd.bodies) {
      Motion motion = Motion::still(crowd.scene.pose(body));
      if (crowd.random.coin()) {
        motion.shift = Vec2(crowd.random.real(-9, 9), crowd.random.real(-9, 9));
        motion.angle = crowd.random.real(-2, 2);
        motion.shift_3 = Vec2(crowd.random.real(-9, 9), 0);
        motions.push_back({body, motion});
      }
      all[body] = motion;
    }
    ImpactOptions options;
    if (crowd.random.coin()) options.margin = 0.125;
    std::vector<std::pair<double, BodyPair>> expected;
    for (const Scene::Body p : crowd.bodies)
      for (const Scene::Body q : crowd.bodies) {
        const auto moves = [&](Scene::Body body) {
          return std::any_of(motions.begin(), motions.end(), [&](const BodyMotion& m) { return m.body == body; });
        };
        const BodyOptions &of_p = crowd.scene.options(p), &of_q = crowd.scene.options(q);
        if (p >= q || !(moves(p) || moves(q)) || (of_p.category & of_q.mask) == 0 || (of_q.category & of_p.mask) == 0)
          continue;
        ImpactOptions sum = options;
        sum.margin += of_p.margin;
        sum.margin += of_q.margin;
        const auto impact = timeOfImpact(crowd.scene.polygon(p), all[p], crowd.scene.polygon(q), all[q], sum);
        if (impact) expected.push_back({impact->time, {p, q}});
      }
    std::sort(expected.begin(), expected.end());
    const std::vector<PairImpact> impacts = crowd.scene.impacts(motions, options);
    ASSERT_EQ(impacts.size(), expected.size());
    for (std::size_t k = 0; k < impacts.size(); ++k) {
      EXPECT_EQ(impacts[k].pair, expected[k].second);
      EXPECT_EQ(impacts[k].impact.time, expected[k].first);
      if (expected[k].first > 0) ++first;
    }
    found += impacts.size();
  }
  EXPECT_GT(found, first);
  EXPECT_GT(first, 0u);
}

TEST(SceneCrowd, AnswersManyPosesAtOnce) {
  Crowd crowd(13, 1, 0);
  crowd.polygons[5] = crowd.polygons[0];  // the large one
  for (int i = 0; i < 20; ++i) crowd.add();
  std::vector<Pose> poses;
  for (int i = 0; i < 2000; ++i) poses.push_back(crowd.place());
  const Polygon square({rectangle(-1, -1, 1, 1)});
  const std::vector<bool> answers = crowd.scene.collides(square, poses);
  const std::vector<bool> backwards = crowd.scene.collides(
      square, poses, {}, kEveryCategory, [](std::size_t count, const std::function<void(std::size_t)>& task) {
        while (count-- > 0) task(count);
      });
  int hits = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    ASSERT_EQ(answers[i], crowd.scene.collides(square, poses[i]));
    ASSERT_EQ(backwards[i], answers[i]);
    hits += answers[i];
  }
  EXPECT_GT(hits, 100);
  EXPECT_LT(hits, 1900);
}

}  // namespace
}  // namespace tricover::support
