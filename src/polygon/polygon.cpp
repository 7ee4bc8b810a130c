// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "numbers/double2.h"
#include "numbers/errors.h"
#include "numbers/power_of_two.h"
#include "numbers/predicates.h"
#include "numbers/rigidity.h"
#include "polygon/convexity.h"
#include "polygon/polygon_data.h"

namespace tricover {
namespace detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string nameOf(std::size_t ring) { return "rings: ring " + std::to_string(ring); }

/// Names the first vertex that isn't.
void refuseNotFinite(const RingsView& rings) {
  for (std::size_t r = 0; r < rings.size(); ++r)
    for (std::size_t i = 0; i < rings[r].size; ++i)
      if (!rings[r].vertices[i].allFinite()) refuseCoordinate(nameOf(r) + ", vertex " + std::to_string(i));
}

/// visit(v, w) for all vertices of a path, of which there are at least two, two by two; an odd one comes twice.
template <typename Visit>
void forEachTwo(const Path& path, Visit visit) {
  const Vec2 *at = path.begin(), *const last = path.end() - 2;
  for (; at < last; at += 2) visit(load2(at[0].data()), load2(at[1].data()));
  visit(load2(last[0].data()), load2(last[1].data()));
}

/// The extremes of all vertices.
struct Extremes {
  explicit Extremes(const Path& path) {
    low = Double2{kInfinity, kInfinity}, high = -low;
    Double2 size{}, total{};
    forEachTwo(path, [&](Double2 v, Double2 w) {
      low = smaller(smaller(v, w), low);
      high = larger(larger(v, w), high);
      const Double2 of_v = absolute(v), of_w = absolute(w);
      const Double2 sums = Double2{of_v[0], of_w[0]} + Double2{of_v[1], of_w[1]};
      size = larger(sums, size);
      total += sums;
    });
    extent = std::max(size[0], size[1]);
    are_plain = total[0] + total[1] < kInfinity;
  }

