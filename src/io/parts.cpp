// SPDX-License-Identifier: BSD-3-Clause
// Between a polygon and the parts that files have: shells with holes.
#include "io/parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "numbers/dyadic.h"
#include "numbers/errors.h"
#include "numbers/shortest.h"
#include "tricover/covers.h"
#include "tricover/scene.h"
#include "tricover/validity.h"

namespace tricover::detail {
namespace {

const char* const kRepair = "repair it, as ogr2ogr -makevalid does";

/// Parts of one feature, with names for errors.
struct Named {
  std::string nameOf(std::size_t part) const {
    return parts.size() == 1 ? name : name + ": part " + std::to_string(part);
  }
  std::string nameOf(std::size_t part, std::size_t ring) const {
    return nameOf(part) + (parts.size() == 1 ? ": ring " : ", ring ") + std::to_string(ring);
  }

  std::vector<Part> parts;
  const std::string& name;
};

/// Drops the vertex that closes the ring.
void openRing(Ring& ring, const std::string& name) {
  const std::size_t count = ring.size();
  if (count < 4)
    refuseFile(name, "it has " + std::to_string(count) + (count == 1 ? " position" : " positions"),
               "a ring needs at least 4, of which the last one equals the first");
  if (ring.front() != ring.back())
    refuseFile(name + ", vertex " + std::to_string(count - 1), "the ring isn't closed",
               "end it with its first position");
  ring.pop_back();
}

/// Returns how many coordinates were rounded.
std::size_t subtract(const Vec2& origin, Ring& ring, const std::string& name) {
  std::size_t rounded = 0;
  for (Vec2& vertex : ring) {
    for (const int axis : {0, 1}) {
      const double x = vertex[axis], o = origin[axis], difference = x - o;
      if (!std::isfinite(difference))
        refuseFile(name + ", vertex " + std::to_string(&vertex - ring.data()),
                   "a coordinate minus the origin is beyond the range of doubles", "choose an origin near the data");
      if ((Dyadic(x) - Dyadic(o) - Dyadic(difference)).sign() != 0) ++rounded;
      vertex[axis] = difference;
    }
  }
  return rounded;
}

/// Which regions overlap, each pair once: more than their outlines meet.
std::vector<std::array<std::size_t, 2>> overlaps(const std::vector<Polygon>& regions) {
  BodyOptions options;
  options.touching = Touching::Allowed;
  std::vector<BodyPlacement> bodies;
  bodies.reserve(regions.size());
  for (const Polygon& region : regions) bodies.push_back({region, Pose::Identity(), options});
  Scene scene;
  std::map<BodyHandle, std::size_t> numbers;
  for (const BodyHandle body : scene.add(bodies)) numbers.insert({body, numbers.size()});
  std::vector<std::array<std::size_t, 2>> pairs;
  for (const BodyPair& pair : scene.collisions()) pairs.push_back({numbers.at(pair.first), numbers.at(pair.second)});
  return pairs;
}

bool isIn(const Polygon& inner, const Polygon& outer) {
  return covers(outer, Pose::Identity(), inner, Pose::Identity());
}

/// Whether a shell minus its holes is what the even-odd rule makes of these rings.
void requireHolesInside(const Named& all, std::size_t number) {
  const Part& part = all.parts[number];
  if (part.size() == 1) return;
  const Polygon shell(part[0]);
  std::vector<Polygon> holes;
  for (std::size_t r = 1; r < part.size(); ++r) {
    holes.emplace_back(part[r]);
    if (!isIn(holes.back(), shell))
      refuseFile(all.nameOf(number, r), "the hole is not inside of its shell, ring 0", kRepair);
  }
  if (holes.size() == 1) return;
  for (const auto& [a, b] : overlaps(holes))
    refuseFile(all.nameOf(number, b + 1), "the hole overlaps another one, ring " + std::to_string(a + 1), kRepair);
}

/// The sign of the area that a ring winds around: 1 counter-clockwise. Exact.
int directionOf(const Ring& ring) {
  const auto next = [&](std::size_t i) -> const Vec2& { return ring[i + 1 < ring.size() ? i + 1 : 0]; };
  double sum = 0, size = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 v = ring[i] - ring[0], w = next(i) - ring[0];
    sum += v.x() * w.y() - v.y() * w.x();
    size += std::abs(v.x() * w.y()) + std::abs(v.y() * w.x());
  }
  // A term errs by 2^-50 of its size at most, and the sum by a rounding a term; underflow loses what the last says.
  const double error = (0x1p-50 + 0x1p-52 * static_cast<double>(ring.size())) * size + 0x1p-1000;
  if (std::abs(sum) > error && std::isfinite(error)) return sum > 0 ? 1 : -1;
  Dyadic exact;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &v = ring[i], &w = next(i);
    exact = exact + (Dyadic(v.x()) * Dyadic(w.y()) - Dyadic(v.y()) * Dyadic(w.x()));
  }
  return exact.sign();
}

