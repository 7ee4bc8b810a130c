// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "numbers/errors.h"
#include "paper/influence_area.h"
#include "polygon/polygon_data.h"
#include "tricover/paper.h"

namespace tricover {
namespace detail {
namespace {

/// Whether p may be at most `length` away from the line along u through 0. Beside the area's bound: 4 roundings.
bool inStrip(double ux, double uy, const ApproxPoint& p, double length) {
  const ApproxArea area = approxArea({0, 0, 0}, {ux, uy, 0}, p);
  return !(std::abs(area.area) > area.bound + length * std::sqrt(ux * ux + uy * uy) * (1 + 8 * kUnitRoundoff));
}

}  // namespace

bool inExtendedArea(const Vec2& v, const Vec2& w, const ApproxPoint& p, double length) {
  const double ux = w.x() - v.x(), uy = w.y() - v.y(), wx = p.x - v.x(), wy = p.y - v.y();
  const double size = std::max(std::abs(ux), std::abs(uy)), far = std::max(std::abs(wx), std::abs(wy));
  if (size > 0x1p-400 && size < 0x1p400 && far < 0x1p400) return inStrip(ux, uy, {wx, wy, p.error}, length);
  if (size == 0) return std::abs(wy) * (1 - 4 * kUnitRoundoff) <= length + p.error;  // no direction: taken as level
  if (far <= length || !std::isfinite(size) || !std::isfinite(far)) return true;
  // u and w are brought near 1, each by a power of two; the length is below w.
  const int exponent_u = -std::ilogb(size), exponent_w = -std::ilogb(far);
  return inStrip(std::scalbn(ux, exponent_u), std::scalbn(uy, exponent_u),
                 {std::scalbn(wx, exponent_w), std::scalbn(wy, exponent_w), std::scalbn(p.error, exponent_w) + kTiny},
                 std::scalbn(length, exponent_w));
}

bool inBoundedArea(const Vec2& v, const Vec2& w, const ApproxPoint& p, double length) {
  const bool level = std::abs(w.y() - v.y()) <= std::abs(w.x() - v.x());
  const double from = level ? v.x() : v.y(), to = level ? w.x() : w.y(), at = level ? p.x : p.y;
  const double beyond = std::max(at - std::max(from, to), std::min(from, to) - at);
  if (beyond * (1 - 4 * kUnitRoundoff) > length + p.error) return false;
  return inExtendedArea(v, w, p, length);
}

}  // namespace detail

namespace paper {
namespace {

void check(const Vec2& point, double length) {
  detail::requireFinite(point, "point");
  detail::requireNotNegative(length, "length");
}

}  // namespace

std::vector<CoveringTriangle> covering(const Polygon& polygon) {
  std::vector<CoveringTriangle> triangles;
  triangles.reserve(polygon.vertexCount());
  for (EdgeIndex edge = 0; edge < polygon.edgeCount(); ++edge) {
    const Vec2 v = polygon.edgeStart(edge), w = polygon.edgeEnd(edge), s = polygon.coveringOrigin();
    triangles.push_back({s, v, w, detail::orientation(s, v, w)});
  }
  return triangles;
}

bool inInfluenceArea(const Polygon& polygon, EdgeIndex edge, const Vec2& point, double length, InfluenceKind kind) {
  check(point, length);
  const Vec2 v = polygon.edgeStart(edge), w = polygon.edgeEnd(edge);
  const detail::ApproxPoint p{point.x(), point.y(), 0};
  switch (kind) {
    case InfluenceKind::OneSided:
      return detail::orientation(v, w, point) <= 0 && detail::inExtendedArea(v, w, p, length);
    case InfluenceKind::Extended:
      return detail::inExtendedArea(v, w, p, length);
    case InfluenceKind::Bounded:
      return detail::inBoundedArea(v, w, p, length);
  }
  detail::refuse("kind", "not an InfluenceKind");
}

std::vector<std::uint64_t> influenceMask(const Polygon& polygon, const Vec2& point, double length) {
  check(point, length);
  std::vector<std::uint64_t> mask((polygon.vertexCount() + 63) / 64, 0);
  const detail::ApproxPoint p{point.x(), point.y(), 0};
  for (std::size_t number = 0; number < polygon.vertexCount(); ++number) {
    const auto edge = static_cast<EdgeIndex>(number);
    if (detail::inBoundedArea(polygon.edgeStart(edge), polygon.edgeEnd(edge), p, length))
      mask[number / 64] |= std::uint64_t{1} << number % 64;
  }
  return mask;
}

std::array<Vec2, 4> boundedInfluenceArea(const Polygon& polygon, EdgeIndex edge, double length) {
  check(Vec2::Zero(), length);
  const Vec2 v = polygon.edgeStart(edge), w = polygon.edgeEnd(edge), u = w - v;
  const int main = std::abs(u.y()) <= std::abs(u.x()) ? 0 : 1, other = 1 - main;
  const double slope = u[main] != 0 ? u[other] / u[main] : 0;
  const double half_width = length * std::sqrt(1 + slope * slope);  // of the strip, measured along `other`
  const double low = std::min(v[main], w[main]) - length, high = std::max(v[main], w[main]) + length;
  const auto corner = [&](double at, double side) {
    Vec2 result;
    result[main] = at;
    result[other] = v[other] + (at - v[main]) * slope + side * half_width;
    return result;
  };
  return {corner(low, -1), corner(high, -1), corner(high, 1), corner(low, 1)};
}

}  // namespace paper
}  // namespace tricover
