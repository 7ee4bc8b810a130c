// SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include "core.h"
#include "methods.h"
#include "plain_core.h"
#include "rivals/boost_geometry.h"
#include "rivals/box2d.h"
#include "rivals/fcl_bvh.h"
#include "rivals/fcl_call.h"
#include "rivals/fcl_convex.h"
#include "rivals/geos.h"
#include "studies.h"
#include "tricover_fcl/tricover_fcl.h"

namespace tricover::bench {
namespace {

MethodTable<Hits> methodsOn(const Polygon& fixed, const Polygon& moving, const std::shared_ptr<FclMpr>& mpr) {
  MethodTable<Hits> table;
  table.add("cold", Role::Ours, false, std::make_shared<Core>(fixed, moving));
  table.add("cached", Role::Ours, true, std::make_shared<CachedCore>(fixed, moving), onSmallSteps);
  table.add("paper", Role::Ours, true, std::make_shared<PaperCore>(fixed, moving),
            [](const Choice& choice) { return choice.paper; });
  table.add("via FCL", Role::Ours, true,
            std::make_shared<FclCall>(std::make_shared<tricover_fcl::PolygonShaped>(fixed),
                                      std::make_shared<tricover_fcl::PolygonShaped>(moving)));
  table.add("empty", Role::Floor, false, std::make_shared<FclCall>(emptyGeometry(), emptyGeometry()));
  const auto plain = [walk = tricover_plain_double::plainWalk(fixed.rings(), moving.rings())](
                         const std::vector<Pose>& poses) -> Contender {
    return {"plain signs", Role::Inexact, false, [&poses, walk](const Sampling& sampling, Hits& hits) {
              walk(poses.data(), poses.size(), sampling.period, sampling.run, hits);
            }};
  };
  table.addMade(plain, [](const Choice& choice) { return choice.plain; });
  table.add("FCL MPR", Role::Rival, false, mpr);
  table.add("FCL GJK", Role::Rival, false, std::make_shared<FclGjk>(fixed, moving, false));
  table.add("FCL GJK guess", Role::Rival, true, std::make_shared<FclGjk>(fixed, moving, true), onSmallSteps);
  table.add("FCL BVH", Role::Rival, false, std::make_shared<FclBvh>(fixed, moving));
  table.add("GEOS", Role::Rival, false, std::make_shared<Geos>(fixed, moving));
  table.add("Boost", Role::Rival, false, std::make_shared<BoostGeometry>(fixed, moving));
  if (box2dTakes(fixed) && box2dTakes(moving)) {
    table.add("Box2D overlap", Role::Box2d, false, std::make_shared<Box2dOverlap>(fixed, moving));
    table.add("Box2D manifold", Role::Box2d, false, std::make_shared<Box2dManifold>(fixed, moving));
  }
  return table;
}

}  // namespace

std::pair<Polygon, Polygon> polygonsOf(const Cell& cell) {
  return {workloads::makePolygon(cell.kind, cell.vertices_fixed, 1),
          workloads::makePolygon(cell.kind, cell.vertices_moving, 2)};
}

const std::vector<std::string>& workloadNames() {
  static const std::vector<std::string> names = {"circular", "linear", "gap 0.1", "gap 0.01",
                                                 "contact",  "near",   "overlap"};
  return names;
}

bool isCoherent(const std::string& workload) {
  return workload == "circular" || workload == "linear" || workload == "gap 0.1" || workload == "gap 0.01";
}

std::vector<Cell> studyCells(bool full) {
  std::vector<Cell> cells;
  for (const workloads::Kind kind : workloads::allKinds()) {
    for (std::size_t fixed = 8; fixed <= 1024; fixed *= 2) {
      for (std::size_t moving = 8; moving <= 1024; moving *= 2) {
        const bool diagonal = fixed == moving && (fixed == 8 || fixed == 64 || fixed == 1024);
        const bool corner = (fixed == 512 && moving == 16) || (fixed == 1024 && moving == 8);
        if (full || diagonal || corner) {
          cells.push_back({kind, fixed, moving, workloadNames()});
        } else if (kind == workloads::Kind::Contour) {
          cells.push_back({kind, fixed, moving, {"circular"}});
        }
      }
    }
  }
  return cells;
}

std::vector<Result> measureCell(const Cell& cell, const Settings& settings) {
  const auto [fixed, moving] = polygonsOf(cell);
  const auto mpr = std::make_shared<FclMpr>(fixed, moving);
  const MethodTable<Hits> methods = methodsOn(fixed, moving, mpr);
  std::vector<Result> results;
  for (const std::string& name : cell.workloads) {
    const std::vector<Pose> poses = posesOf(name, fixed, moving);
    Choice choice;
    choice.coherent = isCoherent(name);
    choice.paper = cell.vertices_fixed == cell.vertices_moving && (name == "circular" || name == "linear");
    choice.plain = name == "contact";
    const Workload workload{
        "study", workloads::name(cell.kind), name, cell.vertices_fixed, cell.vertices_moving, poses.size(), 1};
    results.push_back(measure(workload, methods.on(poses, choice), settings));
    results.back().decided_at_once = mpr->decidedAtOnce();
  }
  return results;
}

}  // namespace tricover::bench
