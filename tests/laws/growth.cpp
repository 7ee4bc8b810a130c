// SPDX-License-Identifier: BSD-3-Clause
// Pairs of which some step takes the product of their edges, at some sizes: they keep to all laws, and impacts are
// never late.
#include <cctype>
#include <cmath>
#include <string>

#include "exact_reference.h"
#include "growth_inputs.h"
#include "law.h"
#include "laws.h"
#include "pairs.h"
#include "reproduction.h"
#include "tricover/collide.h"
#include "tricover/distance.h"
#include "tricover/time_of_impact.h"

namespace tricover::laws {
namespace {

using namespace support;

constexpr double kSpeed = 5;  // no point is faster
const Pose kHere = Pose::Identity();

std::string wrongPoses(Random& random, const growth::Input& in) {
  PairCache old = cachesOfOthers(random).of_pair;
  for (const double time : {0.0, 0.25, 0.75}) {
    const Case c{in.a, kHere, in.b, in.motion.at(time)};
    std::string wrong;
    for (const Touching touching : {Touching::Collides, Touching::Allowed})
      if (wrong.empty()) wrong = brokenLaw(c, 0, touching, areWithin(c, 0, touching), random, old);
    const double found = distance(c.a, c.pose_a, c.b, c.pose_b).distance,
                 below = exact::distanceBelow(exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b));
    if (wrong.empty() && !(std::abs(found - below) <= 1e-14 * below)) wrong = "distance";
    if (!wrong.empty()) return wrong + "\n" + reproduction(c);
  }
  return {};
}

/// Never late: free at some times before. Hardly early, by 1e-6 at most: near each other.
std::string wrongImpact(const growth::Input& in) {
  const auto impact = timeOfImpact(in.a, Motion::still(kHere), in.b, in.motion);
  const double until = impact ? impact->time : 1;
  for (const double share : {0.0, 0.3, 0.7, 0.99})
    if (until > 0 && exact::collide(in.a, kHere, in.b, in.motion.at(share * until))) return "late, at " + hex(share);
  if (!impact) return {};
  const Pose then = in.motion.at(impact->time);
  return exact::within(exact::distanceSquared(in.a, kHere, in.b, then), kSpeed * 1e-6) ? "" : "early";
}

std::string wrong(Random& random, const growth::Kind& kind) {
  for (const std::size_t n : {5u, 12u, 40u}) {
    const growth::Input in = kind.make(n);
    std::string problem = wrongPoses(random, in);
    if (problem.empty()) problem = wrongImpact(in);
    if (!problem.empty()) return "of size " + std::to_string(n) + ": " + problem;
  }
  return {};
}

/// As many edges as it takes for nodes to be cut by their corners: free before by collide(), and near each other then.
std::string wrongFans(Random& random, Tally& tally) {
  const double gap = (random.coin() ? 1 : -1) * std::pow(10, random.real(-7, -2));
  const double angle = random.oneIn(3) ? 0 : random.real(-0.3, 0.3);
  const growth::Input in = growth::passingFans(300, gap, angle);
  const Motion still = Motion::still(kHere);
  const auto impact =
      random.coin() ? timeOfImpact(in.b, in.motion, in.a, still) : timeOfImpact(in.a, still, in.b, in.motion);
  tally.count("hits", impact.has_value());
  const double until = impact ? impact->time : 1;
  const std::string text = ", of fans that pass at " + hex(gap) + ", turned by " + hex(angle);
  for (const double share : {0.0, 0.3, 0.48, 0.49, 0.5, 0.51, 0.6, 0.9, 0.99, 0.9999})
    if (collide(in.a, kHere, in.b, in.motion.at(share * until))) return "late, at " + hex(share) + text;
  const bool is_early = impact && distance(in.a, kHere, in.b, in.motion.at(until)).distance > kSpeed * 1e-6;
  return is_early ? "early" + text : "";
}

Laws growthLaws() {
  Laws laws = {{"passing_fans", 60, wrongFans, {{"hits", 0.2, 0.8}}}};
  for (const growth::Kind& kind : growth::allKinds()) {
    std::string name = kind.name;
    for (char& c : name)
      if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    laws.push_back({name, 1, [kind](Random& random, Tally&) { return wrong(random, kind); }});
  }
  return laws;
}

const Register registered("growth", growthLaws);

}  // namespace
}  // namespace tricover::laws
