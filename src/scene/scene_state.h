// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <vector>

#include "polygon/polygon_data.h"
#include "scene/bounds.h"
#include "scene/box_tree.h"
#include "scene/clear_box.h"
#include "scene/world_discs.h"
#include "tricover/scene.h"

namespace tricover::detail {

/// The place of a body among all, at the most as many as have been there at once: slotOf() its handle.
using Slot = std::uint32_t;
constexpr Slot kNoSlot = ~Slot{0};

/// A BodyFilter of a scene.
struct SlotFilter {
  std::uint32_t categories;
  Slot except;
};

/// Two bodies, each by its place.
struct SlotPair {
  Slot first, second;
};

/// What a Scene holds: the bodies, a tree of boxes around them, and kinetic facts about pairs of them.
///
/// A body counts how far any of its points has moved at the most, `moved`, which never decreases. Its box in the tree
/// holds it until that reaches `box_until`. Two bodies whose boxes meet, and that may meet, are a pair, unless one of
/// them is `fresh`: its box is new, and its pairs are to be found. A pair's fact (CollisionFact) with a clearance c
/// holds while the two counts together grow by less than c, so while neither passes its share of that: its links'
/// `due`. A body's own `due` is the first of all these. So what isn't due is as it was, and collisions() looks at the
/// rest.
struct SceneState {
  static constexpr std::uint32_t kMostBodies = std::uint32_t{1} << 28;

  /// A pair, as one of its bodies sees it.
  struct Link {
    double due;  ///< of this body's count
    std::uint32_t pair;
    Slot other;
  };

  /// Four cache lines: a query that shows a body reads two of them, one that looks close three.
  struct alignas(64) BodyState {
    Polygon polygon;
    Pose pose;
    BodyOptions options;
    double step;  ///< how far it goes at a move, as a moving average
    mutable KeptDiscs discs;
    ClearBox clear;
    double moved, due, box_until;
    std::vector<Link> links;  ///< its pairs
    bool waits;               ///< in the list of these, and not in the tree
    bool fresh;               ///< in the list of these
    bool listed;              ///< in the list of these
  };

  /// What is asked of a slot where the body itself isn't.
  struct Tenancy {
    std::uint32_t changes = 0;  ///< comings and goings of bodies: odd while there is one
    std::uint32_t turn = 0;     ///< the last call of moveBodies() that named it
  };

  struct Pair {
    Slot body[2];             ///< the lower slot first
    std::uint32_t link[2];    ///< its place among either one's links
    std::ptrdiff_t edge[2];   ///< that made the last hit, in the kernel's order; -1: none
    bool used;                ///< false: the place is free
    bool collides, reported;  ///< by its fact; by `collisions`
  };

  /// With all bodies in the tree: those that came since the last query are put there by the next one, together, so that
  /// it is well packed. Any number of threads may ask.
  const SceneState& settled() {
    if (!settling.is_done.load(std::memory_order_acquire)) settle();
    return *this;
  }
  void settle();

  /// Whose turn it is to settle, and whether nobody waits.
  struct Settling {
    Settling() = default;
    Settling(const Settling& other) : is_done(other.is_done.load()) {}
    std::atomic<bool> is_done{true};
    std::mutex turn;
  };

  BodyHandle handleOf(Slot body) const { return BodyHandle{tenancies[body].changes / 2} << 32 | body; }
  bool isUsed(Slot body) const { return tenancies[body].changes % 2 != 0; }
  BodyPair handlesOf(const Pair& pair) const {
    const BodyHandle p = handleOf(pair.body[0]), q = handleOf(pair.body[1]);
    return {std::min(p, q), std::max(p, q)};
  }
  bool has(BodyHandle body) const {
    return slotOf(body) < bodies.size() && isUsed(slotOf(body)) && handleOf(slotOf(body)) == body;
  }
  Slot slot(BodyHandle body) const;                   ///< throws std::out_of_range
  SlotFilter slots(const BodyFilter& filter) const {  ///< throws as that does
    return {filter.categories, filter.except == kNoBody ? kNoSlot : slot(filter.except)};
  }
  bool passes(const SlotFilter& filter, Slot body) const {
    return (bodies[body].options.category & filter.categories) != 0 && body != filter.except;
  }
  bool mayMeet(const BodyState& p, const BodyState& q) const {
    return (p.options.category & q.options.mask) != 0 && (q.options.category & p.options.mask) != 0;
  }

