// SPDX-License-Identifier: BSD-3-Clause
#include "hierarchy/inclusion.h"

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "hierarchy/simd.h"

namespace tricover::detail {
namespace {

bool hasManyRings(const PolygonData& polygon) { return polygon.ringCount() >= 16; }

/// What the ray leads away from. Many rings may stand in rows with S among them, where each ring's ray away from S
/// would meet all those behind it: theirs lead out aslant.
Vec2 behindRay(const PolygonData& polygon, const Vec2& p) {
  if (!hasManyRings(polygon)) return polygon.origin;
  const Vec2 away = polygon.inUnits(p), way = away + 0.31 * Vec2(-away.y(), away.x());
  const Vec2 behind = p - way * (polygon.unit / way.norm());
  return behind.allFinite() ? behind : polygon.origin;
}

bool addEdge(void* sum, std::uint32_t edge) { return static_cast<CoveringSum*>(sum)->add(edge); }

/// What a point in units errs by in either coordinate: what the point itself does, and three roundings of what is below
/// 2.
double errorInUnits(const PolygonData& polygon, const ApproxPoint& p) {
  return p.error * polygon.inverse_unit + 0x1p-50;
}

CoveringSum sumAlongRay(const PolygonData& polygon, const IncludedPoint& point) {
  return {polygon, point, behindRay(polygon, {point.approx.x, point.approx.y})};
}

/// A triangle (s, v, w) holds the point only if the ray from the point away from s meets (v, w). Nothing if rounding
/// hides where that ray goes.
std::optional<Ray> rayOf(const CoveringSum& sum) {
  const PolygonData& polygon = sum.polygon();
  const ApproxPoint& p = sum.point().approx;
  const Vec2 at = polygon.inUnits({p.x, p.y}), away = at - polygon.inUnits(sum.origin());
  const double distance = away.norm(), error = errorInUnits(polygon, p);
  if (!(distance > 0x1p-10 && error < 0x1p-20 && polygon.fitsUnit())) return std::nullopt;
  // The direction turns by at most 4 error / distance, and nothing is farther away than 4.
  return Ray{at.x(), at.y(), away.x() / distance, away.y() / distance, error * (2 + 16 / distance)};
}

Inclusion includeByRay(const PolygonData& polygon, const Hierarchy& hierarchy, const IncludedPoint& point) {
  CoveringSum sum = sumAlongRay(polygon, point);
  if (const std::optional<Ray> ray = rayOf(sum))
    visitEdgesOnRay(hierarchy, *ray, addEdge, &sum);
  else
    sum.addAll();
  return sum.result();
}

/// By the rings whose boxes may hold the point; nothing where that doesn't tell.
std::optional<Inclusion> includeAround(const PolygonData& polygon, const Hierarchy& hierarchy,
                                       const IncludedPoint& point) {
  CoveringSum sum = sumAlongRay(polygon, point);
  const std::optional<Ray> ray = rayOf(sum);
  if (!ray || !visitEdgesAround(hierarchy, *ray, addEdge, &sum)) return std::nullopt;
  return sum.result();
}

/// From a point to a known place. With p the point, s the place and t from 0 to 1, p + t (s - p) errs by no more than p
/// and s do, in any direction 1.5 times that; and the way's direction and length by 4U of what is below 4.
Ray wayTo(const Vec2& place, const PolygonData& polygon, const ApproxPoint& p) {
  constexpr double kShort = 0x1p-100;  // a way that needs no direction
  const Vec2 at = polygon.inUnits({p.x, p.y}), way = polygon.inUnits(place) - at;
  const double length = way.norm(), error = 1.5 * errorInUnits(polygon, p) + 0x1p-48;
  const Vec2 direction = length > kShort ? Vec2(way / length) : Vec2(1, 0);
  return {at.x(), at.y(), direction.x(), direction.y(), error, length};
}

Inclusion includeFrom(const KnownPlace& from, const PolygonData& polygon, const Hierarchy& hierarchy,
                      const IncludedPoint& point) {
  CoveringSum sum(polygon, point, from);
  visitEdgesOnRay(hierarchy, wayTo(from.at, polygon, point.approx), addEdge, &sum);
  return sum.result();
}

/// A place for each block of a hierarchy, near its origin, in the middle of its boxes.
class KnownPlaces : public Derived::Thing {
 public:
  /// Each by the edges between it and that of the block above.
  KnownPlaces(const PolygonData& polygon, const Hierarchy& hierarchy)
      : polygon_(polygon), hierarchy_(hierarchy), winding_(hierarchy.blocks.size(), kUnknown) {
    find(0, nullptr);
    for (std::uint32_t k = 0; k < hierarchy.blocks.size(); ++k) {
      const Block& block = hierarchy.blocks[k];
      if (block.leaf) continue;
      const std::optional<KnownPlace> above = ofBlock(k);
      for (int i = 0; i < block.count; ++i) find(block.child[i], above ? &*above : nullptr);
    }
  }

