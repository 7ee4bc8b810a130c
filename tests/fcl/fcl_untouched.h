// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What the two programs differ in.
void beforeQueries();
