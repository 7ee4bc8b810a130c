// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "random.h"
#include "tricover/motion.h"
#include "tricover/polygon.h"
#include "tricover/pose.h"

/// Rings and poses that the families, the walks and the unit tests are made of. Rings run counter-clockwise where
/// nothing else is said.
namespace tricover::support {

Ring rectangle(double x_low, double y_low, double x_high, double y_high);

/// n vertices at random angles around `center`, at random radii between the two: not convex unless they are equal.
Ring star(Random& random, int n, double radius_low, double radius_high, const Vec2& center = Vec2::Zero());

/// Convex, of mostly up to 16 vertices on a circle around the origin, seldom up to `most`, or a box; many are squeezed
/// in y, to `flattest` at the least.
Ring anyConvex(Random& random, double radius, int most = 40, double flattest = 0.2);

/// A regular n-gon.
Ring regular(int n, double radius, const Vec2& center = Vec2::Zero());

/// `teeth` teeth of the given width upwards from a bar, one every `pitch`.
Ring comb(int teeth, double pitch, double width, double height);

/// A narrow triangle with its apex at the origin and the rest of it around `direction`.
Ring wedge(Random& random, const Vec2& direction, double length);

EdgeIndex anyEdge(Random& random, const Polygon& polygon);

Vec2 direction(double angle);
Ring reversed(Ring ring);
Ring eitherWay(Random& random, Ring ring);
Ring scaled(Ring ring, double factor);
Ring shifted(Ring ring, const Vec2& by);

/// A vertex said twice here and there, and midpoints (rounded) of edges put in.
Ring withRepeatedAndMidpoints(Random& random, const Ring& ring);

/// Of corners near those of a convex ring, with exactly straight vertices: a midpoint a side, several, or all on one
/// side. Some are turned, after which hardly any is straight but for rounding.
Ring withStraightVertices(Random& random, Ring ring);

/// The same region with every ring gone round three times or more: no short way takes that.
Polygon goneRoundOften(std::vector<Ring> rings);

/// Every ring's direction and the rings' order drawn anew: nothing changes under even-odd.
std::vector<Ring> redirected(Random& random, std::vector<Ring> rings);

/// Turned by the angle, then moved: the angle comes first, unlike that of the public poseAt(x, y, heading).
Pose turnedAndMoved(double angle, double x, double y);
/// By its entries, a row after the other.
Pose pose(double xx, double xy, double x, double yx, double yy, double y);
/// On the spot. What the rotation missed of one, or mirrored, is gone.
void turn(Pose& pose, double angle);
Pose mirrored(Pose pose);
/// Rounded through float, so that R misses orthonormality by about 1e-7.
Pose throughFloat(const Pose& pose);
/// R off orthonormality by as much as is allowed, half of the time in all entries of R^T R: a little scale and shear.
Pose distorted(Random& random, Pose pose);
Pose randomPose(Random& random, double reach);
/// From within 2 sizes, of several kinds: at rest, sliding, turning about the polygon's S or another point, splines.
Motion randomMotion(Random& random, const Polygon& polygon, double size);

/// `steps` representable doubles up (or down).
double nudged(double value, int steps);
/// Each coordinate up to `most` steps either way.
Vec2 nudged(Random& random, const Vec2& point, int most);

}  // namespace tricover::support
