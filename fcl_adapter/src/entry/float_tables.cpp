// SPDX-License-Identifier: BSD-3-Clause
#include "entry/fill_tables.h"
#include "tricover_fcl/registration.h"

namespace tricover_fcl {

/// Apart from registration.cpp, which every program links.
template <>
detail::FilledTables<float> detail::filledTables(const FclLayout& seen) {
  checkFclLayout(seen);
  static const bool filled = fillTables<float>();  // by one thread, the others wait
  static_cast<void>(filled);
  return {};
}

}  // namespace tricover_fcl
