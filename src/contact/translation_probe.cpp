// SPDX-License-Identifier: BSD-3-Clause
#include "contact/translation_probe.h"

#include <utility>

namespace tricover::detail {
namespace {

/// So many pairs of edges that meet near a cell are kept for its parts.
constexpr std::size_t kMostMeetings = 32;

}  // namespace

double TranslationProbe::depthOf(const PosedPair& pair, const Outcome& outcome) const {
  if (outcome.edge_a < 0 || outcome.edge_b < 0) return inUnits(outcome.clearance);
  return inUnits(
      crossingDepth(pair, static_cast<std::size_t>(outcome.edge_a), static_cast<std::size_t>(outcome.edge_b)));
}

bool TranslationProbe::overlapAround(const Vec2& t, double radius) {
  for (MeetingEdges& meeting : near_) {
    if (depthOf(meeting, t) <= radius) continue;
    std::swap(meeting, near_.front());
    return true;
  }
  return false;
}

void TranslationProbe::keep(const Outcome& outcome) {
  if (outcome.edge_a >= 0 && outcome.edge_b >= 0 && near_.size() < kMostMeetings)
    near_.push_back(
        space_.meetingOf(static_cast<std::size_t>(outcome.edge_a), static_cast<std::size_t>(outcome.edge_b)));
}

bool TranslationProbe::isFree(Vec2& t) {
  if (overlapAround(t, 0)) return false;
  ++queries_;
  const Outcome outcome = collideByHierarchy(space_.at(t), {}, 0, Wanted::Answer);
  if (outcome.collides) keep(outcome);
  return !outcome.collides;
}

bool TranslationProbe::see(const MeetingEdges& meeting, const Vec2& t, double radius) {
  const double depth = depthOf(meeting, t);
  overlaps_ |= depth > 0;
  if (depth > -radius && near_.size() < kMostMeetings) near_.push_back(meeting);
  return depth >= radius;
}

}  // namespace tricover::detail
