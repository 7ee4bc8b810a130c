// SPDX-License-Identifier: BSD-3-Clause
#include "polygon/derived.h"

namespace {

// Tests ask a polygon a few times only: what is derived from it would hardly ever be asked for.
[[maybe_unused]] const bool built_at_once = (tricover::detail::useStages(tricover::detail::Stages::All), true);

}  // namespace