/// Turns a ring the other way round, from the same vertex on.
void orient(Ring& ring, int direction) {
  if (directionOf(ring) != direction) std::reverse(ring.begin() + 1, ring.end());
}

/// Under the non-zero rule a part must wind once around its inside: around nothing twice, or backwards.
void requireSimple(const Named& all, const std::vector<Polygon>& regions, const std::array<std::size_t, 2>& overlap) {
  for (std::size_t p = 0; p < regions.size(); ++p)
    for (const SelfCrossing& crossing : selfCrossings(regions[p]))
      if (crossing.ring_a == crossing.ring_b)
        refuseFile(all.nameOf(p),
                   crossing.text + ", while parts " + std::to_string(overlap[0]) + " and " +
                       std::to_string(overlap[1]) +
                       " overlap, and only parts that don't cross themselves can be joined",
                   kRepair);
}

using OrderedPoint = std::array<double, 2>;

/// The vertices of an edge from v, with those that were added, in order along it.
void appendEdge(Ring& to, const Vec2& v, const Vec2& w, std::vector<OrderedPoint> added) {
  const OrderedPoint way{w.x() < v.x() ? -1.0 : 1.0, w.y() < v.y() ? -1.0 : 1.0};
  const std::size_t main = std::abs(w.x() / 2 - v.x() / 2) < std::abs(w.y() / 2 - v.y() / 2) ? 1 : 0;
  const auto place = [&](const OrderedPoint& p) {
    return OrderedPoint{way[main] * p[main], way[1 - main] * p[1 - main]};
  };
  std::sort(added.begin(), added.end(),
            [&](const OrderedPoint& p, const OrderedPoint& q) { return place(p) < place(q); });
  added.erase(std::unique(added.begin(), added.end()), added.end());
  to.push_back(v);
  for (const OrderedPoint& p : added)
    if (Vec2(p.data()) != v && Vec2(p.data()) != w) to.push_back(Vec2(p.data()));
}

/// Adds crossings of edges as vertices, until there is none away from vertices. Returns how many.
std::size_t addCrossings(std::vector<Ring>& rings, const std::string& name) {
  constexpr int kMostRounds = 32;
  // Rounding makes few crossings anew, within an ulp of others. Where edges' coordinates differ by a hundred orders of
  // magnitude, each round doubles their number.
  std::size_t most = 1 << 20;
  std::set<OrderedPoint> points;
  for (int round = 0; round < kMostRounds; ++round) {
    std::map<EdgeIndex, std::vector<OrderedPoint>> added;
    const auto crossings = selfCrossings(Polygon(rings, FillRule::NonZero), most + 1);
    if (crossings.size() > most) break;
    for (const SelfCrossing& crossing : crossings) {
      if (crossing.kind != SelfCrossingKind::Crossing) continue;
      const OrderedPoint point{crossing.point.x(), crossing.point.y()};
      points.insert(point);
      for (const EdgeIndex edge : {crossing.edge_a, crossing.edge_b}) added[edge].push_back(point);
    }
    if (added.empty()) return points.size();
    if (round == 0) most = 3 * crossings.size() + 16;
    EdgeIndex edge = 0;
    for (Ring& ring : rings) {
      Ring longer;
      longer.reserve(ring.size());
      for (std::size_t i = 0; i < ring.size(); ++i, ++edge) {
        const auto found = added.find(edge);
        if (found == added.end())
          longer.push_back(ring[i]);
        else
          appendEdge(longer, ring[i], ring[i + 1 < ring.size() ? i + 1 : 0], std::move(found->second));
      }
      ring = std::move(longer);
    }
  }
  refuseFile(name,
             "its parts overlap, and cross at more than " + std::to_string(most) +
                 " places, those included that rounding makes",
             kRepair);
}

std::vector<Ring> ringsOf(std::vector<Part> parts) {
  std::vector<Ring> rings;
  for (Part& part : parts) std::move(part.begin(), part.end(), std::back_inserter(rings));
  return rings;
}

