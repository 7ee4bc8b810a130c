// SPDX-License-Identifier: BSD-3-Clause
// A scene beside loops over the functions of all pairs of its bodies.
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "families.h"
#include "law.h"
#include "pairs.h"
#include "reproduction.h"
#include "scene_walk.h"
#include "shapes.h"
#include "touching_families.h"
#include "tricover/polygon.h"

namespace tricover::laws {
namespace {

using namespace support;

std::string wrongWalk(const std::vector<Case>& cases, Random& random, Tally& tally, std::size_t bodies, int frames) {
  SceneWalk walk(cases, random.bits(), bodies);
  for (int frame = 0; frame < frames && walk.wrong.empty(); ++frame) {
    const std::pair<const char*, int SceneWalk::*> counted[] = {
        {"hits", &SceneWalk::hits}, {"began", &SceneWalk::began},   {"ended", &SceneWalk::ended},
        {"free", &SceneWalk::free}, {"inside", &SceneWalk::inside}, {"impacts", &SceneWalk::impacts_found},
        {"rays", &SceneWalk::rays}, {"leasts", &SceneWalk::leasts}};
    std::vector<int> before;
    for (const auto& [trait, count] : counted) before.push_back(walk.*count);
    walk.frame();
    for (std::size_t i = 0; i < before.size(); ++i) tally.count(counted[i].first, walk.*counted[i].second > before[i]);
  }
  return walk.wrong;
}

/// The large ones' trees of boxes have several levels.
std::string wrongOf(const Family& family, Random& random, Tally& tally) {
  const bool is_large = random.oneIn(4);
  std::vector<Case> cases;
  for (int k = 0; k < 3; ++k) {
    cases.push_back(family.make(random.bits()));
    if (k > 0 && random.oneIn(3)) cases.back() = cases.front();
  }
  return wrongWalk(cases, random, tally, is_large ? 60 : 12, is_large ? 4 : 30);
}

/// Stars and regular polygons of many sizes, a point and a segment: of some scale, far from the origin or not.
std::string wrongCrowd(Random& random, Tally& tally) {
  constexpr std::pair<double, double> kScales[] = {{1, 0}, {1, 1e9}, {1e-200, 0}, {1e200, -1e202}, {1e304, 0}};
  const auto [unit, far] = kScales[random.integer(0, 4)];
  const auto place = [&, u = unit, away = far] {
    return turnedAndMoved(random.real(0, 6.28), away + u * random.real(-9, 9), away + u * random.real(-9, 9));
  };
  std::vector<Case> cases;
  for (int i = 0; i < 6; ++i) {
    const Ring ring = i % 2 == 0 ? star(random, 5 + 6 * i, 0.4, 1.2) : regular(4 + i, 1);
    const Polygon other = i < 2 ? Polygon::point({0, 0}) : i < 4 ? Polygon::segment({-unit, 0}, {unit, 0}) : cases[0].a;
    cases.push_back({Polygon({scaled(ring, unit * (i == 5 ? 8 : 1))}), place(), other, place()});
  }
  const bool is_slow = unit > 1e300;  // where doubles overflow every sign is found exactly
  return wrongWalk(cases, random, tally, is_slow ? 15 : 40, is_slow ? 15 : 30);
}

/// Zones and what is outside of them as bodies among others.
std::string wrongZones(Random& random, Tally& tally) {
  const auto place = [&](double far) {
    return turnedAndMoved(random.real(0, 6.28), random.real(-far, far), random.real(-far, far));
  };
  std::vector<Case> cases;
  for (int i = 0; i < 4; ++i) {
    const Polygon zone({star(random, 20 + 40 * i, 8, 9), scaled(star(random, 5, 0.5, 1), 0.5)});
    const Polygon car({random.coin() ? star(random, 9, 0.2, 0.8) : regular(4 + i, 0.5)});
    cases.push_back({i < 2 ? zone.complement() : car, place(i < 2 ? 0.5 : 3), i == 1 ? zone : car, place(3)});
  }
  return wrongWalk(cases, random, tally, random.oneIn(6) ? 40 : 10, 15);
}

/// In and about containers, which learn where they are clear: the answers are collide()'s, up to the walls.
std::string wrongInContainer(Random& random, Tally& tally) {
  const int kind = random.integer(0, 2);
  const Ring hole = kind == 0 ? rectangle(-7, -4, 7, 4) : star(random, kind == 1 ? 9 : 40, 3, 8);
  const Polygon container({rectangle(-9, -9, 9, 9), hole}), part({rectangle(-0.5, -0.5, 0.5, 0.5)});
  BodyOptions body{random.oneIn(3) ? random.real(0, 0.5) : 0};
  Scene scene;
  const Scene::Body is_in = scene.add(container, turnedAndMoved(random.coin() ? 0 : random.real(0, 6), 0, 0), body);
  for (int k = 0; k < 100; ++k) {
    if (k == 25) body.margin += 0.25, scene.setOptions(is_in, body);  // where it was clear it may not be now
    if (k == 50) scene.move(is_in, turnedAndMoved(random.real(0, 6), random.real(-2, 2), random.real(-2, 2)));
    const CollideOptions options{random.oneIn(3) ? random.real(0, 0.5) : 0};
    const bool is_by_the_wall = kind == 0 && random.oneIn(4);
    const Pose at =
        turnedAndMoved(0, random.real(-8, 8), is_by_the_wall ? 3.5 - body.margin - options.margin : random.real(-5, 5));
    const bool hit = collide(part, at, container, scene.pose(is_in), {options.margin + body.margin});
    tally.count("hits", hit);
    tally.count("by the wall", is_by_the_wall);
    if (scene.collides(part, at, options) != hit || scene.colliding(part, at, options).empty() == hit)
      return "question " + std::to_string(k) + "\n" + reproduction({part, at, container, scene.pose(is_in)});
  }
  return {};
}

/// So many that they come by the hundred, and are packed.
std::string wrongOfMany(Random& random, Tally& tally) {
  const Polygon square({rectangle(-1, -1, 1, 1)});
  std::vector<Case> cases;
  for (int i = 0; i < 600; ++i) {
    const double angle = random.real(0, 6), x = random.real(0, 60);
    const Pose at = turnedAndMoved(angle, x, random.real(0, 60));
    cases.push_back({square, at, square, at});
  }
  return wrongWalk(cases, random, tally, 600, 4);
}

/// Of frames: some ten see each of these.
Shares seen(double least, std::initializer_list<const char*> traits) {
  Shares shares;
  for (const char* trait : traits) shares.push_back({trait, least, 1});
  return shares;
}

Laws sceneLaws() {
  const auto all = {"hits", "began", "ended", "free", "inside", "impacts", "rays", "leasts"};
  Laws laws = {{"crowds", 20, wrongCrowd, seen(0.02, all)},
               {"containers", 60, wrongInContainer, {{"hits", 0.25, 0.75}, {"by the wall", 0.02, 0.5}}},
               {"many", 8, wrongOfMany, seen(0.02, {"hits", "began", "ended"})},
               {"zones", 48, wrongZones, seen(0.014, {"hits", "began", "free", "impacts", "rays", "leasts"})}};
  for (const Family& family : joined(families(), anyPairs()))
    laws.push_back({family.name, 32, [family](Random& random, Tally& tally) { return wrongOf(family, random, tally); },
                    seen(0.014, all)});
  return laws;
}

const Register registered("scene", sceneLaws);

}  // namespace
}  // namespace tricover::laws
