// SPDX-License-Identifier: BSD-3-Clause
// covers() of one area and Scene::covers() of several against exact rationals, complements among them.
#include "tricover/covers.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "covers_laws.h"
#include "exact_reference.h"
#include "law.h"
#include "pairs.h"
#include "reproduction.h"
#include "shapes.h"
#include "touching_families.h"

namespace tricover::laws {
namespace {

using namespace support;

/// The area itself or a smaller one like it, where it is, or what came with it; beside it at times what fits exactly.
Sheet around(Random& random, const Case& c) {
  Sheet sheet{{{c.a, c.pose_a, {}}}, c.b, c.pose_b};
  const double shrunk = random.oneIn(3) ? 1 : 1 - std::ldexp(1, -random.integer(1, 20));
  if (random.coin()) {
    const Vec2 s = c.a.origin();
    sheet.part = c.a.translated(-s).scaled(shrunk).translated(s);
    sheet.pose = c.pose_a;
    if (random.coin()) sheet.areas.push_back({c.b, c.pose_b, {}});
  }
  for (BodyPlacement& body : sheet.areas) {
    if (!random.oneIn(4)) continue;
    try {
      body.polygon = body.polygon.complement();
      if (random.coin()) sheet.areas.push_back({body.polygon.complement(), body.pose, {}});
      break;
    } catch (const std::invalid_argument&) {  // it has no area, or doubles do not hold a crossing
    }
  }
  return sheet;
}

double sizeOf(const Polygon& polygon) {
  return polygon.isComplement() ? polygon.complement().radius() : polygon.radius();
}

/// Often about the distance from what is outside of the first area.
double marginOf(Random& random, const Sheet& sheet) {
  const double size = std::max(sizeOf(sheet.part), sizeOf(sheet.areas[0].polygon));
  if (random.coin() || !(size > 1e-90 && size < 1e90)) return 0;
  if (random.coin()) return size * std::pow(10, random.real(-6, 0));
  try {
    const Polygon outside = sheet.areas[0].polygon.complement();
    const auto square = exact::distanceSquared(outside, sheet.areas[0].pose, sheet.part, sheet.pose);
    const double apart = exact::distanceBelow(square);
    return apart < 1e90 ? support::nudged(apart, random.integer(0, 1)) : 0;
  } catch (const std::invalid_argument&) {
    return 0;
  }
}

std::string wrongWith(const Sheet& sheet, double margin, Tally& tally) {
  CoversCounts counts;
  const std::string wrong = wrongCovers(sheet, margin, counts);
  tally.count(margin == 0 ? "covered" : "covered with a margin", counts.covered > 0);
  if (margin == 0) tally.count("by several", counts.unions > 0);
  return wrong.empty() ? wrong : wrong + ", margin " + hex(margin) + "\n" + reproduction(sheet);
}

/// Pairs that share edges and touch: one covers the other rarely, but what is left open is small.
std::string wrongTouch(Random&, Tally& tally, Case& c) {
  if (!covers(c.a, c.pose_a, c.a, c.pose_a)) return "a region doesn't cover itself";
  return wrongWith({{{c.a, c.pose_a, {}}}, c.b, c.pose_b}, 0, tally);
}

std::string wrongAround(Random& random, Tally& tally, Case& c) {
  const Sheet sheet = around(random, c);
  return wrongWith(sheet, marginOf(random, sheet), tally);
}

Case anyThatTouches(Random& random) {
  return touchingFamilies()[random.bits() % touchingFamilies().size()].make(random.bits());
}

Laws coversLaws() {
  Limits limits;
  limits.most_vertices = 10;
  Laws laws;
  for (const SheetKind& kind : sheetKinds())
    laws.push_back({kind.name,
                    600,
                    [kind](Random& random, Tally& tally) {
                      const Sheet sheet = kind.make(random);
                      std::string wrong = wrongWith(sheet, 0, tally);
                      for (const double margin : {0.5, 1.0, 2.0, marginOf(random, sheet)})
                        if (wrong.empty() && margin > 0) wrong = wrongWith(sheet, margin, tally);
                      return wrong;
                    },
                    {{"covered", 0.08, 0.92}, {"by several", 0.005, 0.9}}});
  add(laws, {family("touching", anyThatTouches)}, 300 * static_cast<int>(touchingFamilies().size()), wrongTouch,
      {{"covered", 0.005, 0.9}});
  add(laws, {family("around_touching", anyThatTouches)}, 400, wrongAround, {{"covered", 0.02, 0.98}});
  add(laws, anyPairs(limits), 100, wrongAround, {{"covered", 0.02, 0.98}}, "around_");
  return laws;
}

const Register registered("covers", coversLaws);

}  // namespace
}  // namespace tricover::laws
