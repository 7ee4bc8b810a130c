// SPDX-License-Identifier: BSD-3-Clause
// Certificates of pairs: see SceneState.
#include "scene/scene_state.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "numbers/rounding.h"
#include "overlay/interiors.h"
#include "pair/kernel_order.h"
#include "scene/in_parallel.h"

namespace tricover::detail {
namespace {

/// A pair's certificate looks ahead for this number of moves. A PairCache looks farther (kStepsAhead), but most pairs
/// of a crowd that come near soon separate.
constexpr double kPairSteps = 1;

}  // namespace

void SceneState::listFresh(Slot body) {
  if (!bodies[body].fresh) fresh.push_back(body);
  bodies[body].fresh = true;
}

void SceneState::listDue(Slot body) {
  if (!bodies[body].listed) due.push_back(body);
  bodies[body].listed = true;
}

Slot SceneState::slot(BodyHandle body) const {
  if (has(body)) return Scene::indexOf(body);
  const bool was_there = Scene::indexOf(body) < bodies.size() && body <= handleOf(Scene::indexOf(body));
  throw std::out_of_range(refusal("body", "the scene has none of the handle " + std::to_string(body),
                                  was_there ? "it has been removed" : ""));
}

/// Reserves memory for more bodies, so that neither putting them into the scene nor moving them throws.
void SceneState::makeRoomFor(std::size_t more) {
  const std::size_t anew = more - std::min(more, free_bodies.size());
  if (bodies.size() + anew > kMostBodies) throw std::length_error(refusal("scene", "more than 2^28 bodies"));
  makeRoom(bodies, anew);
  makeRoom(tenancies, anew);
  for (auto* list : {&waiting, &fresh, &due}) list->reserve(bodies.capacity());
  makeRoom(free_bodies, unreported.size());
}

Slot SceneState::put(const Polygon& polygon, const Pose& pose, const BodyOptions& options) {
  const bool anew = free_bodies.empty();
  const Slot body = anew ? static_cast<Slot>(bodies.size()) : free_bodies.back();
  BodyState state{polygon, pose, options, 0, {}, 0, 0, 0, {}, false, false, false};
  if (anew) {
    bodies.push_back(std::move(state));
    tenancies.emplace_back();
  } else {
    // Lists may still hold a removed body of this slot.
    const BodyState& old = bodies[body];
    state.waits = old.waits, state.fresh = old.fresh, state.listed = old.listed;
    bodies[body] = std::move(state);
    free_bodies.pop_back();
  }
  ++tenancies[body].changes;
  if (!bodies[body].waits) waiting.push_back(body);
  bodies[body].waits = true;
  settling.is_done.store(false, std::memory_order_relaxed);
  listFresh(body);
  listDue(body);
  ++count;
  return body;
}

void SceneState::settle() {
  const std::lock_guard<std::mutex> lock(settling.mutex);
  if (!settling.is_done.load(std::memory_order_relaxed)) placeWaiting();
  settling.is_done.store(true, std::memory_order_release);
}

/// Puts the waiting bodies into the tree, one by one if they are few. All are packed anew once half of the boxes have
/// changed.
void SceneState::placeWaiting() {
  if (2 * (tree.changes() + waiting.size()) < count) {
    for (const Slot body : waiting)
      if (isUsed(body) && !tree.holds(body)) tree.insert(body, newBox(body));
  } else {
    std::vector<BoxTree::Entry> entries;
    entries.reserve(count);
    for (Slot body = 0; body < bodies.size(); ++body)
      if (isUsed(body)) entries.push_back({tree.holds(body) ? tree.boundsOf(body) : newBox(body), body});
    tree.pack(entries);
  }
  for (const Slot body : waiting) bodies[body].waits = false;
  std::vector<Slot>().swap(waiting);
}

/// Adds the new pairs of a body whose box is new, except the pairs that another such body with a lower slot finds.
void SceneState::findPairs(Slot body, std::vector<SlotPair>& found) const {
  const auto linked = [&](Slot p, Slot q) {
    const auto &links_p = bodies[p].links, &links_q = bodies[q].links;
    const bool first = links_p.size() <= links_q.size();
    const auto& links = first ? links_p : links_q;
    return std::any_of(links.begin(), links.end(), [&](const Link& link) { return link.other == (first ? q : p); });
  };
  tree.visit(tree.boundsOf(body), [&](Slot other) {
    const bool is_found_there = bodies[other].fresh && other <= body;
    if (!is_found_there && mayMeet(body, other) && !linked(body, other))
      found.push_back({std::min(body, other), std::max(body, other)});
    return true;
  });
}

void SceneState::link(const SlotPair& ends) {
  const auto [first, second] = ends;
  if (free_pairs.empty()) {
    pairs.emplace_back();
    free_pairs.push_back(static_cast<std::uint32_t>(pairs.size() - 1));
  }
  const std::uint32_t pair = free_pairs.back();
  // What may throw comes first.
  for (const Slot end : ends) makeRoom(bodies[end].links, 1);
  free_pairs.pop_back();
  pairs[pair] = {
      ends,
      {static_cast<std::uint32_t>(bodies[first].links.size()), static_cast<std::uint32_t>(bodies[second].links.size())},
      {kNoEdge, kNoEdge},
      /*collides*/ false,
      /*reported*/ false};
  bodies[first].links.push_back({-1, pair, second});
  bodies[second].links.push_back({-1, pair, first});
}

/// Finds new pairs on the user's threads, then links them in the order of the list. They are due.
void SceneState::linkFresh(const Parallel& parallel) {
  const auto found = gatherInParallel<SlotPair>(parallel, fresh.size(), [&](std::size_t i, std::vector<SlotPair>& to) {
    if (isUsed(fresh[i])) findPairs(fresh[i], to);
  });
  for (const SlotPair& ends : found) link(ends);
}

/// Removes a pair.
void SceneState::unlink(std::uint32_t index) {
  Pair& pair = pairs[index];
  if (pair.reported) lost.push_back(handlesOf(pair.body[0], pair.body[1]));
  for (const std::size_t end : {0U, 1U}) {
    auto& links = bodies[pair.body[end]].links;
    Link& place = links[pair.link[end]];
    assert(place.pair == index);
    place = links.back();
    links.pop_back();
    if (pair.link[end] < links.size()) {
      Pair& moved = pairs[place.pair];
      moved.link[moved.body[0] == pair.body[end] ? 0 : 1] = pair.link[end];
    }
  }
  pair.reported = pair.collides = false;
  free_pairs.push_back(index);
}

/// A pair's certificate holds while the two bodies together move by less than `room`. Each body gets a share, in the
/// proportion of their average steps.
void SceneState::schedule(const Pair& pair, double room) {
  BodyState &p = bodies[pair.body[0]], &q = bodies[pair.body[1]];
  const double pace = p.step + q.step, part = pace > 0 ? p.step / pace : 0.5;
  // Rounded down, so that the shares' sum isn't above the room: product, difference from 1, sum.
  const double share_p = roundedDown<3>(room * part), share_q = roundedDown<3>(room * (1 - part));
  p.links[pair.link[0]].due = roundedDown<1>(p.moved + share_p);
  q.links[pair.link[1]].due = roundedDown<1>(q.moved + share_q);
}

SceneState::Finding SceneState::look(Pair& pair) {
  const BodyState &p = bodies[pair.body[0]], &q = bodies[pair.body[1]];
  if (!mayMeet(pair.body[0], pair.body[1]) || !tree.boundsOf(pair.body[0]).meets(tree.boundsOf(pair.body[1])))
    return {false, false};
  const double pace = p.step + q.step;
  const CollideOptions options = optionsOf(p.options, q.options);
  // A certificate says nothing of depths.
  const CollideOptions certified = options.margin < 0 ? CollideOptions{} : options;
  Outcome found = inKernelOrder(
      dataOf(p.polygon), p.pose, dataOf(q.polygon), q.pose,
      [&](const auto&... operands) {
        return findCertificateOf(operands..., defectOf(p.pose, q.pose), certified,
                                 {kPairSteps * pace, pace > 0, pair.edge[0], pair.edge[1]});
      },
      [](const Outcome&) {});
  double room = found.collides ? found.clearance : roundedDown<1>(found.clearance - certified.margin);
  if (options.margin < 0 && found.collides) {
    found.collides = collide(p.polygon, p.pose, q.polygon, q.pose, options);
    room = 0;
  }
  pair.edge[0] = found.edge_a;
  pair.edge[1] = found.edge_b;
  schedule(pair, std::max(room, 0.0));
  return {true, found.collides != pair.collides};
}

void SceneState::keep(std::uint32_t index, const Finding& found) {
  if (!found.are_near) return unlink(index);
  Pair& pair = pairs[index];
  if (found.has_changed) {
    changed.push_back(index);
    pair.collides = !pair.collides;
  }
  for (const std::size_t end : {0U, 1U}) {
    BodyState& state = bodies[pair.body[end]];
    state.due = std::min(state.due, state.links[pair.link[end]].due);
  }
}

/// Lists the pairs that are due. A pair that both of its bodies find is listed by the one with the lower slot.
void SceneState::listPairs(const Parallel& parallel) {
  const auto finds = [&](const BodyState& state, const Link& link) {
    return state.listed && !(state.moved < link.due);
  };
  listed_pairs =
      gatherInParallel<std::uint32_t>(parallel, due.size(), [&](std::size_t i, std::vector<std::uint32_t>& to) {
        const Slot body = due[i];
        if (!isUsed(body)) return;
        for (const Link& link : bodies[body].links) {
          if (!finds(bodies[body], link)) continue;
          const Pair& pair = pairs[link.pair];
          const BodyState& other = bodies[link.other];
          if (body < link.other || !finds(other, other.links[pair.link[0]])) to.push_back(link.pair);
        }
      });
}

/// Tests the listed pairs on the user's threads, then keeps the findings in the order of the list. A finding doesn't
/// depend on other findings.
void SceneState::lookAtPairs(const Parallel& parallel) {
  findings.resize(listed_pairs.size());
  makeRoom(changed, listed_pairs.size());
  try {
    inParallelTasks(parallel, listed_pairs.size(), [&](std::size_t i) { findings[i] = look(pairs[listed_pairs[i]]); });
  } catch (...) {  // the findings are lost: all pairs stay due
    for (const std::uint32_t index : listed_pairs)
      for (const std::size_t end : {0U, 1U}) bodies[pairs[index].body[end]].links[pairs[index].link[end]].due = -1;
    throw;
  }
  for (std::size_t i = 0; i < listed_pairs.size(); ++i) keep(listed_pairs[i], findings[i]);
}

/// Brings all certificates and `collisions` up to now.
void SceneState::updateCollisions(const Parallel& parallel) {
  settled();
  linkFresh(parallel);
  listPairs(parallel);
  lookAtPairs(parallel);
  inParallelTasks(parallel, due.size(), [&](std::size_t i) {
    BodyState& state = bodies[due[i]];
    state.due = state.box_until;
    for (const Link& link : state.links) state.due = std::min(state.due, link.due);
    state.listed = false;
  });
  due.clear();
  for (const Slot body : fresh) bodies[body].fresh = false;
  fresh.clear();
  report();
}

/// Reports what has changed since the last report.
void SceneState::report() {
  began.clear();
  ended.swap(lost);
  lost.clear();
  for (const std::uint32_t index : changed) {
    const Pair& pair = pairs[index];
    if (pair.collides == pair.reported) continue;
    (pair.collides ? began : ended).push_back(handlesOf(pair.body[0], pair.body[1]));
    pairs[index].reported = pair.collides;
  }
  changed.clear();
  free_bodies.insert(free_bodies.end(), unreported.begin(), unreported.end());
  unreported.clear();
  if (began.empty() && ended.empty()) return;
  std::sort(began.begin(), began.end());
  std::sort(ended.begin(), ended.end());
  std::vector<BodyPair> kept, now;
  std::set_difference(collisions.begin(), collisions.end(), ended.begin(), ended.end(), std::back_inserter(kept));
  std::merge(kept.begin(), kept.end(), began.begin(), began.end(), std::back_inserter(now));
  collisions.swap(now);
}

}  // namespace tricover::detail
