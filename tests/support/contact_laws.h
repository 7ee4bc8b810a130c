// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "families.h"
#include "random.h"
#include "tricover/contacts.h"

/// What contacts() promises, on exact numbers.
namespace tricover::support {

/// What contacts.h says of a contact's coordinates.
double rounding(const Case& c);

Pose moved(const Pose& pose, const Vec2& way);

/// What is wrong with contacts, whatever their number: order, normals, depths and points, with how near these are to
/// the regions now and then; empty if nothing is.
std::string wrongContacts(Random& random, const Case& c, const std::vector<Contact>& found);

/// What is wrong with the edges that they name, given whether edges meet; empty if nothing is.
/// Options by which contacts() tells all that it can.
inline ContactOptions globally(double margin = 0) {
  ContactOptions options{margin};
  options.detail = ContactDetail::GlobalDepth;
  return options;
}

std::string wrongEdges(const Case& c, const std::vector<Contact>& found, bool crossed);

/// What is wrong with the contacts with a margin: they are where the regions are within it; apart, there is one, as
/// deep as is left of the margin, and its normal leads from the one nearest point to the other. Empty if nothing is.
std::string wrongContactsWithMargin(const Case& c, double margin);

/// What is wrong with the depth and normal of the contact of two strictly convex polygons; empty if nothing is.
std::string wrongConvexContact(const Case& c, const Contact& contact);

/// A local depth is at least what the overlap has of the line along the normal through the contact's point. Empty if it
/// is.
std::string wrongLocalDepths(const Case& c, const std::vector<Contact>& found);

/// Pushes b by the deepest contact's local depth, again and again, until no interiors meet. Returns after how many
/// pushes that is, or `most` + 1.
int pushesUntilFree(Case c, int most);

/// The point lies in both regions.
bool isCommon(const Case& c, const Contact& contact);

/// Moving b by little more than the depth along the normal parts the regions.
bool parts(const Case& c, const Contact& contact);

/// Moving b by the depth along the normal brings the two edges together; in a containment, the one to the other region.
bool edgesPartLast(const Case& c, const Contact& contact);

/// What the only contact of a pair says of the way apart is wrong; empty if it isn't.
std::string wrongWayApart(const Case& c, const Contact& contact);

/// To the last bit.
bool same(const std::vector<Contact>& p, const std::vector<Contact>& q);

}  // namespace tricover::support
