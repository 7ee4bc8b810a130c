// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "families.h"
#include "tricover/motion.h"

namespace tricover::support {

/// C++ that pastes back as a test: the same polygons and poses, bit for bit.
std::string reproduction(const Case& c);
std::string reproduction(const Polygon& polygon, const Vec2& point);
std::string reproduction(const char* name, const Motion& motion);
std::string reproduction(const MovingCase& c);

/// A hexadecimal literal of exactly this double.
std::string hex(double value);

}  // namespace tricover::support
