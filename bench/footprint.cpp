// SPDX-License-Identifier: BSD-3-Clause
#include "footprint.h"

#include "hierarchy/hierarchy.h"
#include "tricover/collide.h"
#include "tricover/locate.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

using Shapes = std::vector<std::vector<Ring>>;

/// Apart, near each other and meeting; with and without coherence; and an inclusion. And what many more would build.
void askEverything(const Polygon& polygon, const Polygon& other) {
  PairCache cache;
  for (const double x : {300.0, 100.0, 60.0, 0.0}) {
    Pose pose = Pose::Identity();
    pose.translation() = Vec2(x, 0.3);
    collide(polygon, Pose::Identity(), other, pose);
    collide(polygon, Pose::Identity(), other, pose, cache);
  }
  locate(polygon, Vec2(1, 1));
  innerDiscsOf(polygon.data());
}

double bytesPerEdge(const Polygon& model) {
  constexpr std::size_t kPolygons = 64;
  askEverything(model, model);  // what belongs to the thread, not to a polygon, is there from now on
  Shapes shapes(kPolygons, model.rings());
  std::vector<Polygon> polygons;
  polygons.reserve(kPolygons);
  const std::size_t before = heapBytes();
  for (auto& rings : shapes) askEverything(polygons.emplace_back(std::move(rings)), model);
  return static_cast<double>(heapBytes() - before) / static_cast<double>(kPolygons * model.vertexCount());
}

double nsPerEdge(const Polygon& model, const Settings& settings) {
  const std::size_t count = 32768 / model.vertexCount();
  Shapes shapes;
  std::vector<Polygon> polygons;
  const auto make = [&] {
    polygons.clear();
    polygons.reserve(count);
    shapes.assign(count, model.rings());
  };
  const auto build = [&](std::size_t i) { innerDiscsOf(polygons.emplace_back(std::move(shapes[i])).data()); };
  return 1e9 * measureBuild("build", count, make, build, settings) / static_cast<double>(model.vertexCount());
}

}  // namespace

std::vector<Footprint> measureFootprints(const Settings& settings) {
  std::vector<Footprint> footprints;
  for (const workloads::Kind kind : workloads::allKinds()) {
    for (const std::size_t vertices : {8, 64, 1024}) {
      const Polygon model = workloads::makePolygon(kind, vertices, 1);
      footprints.push_back({name(kind), vertices, bytesPerEdge(model), nsPerEdge(model, settings)});
    }
  }
  return footprints;
}

}  // namespace tricover::bench
