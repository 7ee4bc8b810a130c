// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "measure.h"
#include "study.h"

/// Distances on the study's trajectories and on random poses whose regions are apart.
namespace tricover::bench {

/// All kinds on the study's diagonal, thinned out, and many fixed against few moving vertices; more sizes where `full`.
std::vector<Cell> distanceCells(bool full);

std::vector<Result> measureDistances(const Cell& cell, const Settings& settings);

}  // namespace tricover::bench
