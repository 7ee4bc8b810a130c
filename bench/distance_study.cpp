// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <string>
#include <utility>

#include "core.h"
#include "methods.h"
#include "rivals/boost_geometry.h"
#include "rivals/box2d.h"
#include "rivals/fcl_call.h"
#include "rivals/fcl_distance.h"
#include "rivals/geos.h"
#include "studies.h"
#include "tricover_fcl/tricover_fcl.h"

namespace tricover::bench {
namespace {

/// Of the polygons' size, 100 units: GJK's tolerance and floats pass.
constexpr Agreement kAgreement = {0, {0, 0}, {1e-4, 1e-4}};

/// Methods that compare all edges with all are timed up to this number of pairs. Beyond it they are the slowest.
constexpr std::size_t kFewPairs = 64 * 64;

/// The circle's first tenth, which begins at the smallest gap.
constexpr std::size_t kLongest = 9000;

/// Of overlapping poses: meshes and triangles take long there.
constexpr std::size_t kOverlaps = 100;

MethodTable<Values> methodsOn(const Polygon& fixed, const Polygon& moving) {
  constexpr bool kColdStart = false, kWarmStart = true, kPrepared = true, kPlain = false;
  const bool few = fixed.vertexCount() * moving.vertexCount() <= kFewPairs;
  MethodTable<Values> table;
  table.add("cold", Role::Ours, false, std::make_shared<Core>(fixed, moving));
  table.add("cached", Role::Ours, true, std::make_shared<CachedCore>(fixed, moving), onSmallSteps);
  table.add("via FCL", Role::Ours, true,
            std::make_shared<FclCall>(std::make_shared<tricover_fcl::PolygonShaped>(fixed),
                                      std::make_shared<tricover_fcl::PolygonShaped>(moving)));
  table.add("FCL RSS", Role::Rival, false, std::make_shared<FclRssDistance>(fixed, moving));
  if (isConvex(fixed) && isConvex(moving)) {
    using Libccd = FclGjkDistance<fcl::detail::GJKSolver_libccdd>;
    using Indep = FclGjkDistance<fcl::detail::GJKSolver_indepd>;
    table.add("FCL GJK (libccd)", Role::Rival, false, std::make_shared<Libccd>(fixed, moving, kColdStart));
    table.add("FCL GJK (indep)", Role::Rival, false, std::make_shared<Indep>(fixed, moving, kColdStart));
    table.add("FCL GJK (indep) guess", Role::Rival, true, std::make_shared<Indep>(fixed, moving, kWarmStart),
              onSmallSteps);
  }
  table.add("GEOS prepared", Role::Rival, false, std::make_shared<GeosDistance>(fixed, moving, kPrepared));
  if (few) table.add("GEOS", Role::Rival, false, std::make_shared<GeosDistance>(fixed, moving, kPlain));
  if (few) table.add("Boost", Role::Rival, false, std::make_shared<BoostGeometry>(fixed, moving));
  if (box2dTakes(fixed) && box2dTakes(moving)) {
    table.add("Box2D", Role::Box2d, false, std::make_shared<Box2dDistance>(fixed, moving, kColdStart));
    table.add("Box2D warm", Role::Box2d, true, std::make_shared<Box2dDistance>(fixed, moving, kWarmStart),
              onSmallSteps);
  }
  return table;
}

}  // namespace

std::vector<Cell> distanceCells(bool full) {
  const std::vector<std::string> names = {"circular", "linear", "gap 0.01", "near", "far", "overlap"};
  std::vector<std::pair<std::size_t, std::size_t>> sizes = {{8, 8}, {64, 64}, {1024, 1024}, {512, 16}};
  if (full) sizes.insert(sizes.end(), {{16, 16}, {32, 32}, {128, 128}, {256, 256}, {512, 512}, {1024, 8}, {8, 1024}});
  std::vector<Cell> cells;
  for (const workloads::Kind kind : workloads::allKinds()) {
    for (const auto& [fixed, moving] : sizes) cells.push_back({kind, fixed, moving, names});
  }
  return cells;
}

std::vector<Result> measureDistances(const Cell& cell, const Settings& settings) {
  const auto [fixed, moving] = polygonsOf(cell);
  const MethodTable<Values> methods = methodsOn(fixed, moving);
  std::vector<Result> results;
  for (const std::string& name : cell.workloads) {
    const bool coherent = isCoherent(name);
    std::vector<Pose> poses = coherent || name == "overlap" ? posesOf(name, fixed, moving)
                              : name == "near"              ? separatedPoses(fixed, moving, 1.03, 1.5)
                                                            : separatedPoses(fixed, moving, 2, 4);
    const std::size_t most = name == "overlap" ? kOverlaps : kLongest;
    if (poses.size() > most) poses.resize(most);
    const Workload workload{
        "distance", workloads::name(cell.kind), name, cell.vertices_fixed, cell.vertices_moving, poses.size(), 1};
    results.push_back(measure(workload, methods.on(poses, {coherent}), kAgreement, settings));
  }
  return results;
}

}  // namespace tricover::bench
