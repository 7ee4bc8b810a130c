// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "families.h"

namespace tricover::support {

/// Where a translation leads out of the mouth, or many features tie: corners, docks that fit exactly, thin bodies
/// through thick ones, edges used twice, flat contacts, regular holes, complements. In most cases bodies overlap a
/// little.
std::vector<Family> depthFamilies();

}  // namespace tricover::support