  Double2 low, high;
  double extent;   ///< the largest |x| + |y|
  bool are_plain;  ///< certainly finite
};

/// Never freed: no other object of the process can have its address.
struct alignas(16) IdBlock {
  const IdBlock* previous;  ///< keeps all blocks reachable for leak checkers
};
std::atomic<const IdBlock*> last_block{nullptr};

/// An id that no other polygon of the process has, whichever copy of this library makes that polygon. Several plugins
/// may each hold a copy, and a copy may be unloaded and loaded again: they share an address space, and nothing else. An
/// id is therefore the number of a block of memory (its address / 16), times 2^20, plus a count from 1. Blocks never
/// overlap and are never freed, thus ids are unique, and not only likely so. The price is 16 bytes for a million ids.
///
/// An id is never 0. After fork(), parent and child may give the same id to different polygons, as two processes may.
/// Addresses below 2^48 fit, which are all that operating systems give out unless a program requests higher ones.
std::uint64_t nextId() {
  constexpr std::uint64_t kBlock = std::uint64_t{1} << 20;
  static std::atomic<std::uint64_t> next{0};  // a multiple of kBlock: the block is used up
  std::uint64_t id = next.load(std::memory_order_relaxed);
  for (;;) {
    if (id % kBlock != 0) {
      if (next.compare_exchange_weak(id, id + 1, std::memory_order_relaxed)) return id;
      continue;
    }
    auto block = std::make_unique<IdBlock>();
    const std::uint64_t first = reinterpret_cast<std::uintptr_t>(block.get()) / sizeof(IdBlock) * kBlock + 1;
    if (!next.compare_exchange_strong(id, first + 1, std::memory_order_relaxed)) continue;
    block->previous = last_block.exchange(block.get(), std::memory_order_relaxed);
    block.release();
    return first;
  }
}

/// A bounding box whose size is brought near 1 by a power of two, so that areas and squares neither overflow nor
/// underflow.
struct Frame {
  explicit Frame(const Extremes& extremes) : low(extremes.low), high(extremes.high) {
    // Halved last, because half a denormal may be 0; first, where the difference overflows.
    const Double2 size = high - low;
    const double most = std::max(size[0], size[1]);
    center = low + (most < kInfinity ? 0.5 * size : 0.5 * high - 0.5 * low);
    // Beyond these the powers of two would leave the range of normal doubles, and nothing is as far from 1.
    const int exponent = most > 0 ? std::clamp(exponentOf(most) - 1, -1000, 1000) : 0;
    shrink = powerOfTwo(-exponent);
    grow = powerOfTwo(exponent);
  }
  Double2 low, high, center;
  double shrink, grow;
};

/// The centroid by the covering's signed areas; the box's centre where they cancel or it falls outside the box.
Double2 centroid(const PolygonData& polygon, const Frame& frame) {
  const Vec2* path = polygon.path.data();
  double area = 0, total = 0;
  Double2 moment{};
  for (std::size_t r = 0; r < polygon.ringCount(); ++r) {
    const std::size_t end = polygon.edgeEnd(r);
    Double2 v = (load2(path[polygon.edgeBegin(r)].data()) - frame.center) * frame.shrink;
    for (EdgePosition e = polygon.edgeBegin(r); e < end; ++e) {
      const Double2 w = (load2(path[e + 1].data()) - frame.center) * frame.shrink;
      const double twice = cross(v, w);
      area += twice;
      total += std::abs(twice);
      moment += twice * (v + w);
      v = w;
    }
  }
  if (std::abs(area) <= 1e-9 * total) return frame.center;
  const Double2 s = frame.center + moment / (3 * area) * frame.grow;
  return bitsOf(s >= frame.low) == 3 && bitsOf(s <= frame.high) == 3 ? s : frame.center;
}

double boundingRadius(const PolygonData& polygon, const Frame& frame) {
  const double x = polygon.origin.x(), y = polygon.origin.y();
  Double2 square{};
  forEachTwo(polygon.path, [&](Double2 v, Double2 w) {
    const Double2 dx = (Double2{v[0], w[0]} - x) * frame.shrink, dy = (Double2{v[1], w[1]} - y) * frame.shrink;
    square = larger(dx * dx + dy * dy, square);
  });
  // Each step up to here rounds by half an ulp or, scaled back, by half the smallest denormal.
  const double length = std::sqrt(std::max(square[0], square[1]));
  const double radius = length * (1 + 16 * kUnitRoundoff) * frame.grow;
  return radius < kInfinity ? nextAbove(radius) : radius;
}

/// A ring of three vertices of which two are equal is a segment there and back.
EdgePosition degenerateEdgeOf(const Path& path) {
  if (path.size() != 4) return kNoEdge;
  if (path[1] == path[2] || path[0] == path[2]) return 0;
  return path[0] == path[1] ? 1 : kNoEdge;
}

struct GivenRings : Derived::Thing {
  explicit GivenRings(const PolygonData& polygon) {
    all.reserve(polygon.ringCount());
    for (std::size_t r = 0; r < polygon.ringCount(); ++r) all.push_back(polygon.vertices(r));
  }
  explicit GivenRings(const RingsView& rings) {
    for (std::size_t r = 0; r < rings.size(); ++r)
      all.emplace_back(rings[r].vertices, rings[r].vertices + rings[r].size);
  }
  std::vector<Ring> all;
};

}  // namespace

PolygonData::PolygonData(const RingsView& rings_, std::size_t positions, const Fill& fill_, bool has_repeats_)
    : id(nextId()), fill(fill_), has_repeats(has_repeats_), path(positions, rings_.size()) {
  static_assert(offsetof(PolygonData, path) + sizeof(Path) == sizeof(PolygonData));
  const Extremes extremes(path);
  if (!extremes.are_plain) refuseNotFinite(rings_);
  degenerate_edge = fill.is_complement ? kNoEdge : degenerateEdgeOf(path);
  is_point = isDegenerate() && path[degenerate_edge] == path[degenerate_edge + 1];
  const Frame frame(extremes);
  store2(origin.data(), centroid(*this, frame));
  extent = std::max(extremes.extent, std::abs(origin.x()) + std::abs(origin.y()));
  radius = boundingRadius(*this, frame);
  reach = fill.is_complement ? kInfinity : radius;
  // Below and above these the powers of two themselves would leave the range of normal doubles.
  const int exponent = std::isfinite(radius) && radius > 0x1p-1000 ? std::min(exponentOf(radius) + 1, 1020)
                       : std::isfinite(radius)                     ? -1000
                                                                   : 1020;
  unit = powerOfTwo(exponent);
  inverse_unit = powerOfTwo(-exponent);
  if (has_repeats) rings.made<GivenRings>(rings_);
}

}  // namespace detail

namespace {

Ring ringOf(std::initializer_list<Polygon::Vertex> vertices) {
  Ring ring;
  for (const Polygon::Vertex& vertex : vertices) ring.push_back(vertex.at);
  return ring;
}

}  // namespace

Polygon::Polygon(const std::vector<Ring>& rings, FillRule fill)
    : data_(detail::PolygonData::make(detail::RingsView(rings), {fill})) {}

Polygon::Polygon(std::initializer_list<Vertex> ring, FillRule fill) : Polygon(ringOf(ring), fill) {}

