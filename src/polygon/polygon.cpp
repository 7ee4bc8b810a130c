// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "numbers/errors.h"
#include "numbers/predicates.h"
#include "polygon/polygon_data.h"

namespace tricover {
namespace detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void validate(const std::vector<Ring>& rings) {
  if (rings.empty()) refuse("rings", "a polygon needs at least one ring");
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const std::string ring = "rings: ring " + std::to_string(r);
    if (rings[r].size() < 3)
      refuse(ring, "it has " + std::to_string(rings[r].size()) + " vertices",
             "it needs at least 3, which may be equal ones");
    for (std::size_t i = 0; i < rings[r].size(); ++i)
      if (!rings[r][i].allFinite()) refuseCoordinate(ring + ", vertex " + std::to_string(i));
  }
}

std::uint64_t nextId() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

/// 2^exponent as two factors, either of them finite where the power itself would overflow or underflow.
struct PowerOfTwo {
  explicit PowerOfTwo(int exponent)
      : first(std::ldexp(1, exponent / 2)), second(std::ldexp(1, exponent - exponent / 2)) {}
  template <typename T>
  T operator()(const T& x) const {
    return x * first * second;
  }
  double first, second;
};

/// A bounding box whose size is brought near 1 by a power of two, so that areas and squares neither overflow nor
/// underflow.
struct Frame {
  explicit Frame(const std::vector<Vec2>& path) : low(path[0]), high(path[0]), center(path[0]), exponent(0) {
    for (const Vec2& p : path) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    // Halved last, because half a denormal may be 0; first, where the difference overflows.
    const Vec2 size = high - low;
    center = low + (size.allFinite() ? Vec2(0.5 * size) : Vec2(0.5 * high - 0.5 * low));
    if (size.maxCoeff() > 0) exponent = std::min(std::ilogb(size.maxCoeff()) - 1, 1023);
  }
  Vec2 low, high, center;
  int exponent;
};

/// The centroid by the covering's signed areas; the box's centre where they cancel or it falls outside the box.
Vec2 centroid(const PolygonData& polygon, const Frame& frame) {
  const PowerOfTwo shrink(-frame.exponent), grow(frame.exponent);
  double area = 0, total = 0;
  Vec2 moment = Vec2::Zero();
  for (std::size_t r = 0; r < polygon.ringCount(); ++r) {
    Vec2 v = shrink(Vec2(polygon.path[polygon.edgeBegin(r)] - frame.center));
    for (std::size_t e = polygon.edgeBegin(r); e < polygon.edgeEnd(r); ++e) {
      const Vec2 w = shrink(Vec2(polygon.path[e + 1] - frame.center));
      const double twice = v.x() * w.y() - v.y() * w.x();
      area += twice;
      total += std::abs(twice);
      moment += twice * (v + w);
      v = w;
    }
  }
  if (std::abs(area) <= 1e-9 * total) return frame.center;
  const Vec2 s = frame.center + grow(Vec2(moment / (3 * area)));
  const bool inside = (s.array() >= frame.low.array()).all() && (s.array() <= frame.high.array()).all();
  return inside ? s : frame.center;
}

double boundingRadius(const PolygonData& polygon, const Frame& frame) {
  const PowerOfTwo shrink(-frame.exponent), grow(frame.exponent);
  double square = 0;
  for (const Vec2& p : polygon.path) square = std::max(square, shrink(Vec2(p - polygon.origin)).squaredNorm());
  // Each step up to here rounds by half an ulp or, scaled back, by half the smallest denormal.
  return std::nextafter(grow(std::sqrt(square) * (1 + 16 * kUnitRoundoff)), kInfinity);
}

