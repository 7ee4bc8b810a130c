// SPDX-License-Identifier: BSD-3-Clause
#include "study.h"

#include "methods.h"

namespace tricover::bench {

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
  Methods methods(fixed, moving);
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
  }
  return results;
}

}  // namespace tricover::bench
