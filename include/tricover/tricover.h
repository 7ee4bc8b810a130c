// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/collide.h"
#include "tricover/conflicts.h"
#include "tricover/contacts.h"
#include "tricover/covers.h"
#include "tricover/depth.h"
#include "tricover/distance.h"
#include "tricover/export.h"
#include "tricover/least_distance.h"
#include "tricover/locate.h"
#include "tricover/motion.h"
#include "tricover/outline.h"
#include "tricover/pair_cache.h"
#include "tricover/paper.h"
#include "tricover/penetration.h"
#include "tricover/polygon.h"
#include "tricover/pose.h"
#include "tricover/prepare.h"
#include "tricover/ray.h"
#include "tricover/recording.h"
#include "tricover/scene.h"
#include "tricover/signed_distance.h"
#include "tricover/svg.h"
#include "tricover/time_of_impact.h"
#include "tricover/touching.h"
#include "tricover/trajectory.h"
#include "tricover/validity.h"
#include "tricover/version.h"

/// Exact collision detection between 2D polygons: a shape, queries about two of them under their poses, and what the
/// queries answer. It needs Eigen alone.
namespace tricover {}