  /// Nothing where the place is on an edge.
  std::optional<KnownPlace> ofBlock(std::uint32_t block) const {
    if (winding_[block] == kUnknown) return std::nullopt;
    return KnownPlace{placeIn(hierarchy_.blocks[block]), winding_[block]};
  }

 private:
  static constexpr int kUnknown = std::numeric_limits<int>::min();

  /// Beside the middle, where edges of regular outlines are.
  Vec2 placeIn(const Block& block) const {
    const double scale = block.scale;
    return polygon_.origin + Vec2(block.origin_x + 0.0137 * scale, block.origin_y + 0.0291 * scale) * polygon_.unit;
  }

  void find(std::uint32_t block, const KnownPlace* from) {
    const Vec2 place = placeIn(hierarchy_.blocks[block]);
    if (!place.allFinite()) return;
    const IncludedPoint point = IncludedPoint::ofFrame(place);
    const Inclusion found =
        from != nullptr ? includeFrom(*from, polygon_, hierarchy_, point) : includeByRay(polygon_, hierarchy_, point);
    if (found.location != Location::Boundary) winding_[block] = found.winding;
  }

  const PolygonData& polygon_;
  const Hierarchy& hierarchy_;
  std::vector<int> winding_;
};

const KnownPlaces& placesOf(const PolygonData& polygon, const Hierarchy& hierarchy) {
  return *static_cast<const KnownPlaces*>(
      hierarchy.places.built([&] { return std::make_unique<const KnownPlaces>(polygon, hierarchy); }));
}

/// Those of many rings, once rays across them have paid for them; until then null.
const KnownPlaces* placesIfPaid(const PolygonData& polygon, const Hierarchy& hierarchy) {
  if (!hasManyRings(polygon) || !polygon.fitsUnit()) return nullptr;
  if (const Derived::Thing* ready = hierarchy.places.ifBuilt()) return static_cast<const KnownPlaces*>(ready);
  const std::size_t edges = polygon.path.size();
  const auto across = static_cast<std::size_t>(std::sqrt(static_cast<double>(edges)));
  return hierarchy.places_rent.isDue(across, 12 * edges) ? &placesOf(polygon, hierarchy) : nullptr;
}

/// By the edges on the way from the known place near a point, once there is one.
class NearPlace {
 public:
  NearPlace(const KnownPlaces& places, const PolygonData& polygon, const IncludedPoint& point)
      : places_(places), polygon_(polygon), point_(point) {}

  /// Nothing where none is known.
  std::optional<Inclusion> include(const Hierarchy& hierarchy) {
    const ApproxPoint& p = point_.approx;
    const Vec2 at = polygon_.inUnits({p.x, p.y});
    visitEdgesToPlace(hierarchy, {at.x(), at.y(), errorInUnits(polygon_, p)}, {this, begin, add});
    return sum_ ? std::optional<Inclusion>(sum_->result()) : std::nullopt;
  }

 private:
  static bool begin(void* context, std::uint32_t block, Ray& way) {
    NearPlace& search = *static_cast<NearPlace*>(context);
    const std::optional<KnownPlace> place = search.places_.ofBlock(block);
    if (!place) return false;
    search.sum_.emplace(search.polygon_, search.point_, *place);
    way = wayTo(place->at, search.polygon_, search.point_.approx);
    return true;
  }
  static bool add(void* context, std::uint32_t edge) { return static_cast<NearPlace*>(context)->sum_->add(edge); }

  const KnownPlaces& places_;
  const PolygonData& polygon_;
  const IncludedPoint& point_;
  std::optional<CoveringSum> sum_;
};

/// Null, too, where rounding hides what is near.
const KnownPlaces* placesFor(const PolygonData& polygon, const Hierarchy& hierarchy, const ApproxPoint& p) {
  return errorInUnits(polygon, p) < 0x1p-20 ? placesIfPaid(polygon, hierarchy) : nullptr;
}

/// What bounding discs leave open; not inlined, because most points are far away.
[[gnu::noinline]] Inclusion includeByHierarchy(const PolygonData& polygon, const Hierarchy& hierarchy,
                                               const IncludedPoint& point) {
  if (hasManyRings(polygon))
    if (const std::optional<Inclusion> around = includeAround(polygon, hierarchy, point)) return *around;
  const KnownPlaces* places = placesFor(polygon, hierarchy, point.approx);
  const auto near = places != nullptr ? NearPlace(*places, polygon, point).include(hierarchy) : std::nullopt;
  return near ? *near : includeByRay(polygon, hierarchy, point);
}

}  // namespace

Inclusion includeInPolygon(const PolygonData& polygon, const IncludedPoint& point) {
  if (outsideBoundingDisc(polygon, point.approx)) return {Location::Outside, 0};
  const Hierarchy* hierarchy = hierarchyIfBuilt(polygon);
  return hierarchy != nullptr ? includeByHierarchy(polygon, *hierarchy, point) : includeInCovering(polygon, point);
}

void buildPlaces(const PolygonData& polygon) {
  if (hasManyRings(polygon) && polygon.fitsUnit()) placesOf(polygon, hierarchyOf(polygon));
}

}  // namespace tricover::detail
