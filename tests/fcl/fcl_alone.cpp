// SPDX-License-Identifier: BSD-3-Clause
#include "fcl_untouched.h"

void beforeQueries() {}
