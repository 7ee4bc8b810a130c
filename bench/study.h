// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "measure.h"
#include "poses.h"
#include "workloads.h"

/// The cells of the study: kinds, vertices of both polygons, workloads.
namespace tricover::bench {

struct Cell {
  workloads::Kind kind;
  std::size_t vertices_fixed, vertices_moving;
  std::vector<std::string> workloads;
};

/// All of 8 .. 1024 against all of 8 .. 1024 on every workload where `full`; else the diagonal, thinned out, and the
/// corner of many fixed against few moving vertices, and the grid of the paper's Figure 12: contours on the circle.
std::vector<Cell> studyCells(bool full);

/// The fixed polygon and the moving one.
std::pair<Polygon, Polygon> polygonsOf(const Cell& cell);

/// Table 2's trajectories, "gap 0.1" and "gap 0.01" on the circle, "contact", "near", "overlap".
const std::vector<std::string>& workloadNames();
bool isCoherent(const std::string& workload);

/// Times a cell. The paper's Algorithm 3 is timed on the diagonal's two trajectories of Table 2.
std::vector<Result> measureCell(const Cell& cell, const Settings& settings);

}  // namespace tricover::bench
