// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>

#include "tricover/pose.h"
#include "tricover/touching.h"

namespace tricover::detail {

/// The text of every exception: "tricover: <field>[: ring i, vertex j]: <what is wrong>[; <what to do instead>]".
inline std::string refusal(const std::string& field, const std::string& wrong, const std::string& instead = {}) {
  return "tricover: " + field + ": " + wrong + (instead.empty() ? "" : "; " + instead);
}

[[noreturn]] inline void refuse(const std::string& field, const std::string& wrong, const std::string& instead = {}) {
  throw std::invalid_argument(refusal(field, wrong, instead));
}

/// The fault of a pose: an entry of R^T R misses the identity's by so much.
inline std::string offRigid(double by) {
  char text[128];
  std::snprintf(text, sizeof text, "linear() is off rigid by %.3g, more than %g (tricover::kRigidTolerance)", by,
                kRigidTolerance);
  return text;
}

[[noreturn]] inline void refuseCoordinate(const std::string& field) { refuse(field, "a coordinate is not finite"); }

inline void requireFinite(const Vec2& point, const char* field) {
  if (!point.allFinite()) refuseCoordinate(field);
}

/// Out of the way of hot code, which checks its options.
[[noreturn, gnu::cold, gnu::noinline]] inline void refuseLength(const char* field, bool finite) {
  refuse(field, finite ? "it must be finite and not negative" : "it must be a number and not negative");
}

/// Refuses a negative length or number. Infinity passes; NaN fails, as below.
inline void requireNotNegative(double value, const char* field) {
  if (!(value >= 0)) refuseLength(field, false);
}

/// Refuses a margin that is not finite. A negative one is an overlap that is allowed.
inline void requireFiniteMargin(double margin, const char* field) {
  if (!(margin - margin == 0)) refuse(field, "it must be finite");
}

inline void requireFiniteNotNegative(double value, const char* field) {
  if (!(value >= 0 && value <= std::numeric_limits<double>::max())) refuseLength(field, true);
}

inline void requireTouching(Touching touching) {
  if (touching != Touching::Collides && touching != Touching::Allowed)
    refuse("touching", "it must be Touching::Collides or Touching::Allowed");
}

}  // namespace tricover::detail