GeoFeature join(Named all) {
  for (std::size_t p = 0; p < all.parts.size(); ++p) requireHolesInside(all, p);
  if (all.parts.size() > 1) {
    const std::vector<Polygon> regions(all.parts.begin(), all.parts.end());
    const auto pairs = overlaps(regions);
    if (!pairs.empty()) {
      requireSimple(all, regions, pairs[0]);
      for (Part& part : all.parts)
        for (Ring& ring : part) orient(ring, &ring == part.data() ? 1 : -1);
      std::vector<Ring> rings = ringsOf(std::move(all.parts));
      const std::size_t crossings = addCrossings(rings, all.name);
      return {Polygon(rings, FillRule::NonZero), {}, {}, crossings};
    }
  }
  return {Polygon(ringsOf(std::move(all.parts)))};
}

}  // namespace

void requireOrigin(const GeoOptions& options) { requireFinite(options.origin, "options.origin"); }

GeoFeature featureOf(std::vector<Part> parts, const GeoOptions& options, const std::string& name) {
  Named all{std::move(parts), name};
  std::size_t rounded = 0;
  for (std::size_t p = 0; p < all.parts.size(); ++p)
    for (std::size_t r = 0; r < all.parts[p].size(); ++r) {
      Ring& ring = all.parts[p][r];
      openRing(ring, all.nameOf(p, r));
      if (options.origin != Vec2::Zero()) rounded += subtract(options.origin, ring, all.nameOf(p, r));
    }
  GeoFeature feature = join(std::move(all));
  feature.rounded_coordinates = rounded;
  return feature;
}

std::vector<Part> partsOf(const Polygon& polygon, const std::string& name, const std::string& format) {
  if (polygon.isComplement())
    refuse(name, "a complement is unbounded, which " + format + " can't say",
           "write its complement(), and take the complement() of what is read");
  // Those that make it invalid are found first.
  for (const SelfCrossing& crossing : selfCrossings(polygon, 1)) {
    if (crossing.kind == SelfCrossingKind::HoleOutside) continue;
    const bool has_crossing =
        crossing.kind == SelfCrossingKind::Crossing || crossing.kind == SelfCrossingKind::CrossingAtVertex;
    refuse(name, crossing.text + ", which " + format + " doesn't allow",
           has_crossing && polygon.fillRule() == FillRule::EvenOdd
               ? "divide the rings where they cross"
               : "write polygon.complement().complement(), which has the region's border alone");
  }
  const std::vector<Ring>& rings = polygon.rings();
  std::vector<Polygon> regions;
  std::vector<int> directions;
  for (const Ring& ring : rings) {
    regions.emplace_back(ring);
    directions.push_back(directionOf(ring));
  }
  // Rings that overlap are nested, for none crosses another.
  std::vector<std::vector<std::size_t>> around(rings.size());
  if (rings.size() > 1)
    for (const auto& [a, b] : overlaps(regions))
      isIn(regions[a], regions[b]) ? around[a].push_back(b) : around[b].push_back(a);
  enum class Is { Shell, Hole, Neither };
  const auto kindOf = [&](std::size_t ring) {
    if (polygon.fillRule() == FillRule::EvenOdd) return around[ring].size() % 2 == 0 ? Is::Shell : Is::Hole;
    int winding = 0;
    for (const std::size_t outer : around[ring]) winding += directions[outer];
    return winding == 0 ? Is::Shell : winding + directions[ring] == 0 ? Is::Hole : Is::Neither;
  };
  std::vector<Part> parts;
  std::map<std::size_t, std::size_t> part_of;  // by shell
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (kindOf(r) != Is::Shell) continue;
    part_of[r] = parts.size();
    parts.push_back({rings[r]});
    orient(parts.back()[0], 1);
  }
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (kindOf(r) != Is::Hole) continue;
    // The innermost shell around it.
    std::size_t shell = rings.size();
    for (const std::size_t outer : around[r])
      if (part_of.count(outer) != 0 && (shell == rings.size() || around[outer].size() > around[shell].size()))
        shell = outer;
    Part& part = parts[part_of.at(shell)];
    part.push_back(rings[r]);
    orient(part.back(), -1);
  }
  return parts;
}

void appendNumber(std::string& text, double number) {
  text += shortest(number);
  if (number == 0 && std::signbit(number)) text += ".0";  // an integer has no -0
}

}  // namespace tricover::detail
