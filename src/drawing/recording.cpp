// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/recording.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include "drawing/recording_page.h"
#include "drawing/recording_state.h"
#include "numbers/errors.h"
#include "numbers/motion.h"
#include "numbers/whole_file.h"

namespace tricover {
namespace {

using detail::RecordedBody;
using detail::RecordedItem;
using detail::RecordedRow;
using detail::RecordingState;

/// A quarter of a pixel at 1024 times the size that fits 2000 pixels, for a body as large as all that is seen.
constexpr double kLinearTolerance = 1.0 / (1 << 22);

std::string nameOf(Scene::Body body) { return "body " + std::to_string(body); }

[[noreturn]] void refuseBody(const std::string& field, Scene::Body body, const std::string& instead) {
  throw std::out_of_range(detail::refusal(field, nameOf(body) + " is not recorded", instead));
}

void requireRecorded(const RecordingState& state, const std::string& field, Scene::Body body) {
  if (state.bodies.count(body) == 0) refuseBody(field, body, "record a frame or a trajectory of it first");
}

void requireRecorded(const RecordingState& state, const std::string& field, const BodyPair& pair) {
  requireRecorded(state, field, pair.first);
  requireRecorded(state, field, pair.second);
}

void requireFiniteNumber(double value, const std::string& field) {
  if (!std::isfinite(value)) detail::refuse(field, "it is not finite");
}

/// Refuses a body that had another polygon: handles of two scenes may be equal.
void requireSamePolygon(const RecordingState& state, const Scene& scene, Scene::Body body) {
  const auto found = state.bodies.find(body);
  if (found != state.bodies.end() && state.shapes[found->second.shape].polygon.id() != scene.polygon(body).id())
    detail::refuse("scene", nameOf(body) + " has another polygon than before", "record one scene a recording");
}

std::size_t shapeOf(RecordingState& state, const Polygon& polygon) {
  const auto [found, is_new] = state.shape_of.emplace(polygon.id(), state.shapes.size());
  if (!is_new) return found->second;
  Eigen::AlignedBox2d box;
  for (const Ring& ring : polygon.rings())
    for (const Vec2& vertex : ring) box.extend(vertex);
  const Vec2 centre = 0.5 * box.min() + 0.5 * box.max();
  double radius = 0;
  for (const Ring& ring : polygon.rings())
    for (const Vec2& vertex : ring)
      radius = std::max(radius, std::hypot(vertex.x() - centre.x(), vertex.y() - centre.y()));
  state.shapes.push_back({polygon, centre, radius});
  return found->second;
}

/// The body's record, which is made if there is none.
RecordedBody& recordOf(RecordingState& state, const Scene& scene, Scene::Body body) {
  const auto [found, is_new] = state.bodies.try_emplace(body);
  if (is_new) {
    found->second.shape = shapeOf(state, scene.polygon(body));
    found->second.name = nameOf(body);
  }
  return found->second;
}

/// How far it has rotated from one linear part to another, if that is all the difference.
std::optional<double> turnBetween(const Eigen::Matrix2d& from, const Eigen::Matrix2d& to) {
  const Eigen::Matrix2d rotation = to * from.transpose();
  const double turn = std::atan2(rotation(1, 0) - rotation(0, 1), rotation(0, 0) + rotation(1, 1));
  const Eigen::Matrix2d turned = Eigen::Rotation2Dd(turn).toRotationMatrix() * from;
  if (!((turned - to).cwiseAbs().maxCoeff() <= kLinearTolerance)) return {};
  return turn;
}

/// Adds the rows of frames in which the body rested, or wasn't there, since its last row.
void fillRows(RecordedBody& record, std::size_t frame) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const RecordedRow last = record.rows.back();
  record.rows.resize(record.last_frame - record.first_frame + 1, last);
  record.rows.resize(frame - record.first_frame, {{kNone, kNone}, kNone});
}

void addRow(RecordedBody& record, const Vec2& origin, std::size_t frame, const Pose& pose, const BodyOptions& options) {
  if (record.rows.empty()) record.first_frame = frame;
  std::optional<double> turn;
  if (!record.looks.empty() && record.looks.back().margin == options.margin &&
      record.looks.back().category == options.category)
    turn = turnBetween(record.looks.back().linear, pose.linear());
  const RecordedRow row = {pose * origin, turn.value_or(0)};
  const bool rests = turn && record.last_frame + 1 == frame && record.rows.back() == row;
  if (!rests && !record.rows.empty()) fillRows(record, frame);
  if (!turn) record.looks.push_back({frame - record.first_frame, options.margin, options.category, pose.linear()});
  if (!rests) record.rows.push_back(row);
  record.last_frame = frame;
}

/// Ends the meetings of pairs that don't meet in this frame, and begins those of others.
void meet(RecordingState& state, std::vector<BodyPair> pairs, std::size_t frame) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<detail::RecordedMeeting> now;
  auto before = state.meets_now.begin();
  const auto endBefore = [&](const BodyPair* pair) {
    for (; before != state.meets_now.end() && (!pair || before->pair < *pair); ++before)
      state.meetings.push_back({before->pair, before->begin, frame});
  };
  for (const BodyPair& pair : pairs) {
    endBefore(&pair);
    const bool met = before != state.meets_now.end() && before->pair == pair;
    now.push_back({pair, met ? before->begin : frame, frame});
    if (met) ++before;
  }
  endBefore(nullptr);
  state.meets_now = std::move(now);
}

