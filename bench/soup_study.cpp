// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <string>
#include <utility>

#include "core.h"
#include "methods.h"
#include "rivals/fcl_bvh.h"
#include "rivals/fcl_call.h"
#include "studies.h"
#include "tricover_fcl/tricover_fcl.h"

namespace tricover::bench {
namespace {

/// Each ring's own triangles, as they overlap.
std::vector<Triangle> trianglesOfRings(const Polygon& polygon) {
  std::vector<Triangle> triangles;
  for (const Ring& ring : polygon.rings()) {
    for (const Triangle& triangle : triangulate(Polygon({ring}))) triangles.push_back(triangle);
  }
  return triangles;
}

void measurePair(const std::string& kind, const Polygon& fixed, const Polygon& moving, const Settings& settings,
                 std::vector<Result>& to) {
  MethodTable<Hits> table;
  table.add("cold", Role::Ours, false, std::make_shared<Core>(fixed, moving));
  table.add("cached", Role::Ours, true, std::make_shared<CachedCore>(fixed, moving), onSmallSteps);
  table.add("via FCL", Role::Ours, true,
            std::make_shared<FclCall>(std::make_shared<tricover_fcl::PolygonShaped>(fixed),
                                      std::make_shared<tricover_fcl::PolygonShaped>(moving)));
  table.add("FCL BVH", Role::Rival, false, std::make_shared<FclBvh>(trianglesOfRings(fixed), trianglesOfRings(moving)));
  for (const std::string& name : workloadNames()) {
    const std::vector<Pose> poses = posesOf(name, fixed, moving);
    const Workload workload{"soups", kind, name, fixed.vertexCount(), moving.vertexCount(), poses.size(), 1};
    to.push_back(measure(workload, table.on(poses, {isCoherent(name)}), settings));
  }
}

}  // namespace

std::vector<Result> measureSoups(const Settings& settings) {
  std::vector<Result> results;
  const auto measureKind = [&](const std::string& kind, std::size_t corners, double squeeze) {
    for (const auto& [fixed, moving] : {std::pair{64, 64}, std::pair{1024, 1024}, std::pair{512, 16}}) {
      const auto some = [&](int vertices, std::uint64_t seed) {
        return workloads::makeOverlapping(static_cast<std::size_t>(vertices) / corners, corners, squeeze, seed);
      };
      measurePair(kind, some(fixed, 1), some(moving, 2), settings, results);
    }
  };
  measureKind("soup", 3, 1);
  measureKind("needles", 3, 0.1);
  measureKind("rings", 8, 1);
  return results;
}

}  // namespace tricover::bench
