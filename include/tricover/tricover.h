// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/export.h"
#include "tricover/influence.h"
#include "tricover/locate.h"
#include "tricover/motion.h"
#include "tricover/penetration.h"
#include "tricover/polygon.h"
#include "tricover/pose.h"
#include "tricover/svg.h"
#include "tricover/time_of_impact.h"
#include "tricover/version.h"
