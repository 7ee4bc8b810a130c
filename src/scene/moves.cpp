// SPDX-License-Identifier: BSD-3-Clause
// Bodies of a scene move: see SceneState.
#include <algorithm>
#include <limits>
#include <utility>

#include "numbers/rigidity.h"
#include "numbers/rounding.h"
#include "pair/certificate.h"
#include "scene/in_parallel.h"
#include "scene/scene_state.h"

namespace tricover::detail {
namespace {

/// A box looks ahead for this number of moves, and by its body's size at most. Each box that a body leaves costs a
/// search of the tree, but a wider box meets more boxes.
constexpr double kBoxSteps = 16;
/// The weight of the last move in the average step.
constexpr double kOfAverage = 0.25;
/// A count beyond this number of body sizes begins anew, so that steps aren't lost to rounding.
constexpr double kLongestPath = 0x1p20;

constexpr double kMost = std::numeric_limits<double>::max();

/// The size is finite, so that a step that overflows is longer.
double sizeOf(const SceneState::BodyState& body) {
  return std::min(dataOf(body.polygon).radius + marginOfBox(body.options.margin), kMost);
}

bool isCoherent(const SceneState::BodyState& body, double step) { return step <= kCoherentPart * sizeOf(body); }

/// The count of motion after a step, and whether the count goes on.
double movedAfter(const SceneState::BodyState& body, double step) { return roundedUp<1>(body.moved + step); }
bool staysCounted(const SceneState::BodyState& body, double step) {
  const double most = std::min(kLongestPath * sizeOf(body), kMost);
  return isCoherent(body, step) && movedAfter(body, step) <= most;
}

}  // namespace

/// Sets `box_until` and returns a box that holds the body until its count reaches that.
Bounds SceneState::newBox(Slot body) {
  BodyState& state = bodies[body];
  const double growth = std::min(kBoxSteps * state.step, sizeOf(state));
  const Bounds box =
      boundsOf(dataOf(state.polygon), state.pose, marginOfBox(state.options.margin) + growth);  // may throw
  state.box_until = roundedDown<1>(state.moved + growth);
  return box;
}

/// Returns a bound of how far the points of a body go that moves to a pose; 0 if it doesn't move.
double SceneState::stepTo(Slot body, const Pose& pose) const {
  const BodyState& state = bodies[body];
  double was[6];
  store(was, state.pose);
  return displacement(dataOf(state.polygon), was, pose);
}

/// Changes the body's own data for a move and returns whether the body is due. Any number of threads may advance
/// different bodies.
bool SceneState::advance(Slot body, const Pose& pose, double step) {
  BodyState& state = bodies[body];
  const bool stays = staysCounted(state, step);
  state.step = isCoherent(state, step) ? state.step + kOfAverage * (step - state.step) : 0;
  state.pose = pose;
  state.clear.forget();
  state.moved = movedAfter(state, step);
  if (!stays) {
    state.moved = 0;
    state.box_until = state.due = -1;
    for (Link& link : state.links) link.due = -1;
  }
  return !(state.moved < state.due);
}

void SceneState::moveBody(Slot body, const Pose& pose) {
  const double step = stepTo(body, pose);
  if (step == 0) return;
  tree.prepareMove();
  if (!advance(body, pose, step)) return;
  listDue(body);
  BodyState& state = bodies[body];
  if (state.moved <= state.box_until || !tree.holds(body)) return;
  tree.move(body, newBox(body));
  listFresh(body);
}

/// Makes all pairs of the body due, so that pairs whose categories no longer meet are found not to collide.
void SceneState::setOptions(Slot body, const BodyOptions& options) {
  tree.prepareMove();
  BodyState& state = bodies[body];
  state.options = options;
  state.clear.forget();
  state.due = -1;
  for (Link& link : state.links) link.due = -1;
  listDue(body);
  if (tree.holds(body)) tree.move(body, newBox(body));
  listFresh(body);
}

void SceneState::setIgnored(Slot first, Slot second, bool becomes_ignored) {
  if (ignores(first, second) == becomes_ignored) return;
  std::set<SlotPair> both{{first, second}, {second, first}};  // what may throw comes first
  setOptions(first, bodies[first].options);                   // so that the pair is due
  if (becomes_ignored)
    ignored.merge(both);
  else
    for (const SlotPair& pair : both) ignored.erase(pair);
}

/// Moves a body unless it leaves its box. Any number of threads may move different bodies.
SceneState::Moving::What SceneState::moveInBox(Slot body, const Pose& pose) {
  BodyState& state = bodies[body];
  const double step = stepTo(body, pose);
  if (step == 0) return Moving::Done;
  if (!(staysCounted(state, step) && movedAfter(state, step) <= state.box_until)) return Moving::Later;
  if (!advance(body, pose, step) || state.listed) return Moving::Done;
  // The body is listed later, by one thread, but its memory is at hand here.
  state.listed = true;
  return Moving::IsDue;
}

/// Checks all moves. Then the user's threads move the bodies that stay in their boxes, and the rest follows one by one.
void SceneState::moveBodies(const std::vector<BodyPose>& poses, const Parallel& parallel) {
  moves.resize(poses.size());
  inParallelTasks(parallel, poses.size(), [&](std::size_t i) {
    moves[i] = {slot(poses[i].body), Moving::Done};
    requireRigid(poses[i].pose, "poses", i);
  });
  ++batch;
  for (Moving& move : moves)
    if (std::exchange(tenancies[move.body].batch, batch) == batch) move.what = Moving::Later;  // the body moves twice
  const auto moveTheRest = [&] {
    for (std::size_t i = 0; i < moves.size(); ++i) {
      if (moves[i].what == Moving::IsDue) due.push_back(moves[i].body);
      if (moves[i].what == Moving::Later) moveBody(moves[i].body, poses[i].pose);
    }
  };
  try {
    inParallelTasks(parallel, poses.size(), [&](std::size_t i) {
      if (moves[i].what != Moving::Later) moves[i].what = moveInBox(moves[i].body, poses[i].pose);
    });
  } catch (...) {  // the user's threads have failed: bodies that they have moved stay moved
    moveTheRest();
    throw;
  }
  moveTheRest();
}

}  // namespace tricover::detail
