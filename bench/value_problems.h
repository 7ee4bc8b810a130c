// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "measure.h"
#include "tradeoff_scenes.h"

namespace tricover::bench {

/// One setting of one way of answering, and what it promises: how far it may be off, relative to the truth or, of
/// times, in time. Rivals promise nothing.
struct ValueMethod {
  std::string family, setting;
  ValueContender contender;
  double promise = std::numeric_limits<double>::infinity();

  std::string name() const { return setting.empty() ? family : family + ", " + setting; }
};

/// Queries of one kind about one pair of polygons.
struct ValueProblem {
  std::string query, group;
  const Scene* scene;
  std::size_t positions;
  Values truth;
  std::vector<ValueMethod> methods;
  /// Whether a value is not just inexact but wrong.
  bool (*is_wrong)(double value, double truth, double size);
};

/// Distances, times of impact and penetrations of the scenes, which must outlive them. Throws std::logic_error if a
/// time of impact is late.
std::vector<ValueProblem> valueProblems(const std::vector<Scene>& scenes, bool full);

}  // namespace tricover::bench
