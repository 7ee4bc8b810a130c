// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/config.h>

#ifndef OWN_FCL
#error "compiled against the installed FCL, not against the project's own"
#endif
