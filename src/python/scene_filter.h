// SPDX-License-Identifier: BSD-3-Clause
// What both files of Scene's queries share.
#pragma once

#include <cstdint>
#include <optional>

#include "python/module.h"

namespace tricover_python {

constexpr std::uint32_t kAll = tricover::kEveryCategory;

inline tricover::BodyFilter filterFrom(Mask mask, const std::optional<Body>& ignored) {
  return {mask.bits, ignored ? ignored->handle : tricover::kNoBody};
}

}  // namespace tricover_python