  void makeRoomFor(std::size_t more);
  Slot put(const Polygon& polygon, const Pose& pose, const BodyOptions& options);
  void placeWaiting();
  Bounds newBox(Slot body);

  // Kinetic facts.
  double stepTo(Slot body, const Pose& pose) const;
  bool advance(Slot body, const Pose& pose, double step);
  void moveBody(Slot body, const Pose& pose);
  void setOptions(Slot body, const BodyOptions& options);
  /// One of many moves, and what is left to be done of it.
  struct Moving {
    enum What : std::uint8_t { Done, IsDue, Later };
    Slot body;
    What what;
  };
  Moving::What moveInBox(Slot body, const Pose& pose);
  void moveBodies(const std::vector<BodyPose>& poses, const Parallel& parallel);
  void listFresh(Slot body);
  void listDue(Slot body);
  void unlink(std::uint32_t index);
  void findPairs(Slot body, std::vector<SlotPair>& found) const;
  void link(const SlotPair& ends);
  void linkFresh(const Parallel& parallel);
  void listPairs(const Parallel& parallel);
  /// What a look at a pair leaves to be done, beside what it changes of the pair and its links alone.
  struct Finding {
    bool are_near, has_changed;
    bool is_unlisted;  ///< the body of one end isn't listed, and may be due sooner now
  };
  Finding look(Pair& pair);
  void keep(std::uint32_t index, const Finding& found);
  void lookAtPairs(const Parallel& parallel);
  void schedule(const Pair& pair, double room);
  void updateCollisions(const Parallel& parallel);
  void report();

  std::vector<BodyState> bodies;
  std::vector<Tenancy> tenancies;  ///< of their slots
  std::vector<Slot> free_bodies;
  std::vector<Slot> unreported;  ///< removed, but their pairs haven't been reported as ended
  std::size_t count = 0;
  BoxTree tree;
  std::vector<Slot> waiting;  ///< bodies that are to be put into the tree
  Settling settling;
  std::vector<Pair> pairs;
  std::vector<std::uint32_t> free_pairs;
  std::vector<Slot> fresh, due;             ///< bodies; see above
  std::vector<std::uint32_t> listed_pairs;  ///< to be looked at
  std::vector<std::uint32_t> changed;       ///< pairs whose `collides` may differ from what was reported
  std::vector<Finding> findings;            ///< of listed pairs, while they are looked at
  std::vector<Moving> moves;                ///< of bodies that are moved together
  std::uint32_t turn = 0;                   ///< of moving bodies together
  std::vector<BodyPair> lost;               ///< reported pairs that are no pairs any more
  std::vector<BodyPair> collisions, began, ended;
};

/// Room for `more` things, so that adding them won't throw. Grows as push_back does.
template <typename T>
void makeRoom(std::vector<T>& list, std::size_t more) {
  if (list.capacity() - list.size() < more) list.reserve(list.size() + std::max(more, list.size()));
}

/// The margin of two bodies: the sum, rounded, and at most the largest double.
inline double marginSum(double p, double q) { return std::min(p + q, std::numeric_limits<double>::max()); }

/// The options of a query about one body: margins add up, and touching is allowed if either allows it.
inline CollideOptions withBody(CollideOptions options, const BodyOptions& body) {
  if (body.touching != Touching::Collides) options.touching = body.touching;
  options.margin = marginSum(options.margin, body.margin);
  return options;
}

}  // namespace tricover::detail
