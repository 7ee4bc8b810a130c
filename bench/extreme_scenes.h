// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tradeoff_scenes.h"

namespace tricover::bench {

/// One way to the extreme: far from the origin, scaled, or squeezed to slivers.
struct Sweep {
  std::string name;
  std::vector<int> exponents;
  std::function<Scene(workloads::Kind kind, int exponent)> scene;  ///< yet without placements
};

/// Four of them.
const std::vector<Sweep>& sweeps();

/// "1e-15".
std::string powerOfTen(int exponent);

/// A sweep's scene before it is moved or scaled, of two polygons of 8 vertices.
Scene plainScene(workloads::Kind kind);

/// The kinds of polygons that are asked.
const std::vector<workloads::Kind>& extremeKinds();

/// The sweep's scene at the extreme, with its placements around that many contacts.
Scene extremeScene(const Sweep& sweep, int exponent, workloads::Kind kind, std::size_t contacts);

}  // namespace tricover::bench