/// A ring of three vertices of which two are equal is a segment there and back.
std::size_t degenerateEdgeOf(const std::vector<Ring>& rings) {
  if (rings.size() != 1 || rings[0].size() != 3) return PolygonData::kNotDegenerate;
  const Ring& ring = rings[0];
  if (ring[1] == ring[2] || ring[0] == ring[2]) return 0;
  return ring[0] == ring[1] ? 1 : PolygonData::kNotDegenerate;
}

}  // namespace

void requireCapacity(std::size_t positions) {
  if (positions > kMostPositions)
    refuse("rings", "more than 2^29 vertices, one more counted for each ring", "divide the polygon");
}

PolygonData::PolygonData(std::vector<Ring> rings_, FillRule fill_) : fill(fill_), rings(std::move(rings_)) {
  validate(rings);
  id = nextId();
  std::size_t total = 0;
  for (const Ring& ring : rings) total += ring.size() + 1;
  requireCapacity(total);
  path.reserve(total);
  ring_begin.reserve(rings.size() + 1);
  extent = 0;
  for (const Ring& ring : rings) {
    ring_begin.push_back(path.size());
    path.insert(path.end(), ring.begin(), ring.end());
    path.push_back(ring.front());
    for (const Vec2& p : ring) extent = std::max(extent, std::abs(p.x()) + std::abs(p.y()));
  }
  ring_begin.push_back(path.size());
  degenerate_edge = degenerateEdgeOf(rings);
  is_point = isDegenerate() && path[degenerate_edge] == path[degenerate_edge + 1];
  const Frame frame(path);
  origin = centroid(*this, frame);
  extent = std::max(extent, std::abs(origin.x()) + std::abs(origin.y()));
  radius = boundingRadius(*this, frame);
  // Below and above these the powers of two themselves would leave the range of normal doubles.
  const int exponent = std::isfinite(radius) && radius > 0x1p-1000 ? std::min(std::ilogb(radius) + 1, 1020)
                       : std::isfinite(radius)                     ? -1000
                                                                   : 1020;
  unit = std::ldexp(1, exponent);
  inverse_unit = std::ldexp(1, -exponent);
}

std::size_t PolygonData::edgeNumberOfRings(std::size_t position) const {
  const auto next = std::upper_bound(ring_begin.begin(), ring_begin.end(), position);
  return position - static_cast<std::size_t>(next - ring_begin.begin() - 1);
}

std::size_t PolygonData::edgePosition(std::size_t number) const {
  std::size_t low = 0, high = ringCount();
  while (high - low > 1) {
    const std::size_t mid = (low + high) / 2;
    (ring_begin[mid] - mid <= number ? low : high) = mid;
  }
  return number + low;
}

std::size_t PolygonData::checkedEdgePosition(EdgeIndex number) const {
  const std::size_t count = path.size() - ringCount();
  if (number < 0) throw std::out_of_range(refusal("edge", std::to_string(number) + " is no edge"));
  if (static_cast<std::size_t>(number) >= count)
    throw std::out_of_range(
        refusal("edge", std::to_string(number) + " is beyond the last one, " + std::to_string(count - 1)));
  return edgePosition(static_cast<std::size_t>(number));
}

}  // namespace detail

Polygon::Polygon(std::vector<Ring> rings, FillRule fill)
    : data_(std::make_shared<const detail::PolygonData>(std::move(rings), fill)) {}

const std::vector<Ring>& Polygon::rings() const { return data_->rings; }
FillRule Polygon::fillRule() const { return data_->fill; }
std::uint64_t Polygon::id() const { return data_->id; }
std::size_t Polygon::vertexCount() const { return data_->path.size() - data_->ringCount(); }
const Vec2& Polygon::origin() const { return data_->origin; }
double Polygon::radius() const { return data_->radius; }

Vec2 Polygon::edgeStart(EdgeIndex edge) const { return data_->path[data_->checkedEdgePosition(edge)]; }
Vec2 Polygon::edgeEnd(EdgeIndex edge) const { return data_->path[data_->checkedEdgePosition(edge) + 1]; }

}  // namespace tricover
