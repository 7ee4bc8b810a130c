// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tricover/polygon.h"
#include "tricover/pose.h"

namespace tricover::bench {

/// Two rings of raw vertices, counter-clockwise, and where the second one is at each query. The first stays.
struct FirstAsked {
  const Ring& fixed;
  const Ring& moving;
  const Pose* poses;
  std::size_t queries;
};

/// Makes what it needs of the raw vertices, asks every pose whether the two collide, and forgets it all.
struct FirstMethod {
  const char* name;
  bool library;      ///< a loop of one's own is none
  bool convex_only;  ///< and of at most 8 vertices
  std::size_t (*hits)(const FirstAsked& asked);
};

/// tricover comes first.
const std::vector<FirstMethod>& firstMethods();

}  // namespace tricover::bench
