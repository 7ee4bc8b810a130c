// SPDX-License-Identifier: BSD-3-Clause
#include "contact/translation_probe.h"

#include <utility>

namespace tricover::detail {
namespace {

/// So many pairs of edges that meet near a cell are kept for its parts.
constexpr std::size_t kMostMeetings = 32;

}  // namespace

double TranslationProbe::depthOf(const PosedPair& pair, const Vec2& t, std::size_t i, std::size_t j) const {
  const double depth = inUnits(pair, crossingDepth(pair, i, j));
  if (margin_ == 0) return depth;
  return depth > 0 ? depth + margin_ - 4 * space_.noise() : margin_ - space_.gap(t, i, j) - 4 * space_.noise();
}

double TranslationProbe::depthOf(const MeetingEdges& meeting, const Vec2& t) const {
  const double depth = meeting.depth(t) - 4 * space_.noise();
  if (margin_ == 0 || depth > 0 || depth < -margin_) return depth + margin_;
  return margin_ - space_.gap(t, meeting.edge_a, meeting.edge_b) - 4 * space_.noise();
}

double TranslationProbe::depthOf(const PosedPair& pair, const Vec2& t, const Outcome& outcome) const {
  if (outcome.edge_a >= 0 && outcome.edge_b >= 0)
    return depthOf(pair, t, static_cast<std::size_t>(outcome.edge_a), static_cast<std::size_t>(outcome.edge_b));
  // Boxes within the margin tell of no depth.
  if (outcome.edge_a < 0 && outcome.edge_b < 0 && outcome.clearance == 0) return 0;
  return inUnits(pair, outcome.clearance) + margin_ * (1 - 0x1p-40);
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
  const Outcome outcome = collideByHierarchy(space_.at(t), options_, 0, Wanted::Answer);
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
