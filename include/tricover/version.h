// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/export.h"

/// The version of these headers; CMakeLists.txt reads it here.
#define TRICOVER_VERSION_MAJOR 0
#define TRICOVER_VERSION_MINOR 3
#define TRICOVER_VERSION_PATCH 0

/// One number to compare: 300 is 0.3.0, 10203 is 1.2.3.
#define TRICOVER_VERSION (TRICOVER_VERSION_MAJOR * 10000 + TRICOVER_VERSION_MINOR * 100 + TRICOVER_VERSION_PATCH)

namespace tricover {

/// The version of the library that the program runs with, as "0.3.0": that of the headers it was built from.
/// TRICOVER_VERSION, a macro, is the version of the headers that the program is compiled with: 300 for 0.3.0.
///
/// \snippet version.cpp version
TRICOVER_EXPORT const char* version();

}  // namespace tricover
