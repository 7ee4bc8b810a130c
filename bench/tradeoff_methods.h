// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "measure.h"
#include "tradeoff_scenes.h"

namespace tricover::bench {

/// One setting of one way of answering: a point of the trade-off.
struct Method {
  std::string family;   ///< who answers
  std::string setting;  ///< its tolerance, or empty
  bool (*takes)(const Scene& scene);
  /// The scene must outlive it. May throw where the method can't hold the scene's polygons.
  std::function<Contender(const Scene& scene)> make;

  std::string name() const { return setting.empty() ? family : family + " " + setting; }
};

/// tricover's stages alone, its tolerances, its kernel with plain signs, the exact one, and the rivals.
const std::vector<Method>& tradeoffMethods();

/// The family that must never be wrong, and the one that must keep to its tolerance.
constexpr const char* kExact = "tricover, exact";
constexpr const char* kTolerance = "tricover, tolerance";

}  // namespace tricover::bench
