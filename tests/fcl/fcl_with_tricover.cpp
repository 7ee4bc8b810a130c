// SPDX-License-Identifier: BSD-3-Clause
#include <tricover_fcl/registration.h>

#include "fcl_untouched.h"

void beforeQueries() { tricover_fcl::registerNarrowphase(); }
