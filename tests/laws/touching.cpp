// SPDX-License-Identifier: BSD-3-Clause
// Whether interiors meet, in every way of asking, against exact rationals.
#include <string>

#include "collide_laws.h"
#include "law.h"
#include "pairs.h"
#include "touching_families.h"
#include "tricover/collide.h"
#include "tricover/polygon.h"

namespace tricover::laws {
namespace {

using namespace support;

std::string wrong(Random& random, Tally& tally, Case& c) {
  const Overlap truth = overlapOf(c);
  tally.count("hits", truth.meet);
  tally.count("overlaps", truth.overlap);
  tally.count("touches", truth.meet && !truth.overlap);
  StrategyCaches old = cachesOfOthers(random);
  std::string problem = truth.overlap && !truth.meet ? "the reference" : wrongTouching(c, truth, old, random);
  if (problem.empty()) problem = wrongTouchingInScene(c, truth);
  return problem.empty()
             ? problem
             : problem + ", truth: meet " + std::to_string(truth.meet) + ", overlap " + std::to_string(truth.overlap);
}

std::string wrongWithoutArea(Random&, Tally&) {
  const CollideOptions open{0, 0, Touching::Allowed};
  const Pose here = Pose::Identity();
  const Polygon square({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}});
  // In a corner, where no discs inside meet; it touches by its spike alone, where its ring begins.
  const Polygon aerial({{{0.5, 9}, {0.5, 8.75}, {0.25, 8.75}, {0.25, 8.25}, {0.75, 8.25}, {0.75, 8.75}, {0.5, 8.75}}});
  const bool right = collide(square, here, aerial, here, open) &&
                     collide(square, here, Polygon::point({4, 4}), here, open) &&
                     collide(square, here, Polygon::segment({-1, 4}, {4, 4}), here, open) &&
                     !collide(square, here, Polygon::segment({-1, 9}, {4, 9}), here, open) &&
                     collide(square, here, Polygon::point({4, 4}), here, CollideOptions{0.5, 0, Touching::Allowed});
  return right ? "" : "what has no area leads inside, or has no interior";
}

Laws touchingLaws() {
  Limits limits;
  limits.most_vertices = 12;
  Laws laws = {{"kept_without_area", 1, wrongWithoutArea}};
  add(laws, touchingFamilies(), 1500, wrong, {{"hits", 0.16, 0.92}, {"overlaps", 0.08, 0.92}, {"touches", 0.08, 0.92}});
  add(laws, anyPairs(limits), 400, wrong);
  return laws;
}

const Register registered("touching", touchingLaws);

}  // namespace
}  // namespace tricover::laws
