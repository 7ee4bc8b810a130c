// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/contacts.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "contact/contact_ends.h"
#include "contact/contact_solvers.h"
#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "overlay/interiors.h"
#include "pair/certificate.h"
#include "pair/collide_by_hierarchy.h"
#include "pair/discs.h"
#include "pair/kernel_order.h"
#include "penetration/penetration.h"
#include "polygon/cache_access.h"
#include "polygon/convexity.h"

namespace tricover {
namespace detail {
namespace {

/// The contact of two regions that are apart, within a margin.
Contact contactBeside(const PosedPair& pair, double margin) {
  const auto [nearest, normal] = nearestContact(pair);
  const WorldFrame frame(pair);
  const double error = 4 * frame.error(), depth = std::max(margin - nearest.distance, 0.0);
  const EdgePosition nearest_a = pair.a.edgePosition(nearest.edge_a), nearest_b = pair.b.edgePosition(nearest.edge_b);
  // In the frame, since far from the world's origin the world's coordinates don't tell ends from other points.
  const auto [on_a, on_b] = nearestPlaces(frame.edgeEndsOfA(nearest_a), frame.edgeEndsOfB(nearest_b));
  // At a vertex either edge may face the other polygon.
  const auto facing = [&, &normal = normal](int side, EdgePosition edge, const Vec2& at) {
    const PolygonData& polygon = side == 0 ? pair.a : pair.b;
    const WorldFrame::Ends ends = frame.edgeEnds(side, edge);
    const bool at_v = (at - ends.v).norm() <= error;
    if (!at_v && (at - ends.w).norm() > error) return edge;
    const EdgesAt vertex = edgesAt(polygon, at_v ? edge : edgeAfter(polygon, edge));
    return flatterEdge(vertex, normal, [&](EdgePosition e) { return frame.edgeEnds(side, e); });
  };
  const EdgePosition edge_a = facing(0, nearest_a, on_a), edge_b = facing(1, nearest_b, on_b);
  const Vec2 middle = nearest.point_a / 2 + nearest.point_b / 2;
  Contact contact = contactAt(middle, normal, depth, pair.a.edgeName(edge_a), pair.b.edgeName(edge_b));
  const Extent all{Vec2(-normal.y(), normal.x())};
  addEnds(contact, frame, straightPiece(pair, frame, 0, edge_a, all), straightPiece(pair, frame, 1, edge_b, all),
          0.5 * on_a + 0.5 * on_b, margin);
  return contact;
}

/// `gap`: of regions that are proven to be apart so far.
std::vector<Contact> allContacts(const PosedPair& pair, const ContactOptions& options, double& gap) {
  if (cornersOf(pair.a) == nullptr || cornersOf(pair.b) == nullptr) return componentContacts(pair, nullptr, options);
  const SeparatingAxes axes(pair);
  gap = axes.gap();
  if (axes.verdict() == SeparatingAxes::Apart) return {};
  if (axes.verdict() == SeparatingAxes::Meet)
    if (const std::optional<Contact> contact = convexContact(pair, axes, options.margin)) return {1, *contact};
  return componentContacts(pair, &axes, options);
}

std::vector<Contact> deepestContacts(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                                     double defect, PairCacheContents* cache, const ContactOptions& options) {
  const PosedPair pair(a, pose_a, b, pose_b);
  if (gapOfDiscs(pair, options.margin) >= 0) return {};
  Certificate* certificate = cache != nullptr ? &cache->collision : nullptr;
  Recollection known{};
  if (certificate != nullptr && certificate->back_off.isOn()) {
    countDown(*certificate, a, pose_a, b, pose_b);
    certificate = nullptr;
  } else if (certificate != nullptr) {
    known = recall(*certificate, a, pose_a, b, pose_b, defect, options.margin);
  }
  if (known.certain && !known.collides) return {};
  // Separating axes find a gap anyway. Crossings don't: the search for a certificate comes first, and is the answer as
  // long as the polygons stay apart.
  if (certificate != nullptr && !certificate->overlapping && (cornersOf(a) == nullptr || cornersOf(b) == nullptr) &&
      renewCertificate(a, pose_a, b, pose_b, defect, *certificate, known, {options.margin, 0}) == false)
    return {};
  double gap = 0;
  std::vector<Contact> result = allContacts(pair, options, gap);
  if (const double margin = options.margin; result.empty() && margin > 0)
    if (collideByHierarchy(pair, {margin, 0}, 0, Wanted::Answer).collides) result = {contactBeside(pair, margin)};
  if (certificate != nullptr && result.empty()) {
    if (!(gap > options.margin))
      rememberPoses(*certificate, a, pose_a, b, pose_b);
    else if (beginRenewal(*certificate, a, pose_a, b, pose_b, known))
      remember(*certificate, a, pose_a, b, pose_b, false, gap);
  }
  if (result.size() > 1)
    std::sort(result.begin(), result.end(), [](const Contact& p, const Contact& q) { return p.depth > q.depth; });
  if (result.size() > options.most)
    result.erase(result.begin() + static_cast<std::ptrdiff_t>(options.most), result.end());
  return result;
}

std::vector<Contact> contacts(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                              PairCacheContents* cache, const ContactOptions& options) {
  requireFiniteNotNegative(options.margin, "margin");
  if (options.detail < ContactDetail::Points || options.detail > ContactDetail::GlobalDepth)
    refuse("detail", "not a ContactDetail");
  if (options.detail == ContactDetail::GlobalDepth) requireBounded(a, b);
  requireTouching(options.touching);
  const double defect = requireRigid(pose_a, pose_b);
  if (options.touching != Touching::Collides && !regionsCollide(detail::dataOf(a), pose_a, detail::dataOf(b), pose_b,
                                                                defect, nullptr, {options.margin, 0, options.touching}))
    return {};
  return inKernelOrder(
      detail::dataOf(a), pose_a, detail::dataOf(b), pose_b,
      [&](const auto&... operands) { return deepestContacts(operands..., defect, cache, options); },
      [](std::vector<Contact>& contacts) {
        for (Contact& contact : contacts) {
          contact.normal = -contact.normal;
          std::swap(contact.edge_a, contact.edge_b);
        }
      });
}

}  // namespace
}  // namespace detail

std::vector<Contact> contacts(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                              const ContactOptions& options) {
  return detail::contacts(a, pose_a, b, pose_b, nullptr, options);
}

std::vector<Contact> contacts(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                              PairCache& cache, const ContactOptions& options) {
  return detail::contacts(a, pose_a, b, pose_b, &detail::contentsOf(cache), options);
}

}  // namespace tricover
