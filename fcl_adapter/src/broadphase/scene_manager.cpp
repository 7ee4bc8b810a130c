// SPDX-License-Identifier: BSD-3-Clause
#include "tricover_fcl/scene_manager.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <unordered_map>
#include <utility>

#include "broadphase/footprint.h"
#include "shape/errors.h"
#include "tricover/scene.h"

namespace tricover_fcl {
namespace {

using tricover::BodyHandle;

template <typename Pointer>
Pointer required(Pointer pointer, const char* field) {
  if (pointer == nullptr) refuse(field, "there is none");
  return pointer;
}

}  // namespace

template <typename S>
struct SceneManager<S>::Impl {
  struct Entry {
    Object* object;
    double z_low, z_high;
    std::optional<BodyHandle> body;  ///< none: it takes part in all pairs
    std::uint64_t polygon;           ///< the body's, by its id
    double margin;                   ///< the body's
    std::vector<const Object*> ignored;
  };
  /// What is asked about: a given object, or one of ours.
  struct Query {
    Footprint print;
    const Entry* self;  ///< null unless it is one of ours
  };

  std::vector<Entry> entries;
  std::unordered_map<const Object*, std::size_t> places;  ///< among the entries
  std::vector<std::size_t> place_of_slot;
  std::size_t anywhere = 0;  ///< entries without a body
  tricover::Scene scene;
  /// The scene finds its collisions in a function that isn't const, others ask meanwhile.
  mutable std::shared_mutex mutex;

  const Entry& entryOf(BodyHandle body) const { return entries[place_of_slot[tricover::Scene::indexOf(body)]]; }

  static bool ignores(const Entry& p, const Entry& q) {
    return std::find(p.ignored.begin(), p.ignored.end(), q.object) != p.ignored.end();
  }
  /// Whether a query leaves an entry out. `self` is the entry that is asked about, if it is one of ours, or null.
  static bool isLeftOut(const Entry* self, const Entry& entry) {
    return &entry == self || (self != nullptr && ignores(*self, entry));
  }
  static void erase(std::vector<const Object*>& list, const Object* object) {
    list.erase(std::find(list.begin(), list.end(), object));
  }
  Entry& entryOf(const Object* object, const char* field) {
    const auto found = places.find(object);
    if (found == places.end()) refuse(field, "it isn't registered");
    return entries[found->second];
  }

  void add(Object* object);
  void remove(const Object* object);
  void refresh(Entry& entry);
  void place(Entry& entry, const Footprint& print);

