// SPDX-License-Identifier: BSD-3-Clause
// What each kind of query makes tricover build from fresh polygons: what isn't used isn't paid for.
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "report.h"
#include "tricover/tricover.h"
#include "workloads.h"

namespace {

/// What operator new handed out and didn't get back, with what malloc rounds it up to.
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

/// Two fresh polygons and what their users keep about them.
struct Pair {
  Polygon fixed, moving;
  PairCache cache;
  PointCache point_cache;
};

struct Query {
  const char* name;
  bool answer;
  bool (*ask)(Pair& pair);
};

Pose at(const Vec2& position) {
  Pose pose = Pose::Identity();
  pose.translation() = position;
  return pose;
}

/// Out of the bounding discs' reach; where the discs overlap and the polygons, twice as long as high, don't; and upon
/// it.
Pose far(const Pair& pair) { return at({2 * (pair.fixed.radius() + pair.moving.radius()), 0}); }
Pose near(const Pair& pair) { return at({0, 1.3 * pair.fixed.radius()}); }
Pose upon(const Pair& pair) { return at({pair.fixed.radius() / 2, 0}); }

const Pose kIdentity = Pose::Identity();

const Query kQueries[] = {
    {"collide, discs apart", false, [](Pair& pair) { return collide(pair.fixed, kIdentity, pair.moving, far(pair)); }},
    {"collide, near", false, [](Pair& pair) { return collide(pair.fixed, kIdentity, pair.moving, near(pair)); }},
    {"collide, overlapping", true, [](Pair& pair) { return collide(pair.fixed, kIdentity, pair.moving, upon(pair)); }},
    {"collide, near, PairCache", false,
     [](Pair& pair) { return collide(pair.fixed, kIdentity, pair.moving, near(pair), pair.cache); }},
    {"collide, near, Strategy::Paper", false,
     [](Pair& pair) {
       return collide(pair.fixed, kIdentity, pair.moving, near(pair), {0, 0, Strategy::Paper});
     }},
    {"locate, outside", false,
     [](Pair& pair) { return locate(pair.fixed, 3 * far(pair).translation()) != Location::Outside; }},
    {"locate, inside", true, [](Pair& pair) { return locate(pair.fixed, pair.fixed.origin()) != Location::Outside; }},
    {"locate, inside, PointCache", true,
     [](Pair& pair) { return locate(pair.fixed, pair.fixed.origin(), pair.point_cache) != Location::Outside; }},
};

/// Of one call of `work`.
template <class Work>
double nanoseconds(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// For a first query on fresh polygons: what it leaves on the heap, what it takes beyond its successors, and what they
/// take.
struct Cost {
  std::size_t bytes;
  double extra_ns;
  std::optional<double> warm_ns;
};

Cost costOf(const std::vector<Ring>& fixed, const std::vector<Ring>& moving, const Query& query) {
  constexpr int kPairs = 101, kLater = 20, kWarm = 100;
  std::vector<double> extra, warm;
  std::size_t bytes = 0;
  for (int i = 0; i < kPairs; ++i) {
    Pair pair{Polygon(fixed), Polygon(moving), {}, {}};
    bool right = true;
    const auto ask = [&] { right = query.ask(pair) == query.answer && right; };
    const std::size_t before = heap_bytes;
    const double first = nanoseconds(ask);
    bytes = heap_bytes - before;
    // One by one, so that the clock's own time cancels.
    std::vector<double> later;
    for (int k = 0; k < kLater; ++k) later.push_back(nanoseconds(ask));
    extra.push_back(first - median(later));
    warm.push_back(nanoseconds([&] {
                     for (int k = 0; k < kWarm; ++k) ask();
                   }) /
                   kWarm);
    if (!right) throw std::logic_error(std::string("modelled: wrong: ") + query.name);
  }
  return {bytes, median(extra), median(warm)};
}

/// The polygon itself, before any query.
Cost costOfPolygon(const std::vector<Ring>& rings) {
  constexpr int kPolygons = 101;
  std::vector<double> times;
  std::size_t bytes = 0;
  for (int i = 0; i < kPolygons; ++i) {
    const std::size_t before = heap_bytes;
    std::unique_ptr<Polygon> polygon;
    times.push_back(nanoseconds([&] { polygon = std::make_unique<Polygon>(rings); }));
    bytes = heap_bytes - before;
  }
  return {bytes, median(times), {}};
}

const char* const kHow =
    R"(- Two fresh contours of that many vertices each, 101 times; medians. bytes: what operator new handed out and
  wasn't given back, rounded up as malloc does, for both polygons and the caches together. build ns: the first query's
  time less a later one's. warm ns: a later query. The clock ticks every 10 ns or so.
- discs apart: twice as far as both radii. near: the discs overlap, the polygons don't. Every answer is checked.
- A PairCache itself is %zu bytes, a PointCache %zu, both the caller's.
- polygon: one polygon from its rings, copied; that much every polygon pays, and the other rows come on top.
)";

std::string rounded(double value) { return std::to_string(std::lround(value)); }

int run(const std::string& directory) {
  const std::vector<std::size_t> sizes = {8, 64, 512};
  TextTable lines = {{"asked first"}};
  for (const std::size_t n : sizes) {
    for (const char* column : {"bytes", "build ns", "warm ns"}) lines[0].push_back(std::to_string(n) + ": " + column);
  }
  std::string csv = "query,vertices,bytes,build_ns,warm_ns\n";
  const auto enter = [&](const std::string& name, std::size_t n, const Cost& cost) {
    const std::string cells[] = {std::to_string(cost.bytes), rounded(cost.extra_ns),
                                 cost.warm_ns ? rounded(*cost.warm_ns) : ""};
    csv += '"' + name + "\"," + std::to_string(n);
    for (const std::string& cell : cells) {
      lines.back().push_back(cell);
      csv += ',' + cell;
    }
    csv += '\n';
  };
  const auto rings = [](std::size_t n, std::uint64_t seed) {
    return workloads::makePolygon(workloads::Kind::Contour, n, seed).rings();
  };
  lines.push_back({"polygon, no query"});
  for (const std::size_t n : sizes) enter("polygon, no query", n, costOfPolygon(rings(n, 1)));
  for (const Query& query : kQueries) {
    lines.push_back({query.name});
    for (const std::size_t n : sizes) enter(query.name, n, costOf(rings(n, 1), rings(n, 2), query));
  }
  char how[1024];
  std::snprintf(how, sizeof how, kHow, sizeof(PairCache), sizeof(PointCache));
  const std::string text = "# Model only what a scene requires\n\n" + markdown(lines) + "\n";
  writeFile(directory + "/modelled.md", text + "# How it was measured\n\n" + how);
  writeFile(directory + "/modelled.csv", csv);
  return 0;
}

}  // namespace
}  // namespace tricover::bench

int main(int argc, char** argv) {
  using namespace tricover::bench;
  return runProgram(argv[0], "<existing report directory>", argc == 2, [&] { return run(argv[1]); });
}
