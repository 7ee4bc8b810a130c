// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/version.h"

#define TRICOVER_TEXT_OF(tokens) #tokens
#define TRICOVER_TEXT(tokens) TRICOVER_TEXT_OF(tokens)

namespace tricover {

const char* version() { return TRICOVER_TEXT(TRICOVER_VERSION_MAJOR.TRICOVER_VERSION_MINOR.TRICOVER_VERSION_PATCH); }

}  // namespace tricover
