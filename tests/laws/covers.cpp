// SPDX-License-Identifier: BSD-3-Clause
// covers() of one area and Scene::covers() of several against exact rationals, complements among them.
#include "tricover/covers.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "exact_covers.h"
#include "exact_reference.h"
#include "law.h"
#include "pairs.h"
#include "reproduction.h"
#include "shapes.h"
#include "touching_families.h"
#include "tricover/scene.h"

namespace tricover::laws {
namespace {

using namespace support;

/// Areas and a part that they may cover together.
struct Sheet {
  std::vector<BodyPlacement> areas;
  Polygon part;
  Pose pose;
};

/// One way in which areas and parts touch; in all of them areas often abut, and the part is covered as often as not.
struct SheetKind {
  const char* name;
  Sheet (*make)(Random& random);
};

Vec2 gridPoint(Random& random, int low, int high) {
  const int x = random.integer(low, high);
  return {static_cast<double>(x), static_cast<double>(random.integer(low, high))};
}

Ring gridRing(Random& random, int low, int high) {
  Ring ring;
  for (int n = random.integer(3, 6); n > 0; --n) ring.push_back(gridPoint(random, low, high));
  return ring;
}

Ring anyRectangle(Random& random, int low, int high, int most) {
  const Vec2 p = gridPoint(random, low, high), size = gridPoint(random, 1, most);
  return eitherWay(random, rectangle(p.x(), p.y(), p.x() + size.x(), p.y() + size.y()));
}

/// Parts with and without an interior, spikes among them.
Polygon anyPart(Random& random) {
  switch (random.integer(0, 6)) {
    case 0: {
      const Vec2 p = gridPoint(random, 2, 5);
      return Polygon({{p, p, p}});
    }
    case 1: {
      const Vec2 p = gridPoint(random, 2, 5), q = gridPoint(random, 2, 5);
      return Polygon({{p, q, 0.5 * (p + q)}});
    }
    case 2:
      return Polygon({anyRectangle(random, 2, 3, 2), gridRing(random, 2, 5)}, FillRule::NonZero);
    case 3:
      return Polygon({gridRing(random, 2, 5)});
    default:
      return Polygon({anyRectangle(random, 2, 4, 2)});
  }
}

/// One pose, or the same one turned, for all: what touches still does.
void posed(Random& random, Sheet& sheet) {
  Pose pose = Pose::Identity();
  if (random.coin()) pose = Eigen::Rotation2Dd(random.real(-3, 3)) * pose;
  if (random.oneIn(3)) pose.linear().col(1) *= -1;
  if (random.coin()) pose.translation() = Vec2(random.real(-9, 9), random.real(-9, 9));
  sheet.pose = pose;
  for (BodyPlacement& body : sheet.areas) body.pose = pose;
}

/// Lanes that overlap, abut or leave gaps.
Sheet lanes(Random& random) {
  Sheet sheet{{}, random.coin() ? Polygon({anyRectangle(random, 1, 2, 4)}) : anyPart(random), Pose::Identity()};
  for (int n = random.integer(1, 6); n > 0; --n) {
    const double x = random.integer(0, 5), y = random.integer(0, 5);
    const double length = random.integer(3, 9), width = random.integer(2, 4);
    const bool lies = random.coin();
    sheet.areas.push_back(
        {Polygon({eitherWay(random, rectangle(lies ? x - 3 : x, lies ? y : y - 3, lies ? x - 3 + length : x + width,
                                              lies ? y + width : y - 3 + length))}),
         Pose::Identity(),
         {}});
  }
  return sheet;
}

/// Rings of integers, with holes and seams.
Sheet rings(Random& random) {
  Sheet sheet{{}, anyPart(random), Pose::Identity()};
  for (int n = random.integer(1, 3); n > 0; --n) {
    std::vector<Ring> area{random.coin() ? anyRectangle(random, 0, 2, 8) : gridRing(random, -1, 9)};
    if (random.oneIn(3)) area.push_back(gridRing(random, 0, 8));
    sheet.areas.push_back({Polygon(area, random.coin() ? FillRule::EvenOdd : FillRule::NonZero), Pose::Identity(), {}});
  }
  return sheet;
}

/// The area's own pieces: a part that is one, or what fits exactly into a hole, beside the plug itself.
Sheet plugs(Random& random) {
  const Ring hole = gridRing(random, 1, 6);
  Sheet sheet{{{Polygon({rectangle(-2, -2, 9, 9), hole}), Pose::Identity(), {}}},
              random.coin() ? Polygon({hole}) : anyPart(random),
              Pose::Identity()};
  if (random.coin()) sheet.areas.push_back({Polygon({hole}), Pose::Identity(), {}});
  if (random.oneIn(4)) sheet.areas.push_back({Polygon({gridRing(random, 1, 6)}), Pose::Identity(), {}});
  return sheet;
}

/// Seams alone: areas without an interior, and parts along them.
Sheet bare(Random& random) {
  const Vec2 p = gridPoint(random, 0, 4), q = gridPoint(random, 0, 4), r = p + (q - p) * random.integer(1, 3);
  Sheet sheet{{}, Polygon({{p, q, p}}), Pose::Identity()};
  if (random.oneIn(4)) sheet.part = Polygon({{q, q, q}});
  if (random.oneIn(3)) sheet.part = Polygon({{p, q, p, p + Vec2(2, 1), p + Vec2(1, 2)}});
  for (int n = random.integer(1, 3); n > 0; --n) {
    const Vec2 s = p + (r - p) * 0.25 * random.integer(-1, 4), t = p + (r - p) * 0.25 * random.integer(0, 5);
    sheet.areas.push_back(
        {random.oneIn(3) ? Polygon({{s, t, s + Vec2(3, 1)}}) : Polygon({{s, t, s}}), Pose::Identity(), {}});
  }
  if (random.coin()) sheet.areas.push_back({Polygon({gridRing(random, -1, 6)}), Pose::Identity(), {}});
  if (random.oneIn(3)) sheet.areas.push_back({Polygon({gridRing(random, -1, 6), {q, q, q}}), Pose::Identity(), {}});
  return sheet;
}

/// What has an area, where doubles say it.
void complement(Polygon& polygon) {
  try {
    polygon = polygon.complement();
  } catch (const std::invalid_argument&) {
  }
}

template <Sheet (*make)(Random& random)>
Sheet placed(Random& random) {
  Sheet sheet = make(random);
  if (random.oneIn(4)) complement(sheet.areas.back().polygon);
  if (random.oneIn(8)) complement(sheet.part);
  posed(random, sheet);
  return sheet;
}

/// The area itself or a smaller one like it, where it is, or what came with it; beside it at times what fits exactly.
Sheet around(Random& random, const Case& c) {
  Sheet sheet{{{c.a, c.pose_a, {}}}, c.b, c.pose_b};
  const double shrunk = random.oneIn(3) ? 1 : 1 - std::ldexp(1, -random.integer(1, 20));
  if (random.coin()) {
    const Vec2 s = c.a.coveringOrigin();
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

constexpr SheetKind kKinds[] = {
    {"lanes", placed<lanes>}, {"rings", placed<rings>}, {"plugs", placed<plugs>}, {"bare", placed<bare>}};

std::string reproductionOf(const Sheet& sheet) {
  std::string text;
  for (const BodyPlacement& body : sheet.areas)
    text += reproduction(Case{body.polygon, body.pose, sheet.part, sheet.pose}) + "\n";
  return text;
}

/// covers() and Scene::covers() say what exact rationals say.
std::string wrongCovers(const Sheet& sheet, double margin, Tally& tally) {
  Scene scene;
  scene.add(sheet.areas);
  const bool truth = exact::covers(sheet.areas, sheet.part, sheet.pose, margin);
  tally.count(margin == 0 ? "covered" : "covered with a margin", truth);
  if (scene.covers(sheet.part, sheet.pose, {margin}) != truth) return "Scene::covers";
  bool by_one = false;
  for (const BodyPlacement& body : sheet.areas) {
    const bool by_this = sheet.areas.size() == 1 ? truth : exact::covers({body}, sheet.part, sheet.pose, margin);
    by_one |= by_this;
    if (covers(body.polygon, body.pose, sheet.part, sheet.pose, {margin}) != by_this) return "covers";
  }
  if (margin == 0) tally.count("by several", truth && !by_one);
  return {};
}

std::string wrongWith(const Sheet& sheet, double margin, Tally& tally) {
  const std::string wrong = wrongCovers(sheet, margin, tally);
  return wrong.empty() ? wrong : wrong + ", margin " + hex(margin) + "\n" + reproductionOf(sheet);
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
  for (const SheetKind& kind : kKinds)
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
