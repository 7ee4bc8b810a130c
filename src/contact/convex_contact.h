// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pair/posed_pair.h"
#include "tricover/contacts.h"

namespace tricover::detail {

/// What plain doubles prove of a pair.
struct ConvexContact {
  enum Verdict { Unsure, Apart, Overlap };

  Verdict verdict = Unsure;
  Contact contact = {};  ///< of an overlap
};

/// Of convex polygons without straight vertices that are well apart, or overlap so that their edges cross twice, in
/// O(n + m). Unsure of all others. The facts of these two in `cache`, unless it is null, are used and renewed.
ConvexContact convexContact(const PosedPair& pair, ContactFacts* cache);

}  // namespace tricover::detail