/// Adds what is shown with the last frame, or for an interval: all of it or, with an exception, nothing.
void addItems(RecordingState& state, const std::optional<TimeInterval>& when, std::vector<RecordedItem> items) {
  for (const RecordedItem& item : items) {
    for (std::size_t i = 0; i < detail::pointsOf(item.kind); ++i) detail::requireFinite(item.points[i], "point");
    requireFiniteNumber(item.length, "length");
  }
  if (when) {
    requireFiniteNumber(when->begin, "when.begin");
    requireFiniteNumber(when->end, "when.end");
    if (!(when->begin <= when->end)) detail::refuse("when.end", "it is before when.begin");
  } else if (state.times.empty()) {
    detail::refuse("when", "there is no frame yet", "record a frame first, or give a time interval");
  }
  if (items.empty()) return;
  const std::size_t frame = when ? 0 : state.times.size() - 1;
  const bool with_last =
      !state.moments.empty() && !when && !state.moments.back().when && state.moments.back().frame == frame;
  if (!with_last) state.moments.push_back({when, frame, {}});
  for (RecordedItem& item : items) state.moments.back().items.push_back(std::move(item));
}

}  // namespace

SceneRecording::SceneRecording(const std::string& title) : state_(std::make_unique<RecordingState>()) {
  state_->title = title;
}
SceneRecording::~SceneRecording() = default;
SceneRecording::SceneRecording(const SceneRecording& other) : state_(std::make_unique<RecordingState>(*other.state_)) {}
SceneRecording& SceneRecording::operator=(const SceneRecording& other) {
  *state_ = *other.state_;
  return *this;
}

void SceneRecording::frame(double time, const Scene& scene, const std::vector<BodyPair>& meeting) {
  requireFiniteNumber(time, "time");
  if (!state_->times.empty() && !(time > state_->times.back()))
    detail::refuse("time", "it is not later than the last frame's", "give frames times that increase");
  const std::vector<Scene::Body> bodies = scene.bodies();
  for (const Scene::Body body : bodies) requireSamePolygon(*state_, scene, body);
  for (const BodyPair& pair : meeting)
    for (const Scene::Body body : {pair.first, pair.second})
      if (!scene.contains(body)) refuseBody("meeting", body, "give pairs of bodies of the scene");
  const std::size_t frame = state_->times.size();
  for (const Scene::Body body : bodies) {
    RecordedBody& record = recordOf(*state_, scene, body);
    if (record.trajectory_is_given) continue;
    addRow(record, state_->shapes[record.shape].centre, frame, scene.pose(body), scene.options(body));
  }
  meet(*state_, meeting, frame);
  state_->times.push_back(time);
}

