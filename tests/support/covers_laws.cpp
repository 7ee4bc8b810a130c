// SPDX-License-Identifier: BSD-3-Clause
#include "covers_laws.h"

#include <algorithm>
#include <stdexcept>

#include "exact_covers.h"
#include "reproduction.h"
#include "shapes.h"
#include "tricover/covers.h"

namespace tricover::support {
namespace {

Vec2 anyPoint(Random& random, int low, int high) {
  const int x = random.integer(low, high);
  return {static_cast<double>(x), static_cast<double>(random.integer(low, high))};
}

Ring anyRing(Random& random, int low, int high) {
  Ring ring;
  for (int n = random.integer(3, 6); n > 0; --n) ring.push_back(anyPoint(random, low, high));
  return ring;
}

Ring anyRectangle(Random& random, int low, int high, int most) {
  const Vec2 p = anyPoint(random, low, high), size = anyPoint(random, 1, most);
  return eitherWay(random, rectangle(p.x(), p.y(), p.x() + size.x(), p.y() + size.y()));
}

/// Parts with and without an interior, spikes among them.
Polygon anyPart(Random& random) {
  switch (random.integer(0, 6)) {
    case 0: {
      const Vec2 p = anyPoint(random, 2, 5);
      return Polygon({{p, p, p}});
    }
    case 1: {
      const Vec2 p = anyPoint(random, 2, 5), q = anyPoint(random, 2, 5);
      return Polygon({{p, q, 0.5 * (p + q)}});
    }
    case 2:
      return Polygon({anyRectangle(random, 2, 3, 2), anyRing(random, 2, 5)}, FillRule::NonZero);
    case 3:
      return Polygon({anyRing(random, 2, 5)});
    default:
      return Polygon({anyRectangle(random, 2, 4, 2)});
  }
}

/// One pose, or the same one turned, for all: what touches still does.
void place(Random& random, Sheet& sheet) {
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
    std::vector<Ring> area{random.coin() ? anyRectangle(random, 0, 2, 8) : anyRing(random, -1, 9)};
    if (random.oneIn(3)) area.push_back(anyRing(random, 0, 8));
    sheet.areas.push_back({Polygon(area, random.coin() ? FillRule::EvenOdd : FillRule::NonZero), Pose::Identity(), {}});
  }
  return sheet;
}

/// The area's own pieces: a part that is one, or what fits exactly into a hole, beside the plug itself.
Sheet plugs(Random& random) {
  const Ring hole = anyRing(random, 1, 6);
  Sheet sheet{{{Polygon({rectangle(-2, -2, 9, 9), hole}), Pose::Identity(), {}}},
              random.coin() ? Polygon({hole}) : anyPart(random),
              Pose::Identity()};
  if (random.coin()) sheet.areas.push_back({Polygon({hole}), Pose::Identity(), {}});
  if (random.oneIn(4)) sheet.areas.push_back({Polygon({anyRing(random, 1, 6)}), Pose::Identity(), {}});
  return sheet;
}

/// Seams alone: areas without an interior, and parts along them.
Sheet bare(Random& random) {
  const Vec2 p = anyPoint(random, 0, 4), q = anyPoint(random, 0, 4), r = p + (q - p) * random.integer(1, 3);
  Sheet sheet{{}, Polygon({{p, q, p}}), Pose::Identity()};
  if (random.oneIn(4)) sheet.part = Polygon({{q, q, q}});
  if (random.oneIn(3)) sheet.part = Polygon({{p, q, p, p + Vec2(2, 1), p + Vec2(1, 2)}});
  for (int n = random.integer(1, 3); n > 0; --n) {
    const Vec2 s = p + (r - p) * 0.25 * random.integer(-1, 4), t = p + (r - p) * 0.25 * random.integer(0, 5);
    sheet.areas.push_back(
        {random.oneIn(3) ? Polygon({{s, t, s + Vec2(3, 1)}}) : Polygon({{s, t, s}}), Pose::Identity(), {}});
  }
  if (random.coin()) sheet.areas.push_back({Polygon({anyRing(random, -1, 6)}), Pose::Identity(), {}});
  if (random.oneIn(3)) sheet.areas.push_back({Polygon({anyRing(random, -1, 6), {q, q, q}}), Pose::Identity(), {}});
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
  place(random, sheet);
  return sheet;
}

}  // namespace

const std::vector<SheetKind>& sheetKinds() {
  static const std::vector<SheetKind> all = {
      {"lanes", placed<lanes>}, {"rings", placed<rings>}, {"plugs", placed<plugs>}, {"bare", placed<bare>}};
  return all;
}

std::string wrongCovers(const Sheet& sheet, double margin, CoversCounts& counts) {
  Scene scene;
  scene.add(sheet.areas);
  const bool truth = exact::covers(sheet.areas, sheet.part, sheet.pose, margin);
  (truth ? counts.covered : counts.not_covered) += 1;
  if (scene.covers(sheet.part, sheet.pose, {margin}) != truth) return "Scene::covers";
  bool by_one = false;
  for (const BodyPlacement& body : sheet.areas) {
    const bool by_this = sheet.areas.size() == 1 ? truth : exact::covers({body}, sheet.part, sheet.pose, margin);
    by_one |= by_this;
    if (covers(body.polygon, body.pose, sheet.part, sheet.pose, {margin}) != by_this) return "covers";
  }
  counts.unions += truth && !by_one;
  return {};
}

std::string reproduction(const Sheet& sheet) {
  std::string text;
  for (const BodyPlacement& body : sheet.areas)
    text += reproduction(Case{body.polygon, body.pose, sheet.part, sheet.pose}) + "\n";
  return text;
}

}  // namespace tricover::support
