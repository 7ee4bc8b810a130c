// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "families.h"
#include "tricover/motion.h"

/// What conflicts() and timeOfImpact() promise of bodies that start in contact, or a few roundings beside it, and of
/// contact that lasts.
namespace tricover::support {

struct MovingCase {
  Polygon a;
  Motion motion_a;
  Polygon b;
  Motion motion_b;
  double margin = 0;
};

std::string reproduction(const MovingCase& c);

/// What time_of_impact.h calls L: coming within 1e-13 of it may count as a contact.
double lengthOf(const MovingCase& c);

struct LastingCounts {
  int cases = 0, at_begin = 0, later = 0, none = 0, lasting = 0;
};

/// What is wrong with the intervals in which polygons that are only shifted meet, with what is left without the initial
/// one, and with the times of impact; empty if nothing is.
std::string wrongWithShifts(const MovingCase& c, double error, LastingCounts& counts);

/// The same of any motions, beside exact distances at so many times: where they surely meet they are told to, and where
/// they are surely apart, for longer than the error, they are not.
std::string wrongWithSamples(const MovingCase& c, double error, int samples, LastingCounts& counts);

/// Polygons on a grid, of which one starts in contact with the other, or at the margin, or some roundings beside it,
/// and is shifted along an edge or anywhere, as the other one may be.
MovingCase anyShiftFromContact(Random& random);

/// The same polygons and starts with rotations, about the contact or not, and cubics along it.
MovingCase anyMotionFromContact(Random& random);

}  // namespace tricover::support
