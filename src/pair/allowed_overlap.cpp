// SPDX-License-Identifier: BSD-3-Clause
#include "pair/allowed_overlap.h"

#include "pair/discs.h"
#include "polygon/convexity.h"

namespace tricover::detail {

/// The local depth of a component with a notch, as of a crate in a room's corner, may be that of its hull.
std::vector<Contact> allowedOverlap(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                                    double allowed) {
  ContactOptions options;
  options.detail = ContactDetail::LocalDepth;
  std::vector<Contact> local = contacts(a, pose_a, b, pose_b, options);
  if (local.size() != 1 || local.front().depth < allowed) return local;
  if (cornersOf(a.data()) != nullptr && cornersOf(b.data()) != nullptr) return local;
  if (depthOfDiscs(PosedPair(a.data(), pose_a, b.data(), pose_b), 0) > allowed) return local;
  options.detail = ContactDetail::GlobalDepth;
  std::vector<Contact> global = contacts(a, pose_a, b, pose_b, options);
  return global.front().depth < local.front().depth ? global : local;
}

}  // namespace tricover::detail