void SceneRecording::trajectories(const Scene& scene, const std::vector<BodyTrajectory>& trajectories) {
  std::set<Scene::Body> named;
  for (const BodyTrajectory& each : trajectories) {
    if (!scene.contains(each.body)) refuseBody("trajectories", each.body, "give bodies of the scene");
    const auto found = state_->bodies.find(each.body);
    if (!named.insert(each.body).second || (found != state_->bodies.end() && found->second.trajectory_is_given))
      detail::refuse("trajectories", nameOf(each.body) + " has a trajectory already", "join them to one");
  }
  const std::vector<Scene::Body> bodies = scene.bodies();
  for (const Scene::Body body : bodies) requireSamePolygon(*state_, scene, body);
  for (const Scene::Body body : bodies) {
    RecordedBody& record = recordOf(*state_, scene, body);
    if (record.trajectory_is_given) continue;
    record.trajectory = Trajectory(scene.pose(body));
    record.options = scene.options(body);
  }
  for (const BodyTrajectory& each : trajectories) {
    RecordedBody& record = state_->bodies.at(each.body);
    record.trajectory = each.trajectory;
    record.trajectory_is_given = true;
  }
}

void SceneRecording::name(Scene::Body body, const std::string& name) {
  requireRecorded(*state_, "body", body);
  state_->bodies.at(body).name = name;
}

void SceneRecording::conflicts(const std::vector<PairConflict>& conflicts) {
  for (const PairConflict& each : conflicts) {
    requireRecorded(*state_, "conflicts", each.pair);
    requireFiniteNumber(each.conflict.impact.time, "conflicts.impact.time");
    requireFiniteNumber(each.conflict.end, "conflicts.end");
    if (each.conflict.end < each.conflict.impact.time) detail::refuse("conflicts.end", "it is before impact.time");
    detail::requireFinite(each.conflict.impact.point, "conflicts.impact.point");
    detail::requireFinite(each.conflict.impact.normal, "conflicts.impact.normal");
  }
  state_->conflicts.insert(state_->conflicts.end(), conflicts.begin(), conflicts.end());
}

void SceneRecording::impacts(const std::vector<PairImpact>& impacts) {
  for (const PairImpact& each : impacts) {
    requireRecorded(*state_, "impacts", each.pair);
    requireFiniteNumber(each.impact.time, "impacts.time");
    detail::requireFinite(each.impact.point, "impacts.point");
    detail::requireFinite(each.impact.normal, "impacts.normal");
  }
  state_->impacts.insert(state_->impacts.end(), impacts.begin(), impacts.end());
}

void SceneRecording::contacts(const std::vector<Contact>& contacts, const std::optional<TimeInterval>& when) {
  std::vector<RecordedItem> items;
  for (const Contact& contact : contacts) {
    detail::requireFinite(contact.normal, "normal");
    items.push_back({RecordedItem::kContact, {contact.point, contact.normal}, contact.depth, {}});
  }
  addItems(*state_, when, std::move(items));
}

void SceneRecording::nearest(const DistanceResult& result, const std::optional<TimeInterval>& when) {
  addItems(*state_, when, {{RecordedItem::kNearest, {result.point_a, result.point_b}, result.distance, {}}});
}

void SceneRecording::nearest(const LeastDistance& result) {
  requireFiniteNumber(result.time, "time");
  requireFiniteNumber(result.distance, "distance");
  detail::requireFinite(result.point_a, "point_a");
  detail::requireFinite(result.point_b, "point_b");
  state_->least.push_back(result);
}

void SceneRecording::ray(const Vec2& from, const Vec2& to, const std::optional<BodyRayHit>& hit,
                         const std::optional<TimeInterval>& when) {
  if (hit)
    addItems(*state_, when, {{RecordedItem::kRayHit, {from, to, hit->hit.point}, 0, {}}});
  else
    addItems(*state_, when, {{RecordedItem::kRay, {from, to}, 0, {}}});
}

void SceneRecording::text(const Vec2& position, const std::string& text, const std::optional<TimeInterval>& when) {
  addItems(*state_, when, {{RecordedItem::kText, {position}, 0, text}});
}

std::string SceneRecording::str() const {
  if (state_->bodies.empty()) throw std::logic_error(detail::refusal("SceneRecording", "no body is recorded"));
  return detail::recordingPage(writtenRecording(*state_));
}

void SceneRecording::save(const std::string& path) const { detail::writeWhole(path, str()); }

}  // namespace tricover
