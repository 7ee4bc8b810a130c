// SPDX-License-Identifier: BSD-3-Clause
// The fast exact reference says what rationals say, of every family.
#include "reference.h"

#include <string>

#include "exact_reference.h"
#include "families.h"
#include "law.h"
#include "pairs.h"
#include "shapes.h"

namespace tricover::laws {
namespace {

using namespace support;

std::string wrong(Random& random, Tally& tally, Case& c) {
  const Reference reference(c);
  const bool truth = exact::collide(c.a, c.pose_a, c.b, c.pose_b);
  tally.count("hits", truth);
  if (reference.collide() != truth) return "collide";
  if (reference.meetingEdges() != exact::meetingEdges(c.a, c.pose_a, c.b, c.pose_b)) return "edges";
  const mpq_class squared = exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b);
  if (reference.distanceSquared() != squared) return "distance";
  const double apart = exact::distanceBelow(squared), margin = nudged(apart < 1e308 ? apart : 1, random.integer(-1, 2));
  if (margin >= 0 && reference.within(margin) != exact::within(squared, mpq_class(margin))) return "within";
  const Vec2 p = c.pose_a.inverse() * (c.pose_b * c.b.edgeStart(anyEdge(random, c.b)));
  return !p.allFinite() || Reference::locate(c.a, p) == exact::locate(c.a, p) ? "" : "locate";
}

Laws referenceLaws() {
  Laws laws;
  add(laws, joined(familiesOfAllSizes(), anyPairs()), 200, wrong);
  return laws;
}

const Register registered("reference", referenceLaws);

}  // namespace
}  // namespace tricover::laws