Polygon::Polygon(const Vec2* vertices, std::size_t count, FillRule fill)
    : data_(detail::PolygonData::make(detail::RingsView({vertices, count}), {fill})) {}

Polygon::Polygon(const Polygon& other) noexcept : data_(other.data_) { data_->hold(); }

Polygon& Polygon::operator=(const Polygon& other) noexcept {
  other.data_->hold();
  data_->release();
  data_ = other.data_;
  return *this;
}

Polygon::~Polygon() { data_->release(); }

const std::vector<Ring>& Polygon::rings() const { return data_->rings.made<detail::GivenRings>(*data_).all; }
FillRule Polygon::fillRule() const { return data_->fill.rule; }
bool Polygon::isComplement() const { return data_->fill.is_complement; }
std::uint64_t Polygon::id() const { return data_->id; }
std::size_t Polygon::vertexCount() const { return data_->edgeCount(); }
const Vec2& Polygon::coveringOrigin() const { return data_->origin; }
double Polygon::radius() const { return data_->reach; }

Vec2 Polygon::edgeStart(EdgeIndex edge) const { return data_->path[data_->checkedEdgePosition(edge)]; }
Vec2 Polygon::edgeEnd(EdgeIndex edge) const {
  const detail::EdgePosition position = data_->checkedEdgePosition(edge);
  const bool is_repeat = data_->edgeNumber(position) != edge;
  return data_->path[is_repeat ? position : position + 1];
}

namespace {

/// Around a complement.
Eigen::AlignedBox2d wholePlane() { return {Vec2::Constant(-detail::kInfinity), Vec2::Constant(detail::kInfinity)}; }

}  // namespace

Eigen::AlignedBox2d Polygon::bounds() const {
  if (isComplement()) return wholePlane();
  Eigen::AlignedBox2d box;
  for (const Vec2& vertex : data_->path) box.extend(vertex);
  return box;
}

Eigen::AlignedBox2d Polygon::bounds(const Pose& pose) const {
  detail::requireRigid(pose, "pose");
  if (isComplement()) return wholePlane();
  Eigen::AlignedBox2d box;
  for (const Vec2& vertex : data_->path) box.extend(Vec2(pose * vertex));
  // Two products and two sums of coordinates.
  const double error = 4 * detail::kUnitRoundoff * (data_->extent + pose.translation().lpNorm<1>()) + detail::kTiny;
  return {box.min() - Vec2::Constant(error), box.max() + Vec2::Constant(error)};
}

template <typename Map>
Polygon Polygon::mapped(const Map& map) const {
  std::vector<Ring> rings;
  rings.reserve(data_->ringCount());
  for (std::size_t r = 0; r < data_->ringCount(); ++r)
    for (Vec2& vertex : rings.emplace_back(data_->has_repeats ? this->rings()[r] : data_->vertices(r)))
      vertex = map(vertex);
  return withRings(rings);
}

Polygon Polygon::withRings(const std::vector<Ring>& rings) const {
  return {Adopt::Data, detail::PolygonData::make(detail::RingsView(rings), data_->fill)};
}

Polygon Polygon::translated(const Vec2& by) const {
  detail::requireFinite(by, "by");
  return mapped([&](const Vec2& vertex) { return Vec2(vertex + by); });
}

Polygon Polygon::transformed(const Pose& pose) const {
  detail::requireRigid(pose, "pose");
  return mapped([&](const Vec2& vertex) { return Vec2(pose * vertex); });
}

Polygon Polygon::scaled(double factor) const {
  if (!(factor > 0 && std::isfinite(factor))) detail::refuse("factor", "it must be finite and positive");
  return mapped([&](const Vec2& vertex) { return Vec2(factor * vertex); });
}

Polygon Polygon::point(const Vec2& p) {
  detail::requireFinite(p, "p");
  return segment(p, p);
}

Polygon Polygon::segment(const Vec2& p, const Vec2& q) {
  detail::requireFinite(p, "p");
  detail::requireFinite(q, "q");
  const Vec2 ring[] = {p, q, q};
  return Polygon(ring, 3);
}

Polygon Polygon::box(double width, double height) {
  for (const auto& [length, field] : {std::pair(width, "width"), std::pair(height, "height")})
    if (!(length > 0 && std::isfinite(length))) detail::refuse(field, "it must be finite and positive");
  const double x = 0.5 * width, y = 0.5 * height;
  const Vec2 ring[] = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
  return Polygon(ring, 4);
}

bool Polygon::isConvex() const { return detail::cornersOf(*data_) != nullptr; }

}  // namespace tricover
