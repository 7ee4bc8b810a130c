// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/covers.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "cases.h"
#include "covers_laws.h"
#include "exact_reference.h"
#include "reproduction.h"
#include "shapes.h"
#include "soak.h"
#include "touching_families.h"

namespace tricover::soak {
namespace {

using support::Sheet;

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
double anyMargin(Random& random, const Sheet& sheet) {
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

Sheet anySheet(Random& random, const char*& family) {
  const auto& kinds = support::sheetKinds();
  const auto& touching = support::touchingFamilies();
  if (random.coin()) {
    const support::SheetKind& kind = kinds[random.bits() % kinds.size()];
    family = kind.name;
    return kind.make(random);
  }
  if (random.oneIn(4)) {
    const support::Family& made = touching[random.bits() % touching.size()];
    family = made.name;
    return around(random, made.make(random.bits()));
  }
  Limits limits;
  limits.most_vertices = 10;
  const Drawn drawn = anyCase(random, limits);
  family = drawn.family;
  return around(random, drawn.c);
}

}  // namespace

/// covers() of one area and Scene::covers() of several against exact rationals, complements among them.
void soakCovers(Run& run) {
  while (run.next()) {
    Random& random = run.random();
    const char* family = nullptr;
    const Sheet sheet = anySheet(random, family);
    const double margin = anyMargin(random, sheet);
    support::CoversCounts counts;
    const std::string wrong = support::wrongCovers(sheet, margin, counts);
    run.count(family, counts.covered > 0);
    if (!wrong.empty()) run.fail(family, wrong + ", margin " + support::hex(margin), support::reproduction(sheet));
  }
}

}  // namespace tricover::soak
