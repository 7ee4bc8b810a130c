// SPDX-License-Identifier: BSD-3-Clause
// The templates over the lanes, for an instruction set to instantiate.
#pragma once

#include "hierarchy/simd_boxes.h"
#include "hierarchy/simd_depths.h"
#include "hierarchy/simd_descent.h"
#include "hierarchy/simd_intervals.h"
#include "hierarchy/simd_paths.h"
#include "hierarchy/simd_point.h"
#include "hierarchy/simd_ray.h"
#include "hierarchy/simd_shapes.h"
#include "hierarchy/simd_small.h"
#include "hierarchy/simd_twofold.h"
