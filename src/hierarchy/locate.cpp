// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/locate.h"

#include <algorithm>

#include "hierarchy/hierarchy.h"
#include "hierarchy/inclusion.h"
#include "numbers/errors.h"

namespace tricover {
namespace {

void checkPoint(const Vec2& point) {
  if (!point.allFinite()) detail::refuse("point", "a coordinate is not finite");
}

Location locateUnchecked(const detail::PolygonData& polygon, const Vec2& point) {
  return detail::locateInPolygon(polygon, detail::IncludedPoint::ofFrame(point));
}

}  // namespace

Location locate(const Polygon& polygon, const Vec2& point) {
  checkPoint(point);
  // A scan costs a twentieth of a hierarchy: the first few points are no reason to build one.
  constexpr unsigned kScans = 16;
  const detail::PolygonData& data = polygon.data();
  if (detail::hierarchyIfBuilt(data) == nullptr && data.scans.fetch_add(1, std::memory_order_relaxed) >= kScans)
    detail::hierarchyOf(data);
  return locateUnchecked(data, point);
}

Location locate(const Polygon& polygon, const Vec2& point, PointCache& cache) {
  checkPoint(point);
  const detail::PolygonData& data = polygon.data();
  constexpr std::size_t kPerWord = 32;
  const std::size_t words = (data.path.size() + kPerWord - 1) / kPerWord;
  bool same_zone = cache.polygon_id == data.id && cache.signs.size() == words;
  if (!same_zone) cache.signs.assign(words, 0);

  // Every edge's sign, -1, 0 or 1, as two bits: the point's zone. The location is constant on an open face of the
  // lines' arrangement, but on a line it may change where no other line crosses (at a spike's tip), so a sign of 0 says
  // nothing. An edge of one repeated vertex has no line: it is 0 at that vertex only. The closing vertices between
  // rings form no edge; their lines divide zones no less soundly.
  for (std::size_t word = 0; word < words; ++word) {
    std::uint64_t bits = 0;
    const std::size_t end = std::min((word + 1) * kPerWord, data.path.size() - 1);
    for (std::size_t e = word * kPerWord; e < end; ++e) {
      const Vec2 &v = data.path[e], &w = data.path[e + 1];
      const int sign = v == w ? (point == v ? 0 : 1) : detail::orientation(v, w, point);
      same_zone = same_zone && sign != 0;
      bits |= static_cast<std::uint64_t>(sign + 1) << 2 * (e % kPerWord);
    }
    same_zone = same_zone && bits == cache.signs[word];
    cache.signs[word] = bits;
  }
  if (!same_zone) {
    cache.location = locateUnchecked(data, point);
    cache.polygon_id = data.id;
  }
  return cache.location;
}

}  // namespace tricover
