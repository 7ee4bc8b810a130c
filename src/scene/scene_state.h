// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <set>
#include <vector>

#include "polygon/polygon_data.h"
#include "scene/bounds.h"
#include "scene/box_tree.h"
#include "scene/clear_box.h"
#include "tricover/scene.h"

namespace tricover::detail {

/// A body's Scene::indexOf().
using Slot = std::uint32_t;
constexpr Slot kNoSlot = ~Slot{0};

/// A BodyFilter whose exception is a slot.
struct SlotFilter {
  std::uint32_t categories;
  Slot except;
};

/// Two bodies, the lower slot first.
using SlotPair = std::array<Slot, 2>;

/// The state of a Scene: the bodies, a tree of boxes around them, and certificates of pairs.
///
/// Each body counts an upper bound of how far its points have moved in all, `moved`. The count never decreases. The
/// body's box in the tree holds it until the count reaches `box_until`. Two bodies whose boxes meet, and whose
/// categories meet, are a pair. A body whose box is new is `fresh`, and its pairs are still to be found. A pair's
/// certificate with a clearance c holds while the two counts together grow by less than c. Each body gets a share of c,
/// and the pair is due when either count reaches its link's `due`. A body's own `due` is the least of its links' and
/// `box_until`. A call of collisions() looks only at bodies that are due.
struct SceneState {
  static constexpr std::uint32_t kMostBodies = std::uint32_t{1} << 28;

  /// A pair, as one of its bodies refers to it.
  struct Link {
    double due;  ///< the count of this body that makes the pair due
    std::uint32_t pair;
    Slot other;
  };

  struct alignas(64) BodyState {
    Polygon polygon;
    Pose pose;
    BodyOptions options;
    double step;  ///< the length of its moves, a moving average
    ClearBox clear;
    double moved, due, box_until;
    std::vector<Link> links;  ///< its pairs
    bool waits;               ///< in `waiting`, and not in the tree
    bool fresh;               ///< in the list of this name
    bool listed;              ///< in the list `due`
  };

  /// Data of a slot that outlive its body.
  struct Tenancy {
    std::uint32_t changes = 0;  ///< bodies added and removed: odd while there is one
    std::uint32_t batch = 0;    ///< the last call of moveBodies() that named the slot
  };

  struct Pair {
    SlotPair body;
    std::uint32_t link[2];    ///< its index among each body's links
    EdgePosition edge[2];     ///< the edges of the last hit, in the kernel's order; or kNoEdge
    bool collides, reported;  ///< by its certificate; by `collisions`. Both are false of a free place
  };

  /// Puts all waiting bodies into the tree. New bodies wait for the next query, because a tree that is packed at once
  /// is better than one that grows. Any number of threads may call this.
  const SceneState& settled() {
    if (!settling.is_done.load(std::memory_order_acquire)) settle();
    return *this;
  }
  void settle();

  /// The lock of settle(), and whether no body waits.
  struct Settling {
    Settling() = default;
    Settling(const Settling& other) : is_done(other.is_done.load()) {}
    std::atomic<bool> is_done{true};
    std::mutex mutex;
  };

  BodyHandle handleOf(Slot body) const { return BodyHandle{tenancies[body].changes / 2} << 32 | body; }
  bool isUsed(Slot body) const { return tenancies[body].changes % 2 != 0; }
  BodyPair handlesOf(Slot first, Slot second) const {
    const BodyHandle p = handleOf(first), q = handleOf(second);
    return {std::min(p, q), std::max(p, q)};
  }
  bool has(BodyHandle body) const {
    return Scene::indexOf(body) < bodies.size() && isUsed(Scene::indexOf(body)) &&
           handleOf(Scene::indexOf(body)) == body;
  }
  Slot slot(BodyHandle body) const;                   ///< throws std::out_of_range
  SlotFilter slots(const BodyFilter& filter) const {  ///< throws as that does
    return {filter.categories, filter.except == kNoBody ? kNoSlot : slot(filter.except)};
  }
  bool passes(const SlotFilter& filter, Slot body) const {
    return (bodies[body].options.category & filter.categories) != 0 && body != filter.except;
  }
  bool mayMeet(Slot first, Slot second) const {
    const BodyState &p = bodies[first], &q = bodies[second];
    return (p.options.category & q.options.mask) != 0 && (q.options.category & p.options.mask) != 0 &&
           !ignores(first, second);
  }
  bool ignores(Slot first, Slot second) const { return ignored.count({first, second}) != 0; }

  void makeRoomFor(std::size_t more);
  Slot put(const Polygon& polygon, const Pose& pose, const BodyOptions& options);
  void placeWaiting();
  Bounds newBox(Slot body);

  // Certificates of pairs.
  double stepTo(Slot body, const Pose& pose) const;
  bool advance(Slot body, const Pose& pose, double step);
  void moveBody(Slot body, const Pose& pose);
  void setOptions(Slot body, const BodyOptions& options);
  void setIgnored(Slot first, Slot second, bool becomes_ignored);
  /// One of many moves, and what is left to do of it.
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
  /// The result of testing a pair.
  struct Finding {
    bool are_near, has_changed;
  };
  Finding look(Pair& pair);
  void keep(std::uint32_t index, const Finding& found);
  void lookAtPairs(const Parallel& parallel);
  void schedule(const Pair& pair, double room);
  void updateCollisions(const Parallel& parallel);
  void report();

  std::vector<BodyState> bodies;
  std::vector<Tenancy> tenancies;
  std::vector<Slot> free_bodies;
  std::vector<Slot> unreported;  ///< removed bodies whose pairs haven't been reported as ended
  std::set<SlotPair> ignored;    ///< pairs that don't meet, each in both orders
  std::size_t count = 0;
  BoxTree tree;
  std::vector<Slot> waiting;  ///< bodies that aren't in the tree yet
  Settling settling;
  std::vector<Pair> pairs;
  std::vector<std::uint32_t> free_pairs;
  std::vector<Slot> fresh, due;             ///< bodies; see above
  std::vector<std::uint32_t> listed_pairs;  ///< to be tested
  std::vector<std::uint32_t> changed;       ///< pairs whose `collides` may differ from what was reported
  std::vector<Finding> findings;            ///< of listed pairs
  std::vector<Moving> moves;                ///< of bodies that are moved together
  std::uint32_t batch = 0;                  ///< counts calls of moveBodies()
  std::vector<BodyPair> lost;               ///< reported pairs that have been removed
  std::vector<BodyPair> collisions, began, ended;
};

/// Reserves room for `more` elements, so that adding them won't throw. Grows as push_back does.
template <typename T>
void makeRoom(std::vector<T>& list, std::size_t more) {
  if (list.capacity() - list.size() < more) list.reserve(list.size() + std::max(more, list.size()));
}

/// The margin of two bodies: the sum, rounded, and finite.
inline double marginSum(double p, double q) {
  constexpr double kMost = std::numeric_limits<double>::max();
  return std::max(std::min(p + q, kMost), -kMost);
}

/// The margin that a box gets: a negative one leaves the box as it is.
inline double marginOfBox(double margin) { return std::max(margin, 0.0); }

/// The options of a query about one body: margins add up, and touching is allowed if either allows it.
inline CollideOptions withBody(const CollideOptions& options, const BodyOptions& body) {
  return {marginSum(options.margin, body.margin), options.tolerance,
          body.touching != Touching::Collides ? body.touching : options.touching};
}

/// The options of two bodies beside each other.
inline CollideOptions optionsOf(const BodyOptions& p, const BodyOptions& q) {
  return withBody({p.margin, 0, p.touching}, q);
}

}  // namespace tricover::detail
