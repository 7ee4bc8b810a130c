// SPDX-License-Identifier: BSD-3-Clause
// collide() in every way to ask it, with margins and tolerances, against the exact truth.
#include "tricover/collide.h"

#include "collide_laws.h"
#include "law.h"
#include "pairs.h"
#include "reference.h"

namespace tricover::laws {
namespace {

std::string wrong(Random& random, Tally& tally, Case& c) {
  const support::Reference reference(c);
  CollideOptions options;
  if (random.oneIn(4)) options.margin = anyMargin(random, c);
  const bool truth = options.margin == 0 ? reference.collide() : reference.within(options.margin);
  tally.count("hits", truth);
  support::StrategyCaches old = cachesOfOthers(random);
  const std::string problem = support::wrongCollide(c, options, {truth, truth}, old, random);
  if (!problem.empty() || !random.oneIn(8)) return problem;
  options.tolerance = smallerRadius(c) * random.real(0, 2);
  return support::wrongCollide(c, options, {truth, reference.within(options.margin + options.tolerance)}, old, random);
}

Laws collideLaws() {
  Laws laws;
  add(laws, support::families(), 5000, wrong, {{"hits", 0.15, 0.85}});
  add(laws, anyPairs(), 3000, wrong);
  return laws;
}

const Register registered("collide", collideLaws);

}  // namespace
}  // namespace tricover::laws