  Query queryFor(const Object* object) const;
  Query queryFor(const Entry& entry) const;
  std::vector<BodyHandle> near(const Shadow& region, double distance, double tolerance) const;
  template <typename Show>
  bool showMeeting(const Query& query, const Show& show) const;
  template <typename Show>
  bool showNear(const Query& query, const S& least, const Show& show) const;
};

template <typename S>
void SceneManager<S>::Impl::add(Object* object) {
  required(object, "object");
  if (!object->collisionGeometry()) refuse("object", "it has no geometry");
  if (!places.emplace(object, entries.size()).second) return;
  entries.push_back({object, 0, 0, std::nullopt, 0, 0, {}});
  ++anywhere;
  place(entries.back(), footprintOf(*object, nullptr));
}

template <typename S>
void SceneManager<S>::Impl::remove(const Object* object) {
  const auto found = places.find(object);
  if (found == places.end()) return;
  Entry& entry = entries[found->second];
  for (const Object* other : entry.ignored) erase(entryOf(other, "object").ignored, object);
  if (entry.body)
    scene.remove(*entry.body);
  else
    --anywhere;
  entry = entries.back();
  if (entry.body) place_of_slot[tricover::Scene::indexOf(*entry.body)] = found->second;
  places[entry.object] = found->second;
  places.erase(found);
  entries.pop_back();
}

template <typename S>
void SceneManager<S>::Impl::refresh(Entry& entry) {
  place(entry, footprintOf(*entry.object, entry.body ? &scene.polygon(*entry.body) : nullptr));
}

/// Where the footprint is. The same polygon is moved, because certificates about it last.
template <typename S>
void SceneManager<S>::Impl::place(Entry& entry, const Footprint& print) {
  const std::optional<BodyHandle> old = entry.body;
  if (print.region) {
    const Shadow& region = *print.region;
    if (old && entry.polygon == region.polygon().id() && entry.margin == region.margin) {
      scene.move(*old, region.pose);
    } else {
      entry.body = scene.add(region.polygon(), region.pose, {region.margin});
      entry.polygon = region.polygon().id();
      entry.margin = region.margin;
      if (const std::size_t slot = tricover::Scene::indexOf(*entry.body); place_of_slot.size() <= slot)
        place_of_slot.resize(slot + 1);
      place_of_slot[tricover::Scene::indexOf(*entry.body)] = places.at(entry.object);
    }
  } else {
    entry.body.reset();
  }
  if (old && entry.body != old) scene.remove(*old);
  if (!old) --anywhere;
  if (!entry.body) ++anywhere;
  entry.z_low = print.z_low;
  entry.z_high = print.z_high;
}

template <typename S>
typename SceneManager<S>::Impl::Query SceneManager<S>::Impl::queryFor(const Object* object) const {
  required(object, "object");
  if (!object->collisionGeometry()) refuse("object", "it has no geometry");
  const auto found = places.find(object);
  return {footprintOf(*object, nullptr), found == places.end() ? nullptr : &entries[found->second]};
}

template <typename S>
typename SceneManager<S>::Impl::Query SceneManager<S>::Impl::queryFor(const Entry& entry) const {
  Footprint print{std::nullopt, entry.z_low, entry.z_high};
  if (entry.body)
    print.region.emplace(&scene.polygon(*entry.body), scene.pose(*entry.body), scene.options(*entry.body).margin);
  return {std::move(print), &entry};
}

/// The bodies within a distance of the region, which may be more by `tolerance`.
template <typename S>
std::vector<BodyHandle> SceneManager<S>::Impl::near(const Shadow& region, double distance, double tolerance) const {
  const double reach = std::min(distance + region.margin, std::numeric_limits<double>::max());
  const std::shared_lock<std::shared_mutex> lock(mutex);
  return scene.colliding(region.polygon(), region.pose, {reach, tolerance});
}

/// Calls show(entry) for all that may collide with what is asked about, until it returns true. Returns whether it did.
template <typename S>
template <typename Show>
bool SceneManager<S>::Impl::showMeeting(const Query& query, const Show& show) const {
  const auto shows = [&](const Entry& entry) {
    return !isLeftOut(query.self, entry) && query.print.sharesHeights(entry.z_low, entry.z_high) && show(entry);
  };
  const auto& region = query.print.region;
  if (!region) return std::any_of(entries.begin(), entries.end(), shows);
  std::optional<BodyHandle> first;  // Many callbacks end the query with one pair. (One of ours hits itself.)
  if (query.self == nullptr) {
    const std::shared_lock<std::shared_mutex> lock(mutex);
    first = scene.anyColliding(region->polygon(), region->pose, {region->margin});
  }
  if (first && shows(entryOf(*first))) return true;
  if (first || query.self != nullptr) {
    for (const BodyHandle body : near(*region, 0, 0)) {
      if (body != first && shows(entryOf(body))) return true;
    }
  }
  return anywhere > 0 &&
         std::any_of(entries.begin(), entries.end(), [&](const Entry& entry) { return !entry.body && shows(entry); });
}

/// The same for all that may be nearer than `least`, which show() may reduce.
template <typename S>
template <typename Show>
bool SceneManager<S>::Impl::showNear(const Query& query, const S& least, const Show& show) const {
  const auto isKnown = [&] { return least < std::numeric_limits<S>::max(); };
  const auto shows = [&](const Entry& entry) {
    const double apart = std::max(entry.z_low - query.print.z_high, query.print.z_low - entry.z_high);
    return !isLeftOut(query.self, entry) && !(isKnown() && apart > static_cast<double>(least)) && show(entry);
  };
  const auto& region = query.print.region;
  if (!region) return std::any_of(entries.begin(), entries.end(), shows);
  if (anywhere > 0 &&
      std::any_of(entries.begin(), entries.end(), [&](const Entry& entry) { return !entry.body && shows(entry); }))
    return true;

  std::optional<BodyHandle> first;
  if (!isKnown()) {
    tricover::DistanceOptions options;
    options.margin = region->margin;
    std::shared_lock<std::shared_mutex> lock(mutex);
    const BodyHandle own = query.self != nullptr ? query.self->body.value_or(tricover::kNoBody) : tricover::kNoBody;
    const auto nearest = scene.nearest(region->polygon(), region->pose, options, tricover::BodyFilter::allBut(own));
    lock.unlock();
    if (nearest) first = nearest->body;
    if (first && shows(entryOf(*first))) return true;
  }
  if (!isKnown()) {
    return std::any_of(entries.begin(), entries.end(),
                       [&](const Entry& entry) { return entry.body && entry.body != first && shows(entry); });
  }
  // What is reported is rounded. Whether another one is as near to the last bits is not worth knowing.
  const double distance = std::max(static_cast<double>(least), 0.0);
  for (const BodyHandle body : near(*region, distance * (1 + 0x1p-40), distance * 0x1p-20)) {
    if (body != first && shows(entryOf(body))) return true;
  }
  return false;
}

template <typename S>
SceneManager<S>::SceneManager() : impl_(std::make_unique<Impl>()) {}

template <typename S>
SceneManager<S>::~SceneManager() = default;

template <typename S>
void SceneManager<S>::registerObject(Object* object) {
  impl_->add(object);
}

template <typename S>
void SceneManager<S>::unregisterObject(Object* object) {
  impl_->remove(object);
}

template <typename S>
void SceneManager<S>::setup() {}

template <typename S>
void SceneManager<S>::update() {
  for (auto& entry : impl_->entries) impl_->refresh(entry);
}

template <typename S>
void SceneManager<S>::update(Object* object) {
  const auto found = impl_->places.find(object);
  if (found != impl_->places.end()) impl_->refresh(impl_->entries[found->second]);
}

template <typename S>
void SceneManager<S>::update(const std::vector<Object*>& objects) {
  for (Object* object : objects) update(object);
}

template <typename S>
void SceneManager<S>::clear() {
  impl_ = std::make_unique<Impl>();
}

template <typename S>
void SceneManager<S>::setIgnored(const Object* a, const Object* b, bool ignored) {
  auto &p = impl_->entryOf(a, "a"), &q = impl_->entryOf(b, "b");
  if (a == b) refuse("b", "it is a, and an object never meets itself");
  if (Impl::ignores(p, q) == ignored) return;
  if (ignored) {
    p.ignored.push_back(b);
    q.ignored.push_back(a);
  } else {
    Impl::erase(p.ignored, b);
    Impl::erase(q.ignored, a);
  }
}

template <typename S>
void SceneManager<S>::getObjects(std::vector<Object*>& objects) const {
  objects.clear();
  for (const auto& entry : impl_->entries) objects.push_back(entry.object);
}

template <typename S>
bool SceneManager<S>::empty() const {
  return impl_->entries.empty();
}

template <typename S>
std::size_t SceneManager<S>::size() const {
  return impl_->entries.size();
}

template <typename S>
void SceneManager<S>::collide(void* data, Collision callback) const {
  std::unique_lock<std::shared_mutex> lock(impl_->mutex);
  const std::vector<tricover::BodyPair> pairs = impl_->scene.collisions();
  lock.unlock();
  const auto shows = [&](const auto& p, const auto& q) {
    return p.z_low <= q.z_high && q.z_low <= p.z_high && !Impl::ignores(p, q) && callback(p.object, q.object, data);
  };
  for (const tricover::BodyPair& pair : pairs) {
    if (shows(impl_->entryOf(pair.first), impl_->entryOf(pair.second))) return;
  }
  if (impl_->anywhere == 0) return;
  for (const auto& p : impl_->entries) {
    if (p.body) continue;
    for (const auto& q : impl_->entries) {
      if ((q.body || &q > &p) && shows(p, q)) return;
    }
  }
}

template <typename S>
void SceneManager<S>::collide(Object* object, void* data, Collision callback) const {
  impl_->showMeeting(impl_->queryFor(object), [&](const auto& entry) { return callback(entry.object, object, data); });
}

template <typename S>
void SceneManager<S>::collide(Manager* other, void* data, Collision callback) const {
  if (required(other, "manager") == this) return collide(data, callback);
  std::vector<Object*> objects;
  other->getObjects(objects);
  for (Object* object : objects) {
    const auto show = [&](const auto& entry) { return callback(entry.object, object, data); };
    if (impl_->showMeeting(impl_->queryFor(object), show)) return;
  }
}

template <typename S>
void SceneManager<S>::distance(void* data, Distance callback) const {
  S least = std::numeric_limits<S>::max();
  for (const auto& own : impl_->entries) {
    // A pair is shown when its first object is asked about. While nothing is known, all pairs have been.
    const auto show = [&](const auto& entry) {
      return &entry > &own && callback(own.object, entry.object, data, least);
    };
    if (impl_->showNear(impl_->queryFor(own), least, show)) return;
  }
}

template <typename S>
void SceneManager<S>::distance(Object* object, void* data, Distance callback) const {
  S least = std::numeric_limits<S>::max();
  impl_->showNear(impl_->queryFor(object), least,
                  [&](const auto& entry) { return callback(entry.object, object, data, least); });
}

template <typename S>
void SceneManager<S>::distance(Manager* other, void* data, Distance callback) const {
  if (required(other, "manager") == this) return distance(data, callback);
  std::vector<Object*> objects;
  other->getObjects(objects);
  S least = std::numeric_limits<S>::max();
  for (Object* object : objects) {
    const auto show = [&](const auto& entry) { return callback(entry.object, object, data, least); };
    if (impl_->showNear(impl_->queryFor(object), least, show)) return;
  }
}

template class SceneManager<float>;
template class SceneManager<double>;

}  // namespace tricover_fcl
