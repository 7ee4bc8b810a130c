// SPDX-License-Identifier: BSD-3-Clause
// Counts what each kind of query makes tricover build from fresh polygons: what isn't used isn't paid for.
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "measure.h"
#include "report.h"
#include "scenes/placed.h"
#include "tricover/tricover.h"
#include "workloads.h"

namespace {

/// The bytes that operator new handed out and didn't get back, with what malloc rounds them up to.
std::size_t heap_bytes = 0;

void* counted(void* block) {
  if (block == nullptr) throw std::bad_alloc();
  heap_bytes += malloc_usable_size(block);
  return block;
}

void release(void* block) {
  heap_bytes -= malloc_usable_size(block);
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return counted(std::malloc(size)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(aligned_alloc(static_cast<std::size_t>(alignment), size));
}
void operator delete(void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { release(block); }

namespace tricover::bench {
namespace {

/// A kind of bodies, two of each: what they are made of, and how far a margin grows them.
struct Shape {
  const char* name;
  std::vector<Ring> fixed, moving;
  FillRule fill;
  double margin;
};

std::vector<Shape> shapes() {
  using workloads::Kind;
  const auto made = [](const char* name, Kind kind, std::size_t n) {
    return Shape{name, workloads::makePolygon(kind, n, 1).rings(), workloads::makePolygon(kind, n, 2).rings(),
                 FillRule::EvenOdd, 0};
  };
  const auto soup = [](std::uint64_t seed) { return workloads::makeOverlapping(64, 3, 1, seed).rings(); };
  const std::vector<Ring> disc = Polygon::point(Vec2::Zero()).rings();
  return {{"disc", disc, disc, FillRule::EvenOdd, 50}, made("convex, 64", Kind::Slim, 64),
          made("outline, 8", Kind::Contour, 8),        made("outline, 64", Kind::Contour, 64),
          made("outline, 512", Kind::Contour, 512),    {"64 triangles", soup(1), soup(2), FillRule::NonZero, 0}};
}

/// Two fresh polygons and what their users keep about them.
struct Pair {
  Polygon fixed, moving;
  double margin;  ///< of each
  PairCache cache;
  std::optional<Scene> scene;

  double radius() const { return fixed.radius() + margin; }
};

struct Query {
  const char* name;
  bool answer;
  bool (*ask)(Pair& pair);
  bool of_discs = true;
};

Pose at(const Vec2& position) { return poseAt(position, 0); }

const Pose kIdentity = Pose::Identity();

/// Out of the bounding discs' reach; where the polygons' discs overlap and they, twice as long as high, don't (of
/// discs: where their boxes overlap and they don't); and upon it.
Pose far(const Pair& pair) { return at({4 * pair.radius(), 0}); }
Pose near(const Pair& pair) {
  return pair.margin > 0 ? at(Vec2::Constant(1.5 * pair.margin)) : at({0, 1.3 * pair.radius()});
}
Pose upon(const Pair& pair) { return at({pair.radius() / 2, 0}); }

template <Pose (*Where)(const Pair&), bool Cached = false>
bool askCollide(Pair& pair) {
  const CollideOptions options{2 * pair.margin, 0};
  return Cached ? collide(pair.fixed, kIdentity, pair.moving, Where(pair), pair.cache, options)
                : collide(pair.fixed, kIdentity, pair.moving, Where(pair), options);
}

template <Pose (*Where)(const Pair&), bool Cached = false>
bool askDistance(Pair& pair) {
  const DistanceOptions options{2 * pair.margin};
  return (Cached ? distance(pair.fixed, kIdentity, pair.moving, Where(pair), pair.cache, options)
                 : distance(pair.fixed, kIdentity, pair.moving, Where(pair), options))
             .distance > 0;
}

/// From near, or far, to there.
template <Pose (*From)(const Pair&), Pose (*To)(const Pair&)>
bool askImpact(Pair& pair) {
  const Pose start = From(pair);
  const Motion motion = Motion::translation(start, To(pair).translation() - start.translation());
  return timeOfImpact(pair.fixed, {}, pair.moving, motion, {2 * pair.margin}).has_value();
}

template <Pose (*Where)(const Pair&)>
bool askContacts(Pair& pair) {
  return !contacts(pair.fixed, kIdentity, pair.moving, Where(pair)).empty();
}

/// The first time adds both.
template <Pose (*Where)(const Pair&)>
bool askScene(Pair& pair) {
  if (!pair.scene) {
    pair.scene.emplace();
    pair.scene->add(pair.fixed, kIdentity, {pair.margin});
    pair.scene->add(pair.moving, Where(pair), {pair.margin});
  }
  return !pair.scene->collisions().empty();
}

bool askRay(Pair& pair, double height) {
  const double radius = pair.radius();
  return castRay(pair.fixed, kIdentity, {-2 * radius, height * radius}, {2 * radius, height * radius}).has_value();
}

const Query kQueries[] = {
    {"collide, discs apart", false, askCollide<far>},
    {"collide, near", false, askCollide<near>},
    {"collide, overlapping", true, askCollide<upon>},
    {"collide, near, PairCache", false, askCollide<near, true>},
    {"paper::collide, near", false,
     [](Pair& pair) { return paper::collide(pair.fixed, kIdentity, pair.moving, near(pair), {2 * pair.margin}); },
     false},
    {"distance, discs apart", true, askDistance<far>},
    {"distance, near", true, askDistance<near>},
    {"distance, near, PairCache", true, askDistance<near, true>},
    {"distance, overlapping", false, askDistance<upon>},
    {"time of impact, passes by", false, askImpact<far, far>},
    {"time of impact, hits", true, askImpact<near, upon>},
    {"contacts, discs apart", false, askContacts<far>, false},
    {"contacts, overlapping", true, askContacts<upon>, false},
    {"penetration, discs apart", false,
     [](Pair& pair) { return penetration(pair.fixed, kIdentity, pair.moving, far(pair)).has_value(); }, false},
    {"penetration, overlapping", true,
     [](Pair& pair) { return penetration(pair.fixed, kIdentity, pair.moving, upon(pair)).has_value(); }, false},
    {"castRay, misses the disc", false, [](Pair& pair) { return askRay(pair, 1.5); }, false},
    {"castRay, hits", true, [](Pair& pair) { return askRay(pair, 0); }, false},
    {"locate, outside", false,
     [](Pair& pair) { return locate(pair.fixed, 3 * far(pair).translation()) != Location::Outside; }, false},
    {"locate, inside", true,
     [](Pair& pair) { return locate(pair.fixed, pair.fixed.coveringOrigin()) != Location::Outside; }, false},
    {"Scene: added, boxes apart", false, askScene<far>},
    {"Scene: added, near", false, askScene<near>},
    {"Scene: added, overlapping", true, askScene<upon>},
};

/// The time of one call of `work`.
template <class Work>
double nanoseconds(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

/// A first query on fresh polygons: what it leaves on the heap, what it takes beyond its successors, and what they
/// take.
struct Cost {
  std::size_t bytes;
  double extra_ns, warm_ns;
};

Cost costOf(const Shape& shape, const Query& query) {
  constexpr std::size_t kMostPairs = 101, kFewestPairs = 5;
  constexpr double kNanoseconds = 4e7, kWarm = 2e5;  // for a cell, and for the later queries about one pair
  std::vector<double> extra, warm;
  std::size_t bytes = 0;
  double taken = 0;
  while (extra.size() < kFewestPairs || (extra.size() < kMostPairs && taken < kNanoseconds)) {
    Pair pair{Polygon(shape.fixed, shape.fill), Polygon(shape.moving, shape.fill), shape.margin, {}, {}};
    bool right = true;
    const auto ask = [&] { right = query.ask(pair) == query.answer && right; };
    const std::size_t before = heap_bytes;
    const double first = nanoseconds(ask);
    bytes = heap_bytes - before;
    // One by one, so that the clock's own time cancels.
    std::vector<double> later;
    while (later.size() < (first < kWarm ? 20 : 3)) later.push_back(nanoseconds(ask));
    const int repeated = static_cast<int>(std::min(100.0, 1 + kWarm / medianOf(later)));
    const double all = nanoseconds([&] {
      for (int k = 0; k < repeated; ++k) ask();
    });
    extra.push_back(first - medianOf(later));
    warm.push_back(all / repeated);
    taken += first + all;
    if (!right) throw std::logic_error("modelled: wrong: " + std::string(query.name) + ", " + shape.name);
  }
  return {bytes, medianOf(extra), medianOf(warm)};
}

/// The polygon itself, before any query.
Cost costOfPolygon(const Shape& shape) {
  constexpr int kPolygons = 101;
  std::vector<double> times;
  std::size_t bytes = 0;
  for (int i = 0; i < kPolygons; ++i) {
    const std::size_t before = heap_bytes;
    std::unique_ptr<Polygon> polygon;
    times.push_back(nanoseconds([&] { polygon = std::make_unique<Polygon>(shape.fixed, shape.fill); }));
    bytes = heap_bytes - before;
  }
  return {bytes, medianOf(times), 0};
}

const char* const kHow =
    R"(- Two fresh polygons of that many vertices each, or two discs, up to 101 times; medians. Bytes: what operator new handed
  out and wasn't given back, rounded up as malloc does, for both polygons and the scene together. Building: the first
  query's time less a later one's. The clock ticks every 10 ns or so.
- disc: point() with a margin. convex: slim. outline: a random contour. 64 triangles: rings that overlap, by the non-zero
  rule.
- discs apart: four radii away. near: the bounding discs overlap, the polygons don't. Every answer is checked. An empty
  cell is a query that discs have none of.
- polygon: one polygon from its rings, copied; that much every polygon pays, and the other rows come on top.
- )";

}  // namespace

bool run(const std::string& directory, bool) {
  const std::vector<Shape> all = shapes();
  std::vector<Study> tables = {
      {"bytes that the first query leaves", {}}, {"time to build them", {}}, {"a later query", {}}};
  const auto enter = [&](const std::string& name, auto costOfShape) {
    for (Study& table : tables) table.results.push_back({{"modelled", table.title, name}});
    for (const Shape& shape : all) {
      const std::optional<Cost> cost = costOfShape(shape);
      if (!cost) continue;
      const double values[] = {static_cast<double>(cost->bytes), cost->extra_ns, cost->warm_ns};
      for (std::size_t i = 0; i < tables.size(); ++i)
        tables[i].results.back().timings.push_back({shape.name, Role::Ours, values[i]});
    }
  };
  enter("polygon and no query", [](const Shape& shape) { return std::optional<Cost>(costOfPolygon(shape)); });
  for (const Query& query : kQueries)
    enter(query.name, [&](const Shape& shape) {
      return shape.margin > 0 && !query.of_discs ? std::nullopt : std::optional<Cost>(costOf(shape, query));
    });
  return writeStudies(
      directory, "modelled", tables,
      kHow + std::string("A PairCache itself is ") + std::to_string(sizeof(PairCache)) + " bytes, the caller's.\n",
      "Bytes or nanoseconds, both polygons together");
}

}  // namespace tricover::bench
