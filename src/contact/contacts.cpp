// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/contacts.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "contact/convex_contact.h"
#include "contact/nearest_contact.h"
#include "contact/part_contacts.h"
#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "pair/certificate.h"
#include "pair/collide_by_hierarchy.h"
#include "pair/discs.h"
#include "pair/find_certificate.h"
#include "pair/kernel_order.h"
#include "polygon/cache_access.h"
#include "polygon/convexity.h"

namespace tricover {
namespace detail {
namespace {

/// Of regions that don't overlap.
std::vector<Contact> contactsBeside(const PosedPair& pair, const ContactOptions& options) {
  const double margin = options.margin;
  const CollideOptions grown{margin, 0};
  if (margin == 0 || !collideByHierarchy(pair, grown, 0, Wanted::Answer).collides) return {};
  return {contactBeside(pair, margin)};
}

std::vector<Contact> allContacts(const PosedPair& pair, const ContactOptions& options) {
  if (cornersOf(pair.a) == nullptr || cornersOf(pair.b) == nullptr) return partContacts(pair, nullptr, options);
  const SeparatingAxes axes(pair);
  if (axes.verdict() == SeparatingAxes::Apart) return {};
  if (axes.verdict() == SeparatingAxes::Meet)
    if (const std::optional<Contact> contact = convexContact(pair, axes, options.margin)) return {1, *contact};
  return partContacts(pair, &axes, options);
}

std::vector<Contact> deepestContacts(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                                     PairCacheContents* cache, const ContactOptions& options) {
  if (gapOfDiscs(PosedPair(a, pose_a, b, pose_b), options.margin) >= 0) return {};
  Certificate* certificate = cache != nullptr ? &cache->collision : nullptr;
  Recollection known{};
  if (certificate != nullptr && certificate->back_off.isOn()) {
    countDown(*certificate, a, pose_a, b, pose_b);
    certificate = nullptr;
  } else if (certificate != nullptr) {
    known = recall(*certificate, a, pose_a, b, pose_b, options.margin);
  }
  if (known.certain && !known.collides) return {};
  const PosedPair pair(a, pose_a, b, pose_b);
  std::vector<Contact> result = allContacts(pair, options);
  if (result.empty()) result = contactsBeside(pair, options);
  if (certificate != nullptr && result.empty())
    renewCertificate(a, pose_a, b, pose_b, *certificate, known, {options.margin, 0});
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
  requireRigid(pose_a, pose_b);
  if (options.touching != Touching::Collides && !collide(a, pose_a, b, pose_b, {options.margin, 0, options.touching}))
    return {};
  return inKernelOrder(
      a.data(), pose_a, b.data(), pose_b,
      [&](const auto&... operands) { return deepestContacts(operands..., cache, options); },
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
