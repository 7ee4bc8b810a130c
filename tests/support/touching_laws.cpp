// SPDX-License-Identifier: BSD-3-Clause
#include "touching_laws.h"

#include <cmath>
#include <vector>

#include "collide_laws.h"
#include "exact_reference.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/penetration.h"
#include "tricover/scene.h"

namespace tricover::support {
namespace {

CollideOptions closed() { return {}; }
CollideOptions open(double margin = 0) { return {margin, 0, Touching::Allowed}; }

}  // namespace

Overlap overlapOf(const Case& c) {
  return {exact::collide(c.a, c.pose_a, c.b, c.pose_b), exact::interiorsMeet(c.a, c.pose_a, c.b, c.pose_b)};
}

std::string wrongTouching(const Case& c, const Overlap& truth, StrategyCaches& old, Random& random) {
  const std::string wrong = wrongCollide(c, open(), {truth.overlap, truth.overlap}, old, random);
  if (!wrong.empty()) return wrong;
  for (const Strategy strategy : {Strategy::Hierarchy, Strategy::Paper}) {
    StrategyCaches fresh;
    for (int i = 0; i < 3; ++i) {
      if (collide(strategy, c.a, c.pose_a, c.b, c.pose_b, fresh, open()) != truth.overlap)
        return "open, of a cache that saw it closed";
      if (collide(strategy, c.a, c.pose_a, c.b, c.pose_b, fresh, closed()) != truth.meet)
        return "closed, of a cache that saw it open";
    }
  }
  return {};
}

std::string wrongTouchingInScene(const Case& c, const Overlap& truth) {
  for (const Touching of_body : {Touching::Collides, Touching::Allowed}) {
    Scene scene;
    BodyOptions body;
    body.touching = of_body;
    const auto first = scene.add(c.a, c.pose_a, body);
    const bool closed_answer = of_body == Touching::Allowed ? truth.overlap : truth.meet;
    for (int i = 0; i < 3; ++i) {
      if (scene.collides(c.b, c.pose_b, open()) != truth.overlap) return "scene";
      if (scene.collides(c.b, c.pose_b) != closed_answer) return "scene, closed";
      if (scene.colliding(c.b, c.pose_b, open()).empty() == truth.overlap) return "colliding";
      if (scene.anyColliding(c.b, c.pose_b).has_value() != closed_answer) return "anyColliding, closed";
    }
    if (scene.collides(c.b, {c.pose_b, c.pose_b}, open()) != std::vector<bool>(2, truth.overlap)) return "many poses";
    const auto second = scene.add(c.b, c.pose_b);
    Pose aside = c.pose_a;
    aside.translation().x() += c.a.radius();
    if (!aside.translation().allFinite()) aside = c.pose_a;
    for (int i = 0; i < 3; ++i) {
      if (scene.collisions().empty() == closed_answer) return "frame " + std::to_string(i);
      scene.move(second, aside);
      if (i == 0) scene.collisions();
      scene.move(second, c.pose_b);
      scene.move(first, c.pose_a);
    }
  }
  return {};
}

std::string wrongTouchingAtMargin(const Case& c) {
  const mpq_class square = exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b);
  const double apart = exact::distanceBelow(square);
  if (!(apart > 0 && apart < 1e300)) return {};
  for (const double margin : {apart, std::nextafter(apart, 0.0), std::nextafter(apart, 2e300), 2 * apart}) {
    const bool is_below = square < mpq_class(margin) * margin;
    if (collide(c.a, c.pose_a, c.b, c.pose_b, open(margin)) != is_below) return "margin";
    PairCache cache;
    for (int i = 0; i < 2; ++i) {
      if (collide(c.b, c.pose_b, c.a, c.pose_a, cache, open(margin)) != is_below) return "margin, with a cache";
      if (collide(c.a, c.pose_a, c.b, c.pose_b, cache, {margin}) != exact::within(square, margin))
        return "margin, closed, with a cache";
    }
    if (collide(Strategy::Paper, c.a, c.pose_a, c.b, c.pose_b, open(margin)) != is_below) return "margin, paper";
    Scene scene;
    BodyOptions half;
    half.margin = margin / 2;  // rounded, where it is small
    scene.add(c.a, c.pose_a, half);
    if (scene.collides(c.b, c.pose_b, open(margin - half.margin)) != is_below) return "margin, scene";
    PenetrationOptions deep{margin, Touching::Allowed};
    if (penetration(c.a, c.pose_a, c.b, c.pose_b, deep).has_value() != is_below) return "margin, penetration";
    ContactOptions parts;
    parts.margin = margin;
    parts.touching = Touching::Allowed;
    if (contacts(c.a, c.pose_a, c.b, c.pose_b, parts).empty() == is_below) return "margin, contacts";
  }
  return {};
}

std::string wrongTouchingInLists(const Case& c, const Overlap& truth) {
  CrossingOptions inner;
  ContactOptions parts;
  PenetrationOptions deep;
  inner.touching = parts.touching = deep.touching = Touching::Allowed;
  const std::vector<Crossing> found = crossings(c.a, c.pose_a, c.b, c.pose_b, inner);
  if (!found.empty() && !truth.overlap) return "crossings where interiors are apart";
  if (found.size() > crossings(c.a, c.pose_a, c.b, c.pose_b).size()) return "crossings, more than without";
  if (found.size() != crossings(c.b, c.pose_b, c.a, c.pose_a, inner).size()) return "crossings, swapped";
  for (const ContactDetail detail : {ContactDetail::Points, ContactDetail::LocalDepth}) {
    parts.detail = detail;
    PairCache cache;
    for (int i = 0; i < 2; ++i)
      if (contacts(c.a, c.pose_a, c.b, c.pose_b, cache, parts).empty() == truth.overlap)
        return "contacts, with a cache";
    const std::size_t count = contacts(c.a, c.pose_a, c.b, c.pose_b, parts).size();
    if ((count > 0) != truth.overlap) return "contacts";
    ContactOptions all;
    all.detail = detail;
    if (count > contacts(c.a, c.pose_a, c.b, c.pose_b, all).size()) return "contacts, more than without";
  }
  if (penetration(c.a, c.pose_a, c.b, c.pose_b, deep).has_value() != truth.overlap) return "penetration";
  return {};
}

}  // namespace tricover::support
