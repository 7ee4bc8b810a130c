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
  enum Kind { Ours, Library, Convex, Box2d, Loop };  ///< Convex, Box2d: for convex polygons, Box2D up to 8 vertices

  const char* name;
  Kind kind;
  std::size_t (*hits)(const FirstAsked& asked);

  bool takes(bool convex, std::size_t vertices) const {
    return (convex || (kind != Convex && kind != Box2d)) && (kind != Box2d || vertices <= 8);
  }
};

/// The methods of a program, ours first, and what its report is called.
const std::vector<FirstMethod>& firstMethods();
extern const char* const kFirstReport;

}  // namespace tricover::bench
