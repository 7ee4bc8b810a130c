// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/contacts.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "contact/convex_contact.h"
#include "contact/part_contacts.h"
#include "numbers/rigidity.h"
#include "pair/discs.h"
#include "pair/facts.h"
#include "pair/find_fact.h"
#include "pair/kernel_order.h"
#include "polygon/cache_access.h"

namespace tricover {
namespace detail {
namespace {

std::vector<Contact> allContacts(const PosedPair& pair, PairFacts* cache) {
  if (gapOfDiscs(Placement(pair.a, pair.pose_a, pair.b, pair.pose_b), 0) >= 0) return {};
  if (!convexOutlineOf(pair.a).isConvexRegion() || !convexOutlineOf(pair.b).isConvexRegion())
    return partContacts(pair, nullptr);
  const SeparatingAxes axes(pair, cache != nullptr ? &cache->contact : nullptr);
  if (axes.verdict() == SeparatingAxes::Apart) return {};
  if (axes.verdict() == SeparatingAxes::Meet)
    if (const std::optional<Contact> contact = convexContact(pair, axes)) return {*contact};
  return partContacts(pair, &axes);
}

std::vector<Contact> deepestContacts(const PosedPair& pair, PairFacts* cache, std::size_t most) {
  Recollection known{};
  if (cache != nullptr && cache->contact.count == 0)
    known = recall(cache->collision, pair.a, pair.pose_a, pair.b, pair.pose_b, 0);
  if (known.certain && !known.collides) return {};
  std::vector<Contact> result = allContacts(pair, cache);
  if (cache != nullptr && result.empty()) {
    Outcome fact{};  // after a jump another may follow: then only the poses are of use
    if (known.coherent) fact = findFact(pair.a, pair.pose_a, pair.b, pair.pose_b, {}, {known.lookahead, true});
    remember(cache->collision, pair.a, pair.pose_a, pair.b, pair.pose_b, false, fact.clearance);
  }
  std::sort(result.begin(), result.end(), [](const Contact& p, const Contact& q) { return p.depth > q.depth; });
  if (result.size() > most) result.erase(result.begin() + static_cast<std::ptrdiff_t>(most), result.end());
  return result;
}

std::vector<Contact> contacts(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                              PairFacts* cache, std::size_t most) {
  requireRigid(pose_a, pose_b);
  return inKernelOrder(
      a.data(), pose_a, b.data(), pose_b,
      [&](const auto&... operands) { return deepestContacts(PosedPair(operands...), cache, most); },
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
                              std::size_t most) {
  return detail::contacts(a, pose_a, b, pose_b, nullptr, most);
}

std::vector<Contact> contacts(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                              PairCache& cache, std::size_t most) {
  return detail::contacts(a, pose_a, b, pose_b, &detail::factsIn(cache), most);
}

}  // namespace tricover
