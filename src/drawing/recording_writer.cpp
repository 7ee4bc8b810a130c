// SPDX-License-Identifier: BSD-3-Clause
// Writes what recording_page.cpp reads, in its order.
#include <algorithm>
#include <cmath>
#include <limits>

#include "drawing/recording_columns.h"
#include "drawing/recording_state.h"
#include "numbers/cubic.h"

namespace tricover::detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kSamples = 8;  ///< of a leg, for the box around everything

/// Which parts of a leg are written; all others are as they were, or 0.
constexpr std::size_t kJump = 1, kPivot = 2, kShift = 4, kCubic = 8, kTurn = 16, kCubicTurn = 32;

/// The box and the time interval around all that is recorded.
struct Extent {
  Eigen::AlignedBox2d box;
  double begin = kInfinity, end = -kInfinity;

  void include(const Vec2& centre, double radius) {
    box.extend(Vec2(centre - Vec2(radius, radius)));
    box.extend(Vec2(centre + Vec2(radius, radius)));
  }
  void include(double time) {
    if (!std::isfinite(time)) return;
    begin = std::min(begin, time);
    end = std::max(end, time);
  }
  double size() const { return box.isEmpty() ? 0 : std::min(box.sizes().maxCoeff(), 1e150); }
};

double marginOf(double margin) { return std::max(0.0, margin); }

/// Includes a body that rests, by its vertices: a room is as large as its walls, not as a disc around them.
void includeAtRest(Extent& extent, const RecordedShape& shape, const Vec2& centre, const Eigen::Matrix2d& linear,
                   double margin) {
  for (const Ring& ring : shape.polygon.rings())
    for (const Vec2& vertex : ring) extent.include(centre + linear * (vertex - shape.centre), marginOf(margin));
}

void include(Extent& extent, const RecordedShape& shape, const RecordedBody& body) {
  if (body.follows()) {
    const Trajectory& trajectory = *body.trajectory;
    if (trajectory.rests()) {
      const Pose pose = trajectory.at(0);
      return includeAtRest(extent, shape, pose * shape.centre, pose.linear(), body.options.margin);
    }
    for (const Leg& leg : trajectory.legs())
      for (int i = 0; i <= kSamples; ++i)
        extent.include(leg.motion.at(static_cast<double>(i) / kSamples) * shape.centre,
                       shape.radius + marginOf(body.options.margin));
    extent.include(trajectory.begin());
    extent.include(trajectory.end());
  } else if (body.rows.size() == 1) {
    includeAtRest(extent, shape, body.rows[0].centre, body.looks[0].linear, body.looks[0].margin);
  } else {
    double margin = 0;
    for (const RecordedLook& look : body.looks) margin = std::max(margin, look.margin);
    for (const RecordedRow& row : body.rows)
      if (!std::isnan(row.turn)) extent.include(row.centre, shape.radius + margin);
  }
}

Extent extentOf(const RecordingState& state) {
  Extent extent;
  for (const auto& [handle, body] : state.bodies) include(extent, state.shapes[body.shape], body);
  for (const double time : state.times) extent.include(time);
  for (const PairConflict& each : state.conflicts)
    for (const double time : {each.conflict.impact.time, each.conflict.end}) extent.include(time);
  for (const PairImpact& each : state.impacts) extent.include(each.impact.time);
  for (const LeastDistance& each : state.least) extent.include(each.time);
  for (const RecordedMoment& each : state.moments)
    if (each.when)
      for (const double time : {each.when->begin, each.when->end}) extent.include(time);
  if (extent.begin > extent.end) extent.begin = extent.end = 0;
  // A lone point gets room that the digits of its coordinates can show.
  const Vec2 most = Vec2::Constant(1e150), low = extent.box.min().cwiseMax(-most).cwiseMin(most),
             high = extent.box.max().cwiseMin(most).cwiseMax(-most);
  const double far = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  const double size = (high - low).maxCoeff(), room = size > 1e-9 * far ? 0 : std::max(0.5, 1e-6 * far);
  extent.box = {low - Vec2(room, room), high + Vec2(room, room)};
  return extent;
}

class Writer {
 public:
  Writer(const RecordingState& state) : state_(state), extent_(extentOf(state)) {
    for (const auto& [handle, body] : state.bodies) index_.emplace(handle, index_.size());
  }

  std::string written() {
    columns_.real(extent_.box.min());
    columns_.real(extent_.box.max());
    columns_.real(extent_.begin);
    columns_.real(extent_.end);
    columns_.count(state_.shapes.size());
    for (const RecordedShape& shape : state_.shapes) write(shape);
    columns_.count(state_.times.size());
    for (const double time : state_.times) columns_.real(time);
    columns_.count(state_.bodies.size());
    for (const auto& [handle, body] : state_.bodies) write(body);
    writeMeetings();
    writeMarks();
    writeMoments();
    return columns_.json(state_.title);
  }

 private:
  void write(const RecordedShape& shape) {
    const Polygon& polygon = shape.polygon;
    const double unit = unitOf(shape.radius);
    columns_.count((polygon.fillRule() == FillRule::NonZero ? 1 : 0) + (polygon.isComplement() ? 2 : 0));
    columns_.real(shape.centre);
    columns_.real(unit);
    columns_.count(polygon.rings().size());
    for (const Ring& ring : polygon.rings()) {
      columns_.count(ring.size());
      for (const Vec2& vertex : ring) {
        columns_.single((vertex.x() - shape.centre.x()) / unit);
        columns_.single((vertex.y() - shape.centre.y()) / unit);
      }
    }
  }

  void write(const RecordedBody& body) {
    columns_.count(body.shape);
    columns_.text(body.name);
    columns_.count(body.follows());
    if (body.follows()) {
      columns_.real(body.options.margin);
      columns_.count(body.options.category);
      writeLegs(*body.trajectory, state_.shapes[body.shape]);
    } else {
      writeRows(body);
    }
  }

  void writeRows(const RecordedBody& body) {
    columns_.count(body.looks.size());
    for (const RecordedLook& look : body.looks) {
      columns_.count(look.row);
      columns_.real(look.margin);
      columns_.count(look.category);
      columns_.real(look.linear);
    }
    const std::size_t count = body.last_frame - body.first_frame + 1;
    columns_.count(body.first_frame);
    columns_.count(count);
    std::vector<double> x, y, turn;
    for (const RecordedRow& row : body.rows) {
      x.push_back(row.centre.x());
      y.push_back(row.centre.y());
      turn.push_back(row.turn);
    }
    for (std::vector<double>* column : {&x, &y, &turn}) {
      const double last = column->back();
      column->resize(count, last);
      columns_.values(*column);
    }
  }

  /// Follows the page: where its pivot is, how far it has rotated from `base`.
  struct PageLeg {
    Vec2 position, pivot;
    double turn;
    Eigen::Matrix2d base;
    Eigen::Matrix2d linear() const { return Eigen::Rotation2Dd(turn).toRotationMatrix() * base; }
  };

  void writeLegs(const Trajectory& trajectory, const RecordedShape& shape) {
    const std::vector<Leg> none;
    const std::vector<Leg>& legs = trajectory.rests() ? none : trajectory.legs();
    columns_.count((trajectory.appears() ? 1 : 0) + (trajectory.vanishes() ? 2 : 0));
    columns_.count(legs.size() + 1);
    PageLeg page = {Vec2::Zero(), Vec2::Zero(), 0, Eigen::Matrix2d::Zero()};
    for (const Leg& leg : legs) writeLeg(page, leg.begin, leg.motion, shape);
    writeLeg(page, trajectory.end(), Motion::still(trajectory.at(trajectory.end())), shape);
  }

  /// A leg begins where the one before has ended in the page, unless that is another place.
  void writeLeg(PageLeg& page, double begin, const Motion& motion, const RecordedShape& shape) {
    const Cubic<Vec2> path = pathOf(motion);
    const Cubic<double> rotation = rotationOf(motion);
    const Vec2 pivot = rotation.isZero() ? page.pivot : Vec2(motion.pivot - shape.centre);
    const Eigen::Matrix2d linear = motion.start.linear();
    const Vec2 position = motion.start * Vec2(shape.centre + pivot);
    const Vec2 moved = page.position + page.linear() * (pivot - page.pivot);
    const double off = (moved - position).norm() + (page.linear() - linear).norm() * (shape.radius + pivot.norm());
    const bool jumps = !(off <= extent_.size() / (1 << 30)), turns_pivot = pivot != page.pivot;
    const bool cubic = !path.isStraight(), cubic_turn = !rotation.isStraight();
    columns_.count((jumps ? kJump : 0) + (turns_pivot ? kPivot : 0) + (isNull(path.first) ? 0 : kShift) +
                   (cubic ? kCubic : 0) + (isNull(rotation.first) ? 0 : kTurn) + (cubic_turn ? kCubicTurn : 0));
    columns_.real(begin);
    if (turns_pivot) columns_.real(pivot);
    if (jumps) {
      columns_.real(position);
      columns_.real(linear);
    }
    if (!isNull(path.first)) columns_.real(path.first);
    if (cubic) {
      columns_.real(path.second);
      columns_.real(path.third);
    }
    if (!isNull(rotation.first)) columns_.real(rotation.first);
    if (cubic_turn) {
      columns_.real(rotation.second);
      columns_.real(rotation.third);
    }
    page = {jumps ? position : moved, pivot, jumps ? 0 : page.turn, jumps ? linear : page.base};
    page.position += path.at(1);
    page.turn += rotation.at(1);
  }

  void writePair(const BodyPair& pair) {
    columns_.count(index_.at(pair.first));
    columns_.count(index_.at(pair.second));
  }

  void writeMeetings() {
    std::vector<RecordedMeeting> all = state_.meetings;
    all.insert(all.end(), state_.meets_now.begin(), state_.meets_now.end());
    std::sort(all.begin(), all.end(), [](const RecordedMeeting& p, const RecordedMeeting& q) {
      return p.begin != q.begin ? p.begin < q.begin : p.pair < q.pair;
    });
    columns_.count(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      writePair(all[i].pair);
      columns_.count(all[i].begin);
      columns_.count(all[i].end);
    }
  }

  void writeImpact(const Impact& impact) {
    columns_.real(impact.time);
    columns_.real(impact.point);
    columns_.real(impact.normal);
  }

  void writeMarks() {
    columns_.count(state_.conflicts.size());
    for (const PairConflict& each : state_.conflicts) {
      writePair(each.pair);
      writeImpact(each.conflict.impact);
      columns_.real(each.conflict.end);
      columns_.count((each.conflict.budget_ended ? 1 : 0) + (each.conflict.meets_at_end ? 2 : 0));
    }
    columns_.count(state_.impacts.size());
    for (const PairImpact& each : state_.impacts) {
      writePair(each.pair);
      writeImpact(each.impact);
      columns_.count(each.impact.budget_ended ? 1 : 0);
    }
    columns_.count(state_.least.size());
    for (const LeastDistance& each : state_.least) {
      columns_.real(each.time);
      columns_.real(each.distance);
      columns_.real(each.point_a);
      columns_.real(each.point_b);
    }
  }

  void writeMoments() {
    std::vector<double> x, y;
    columns_.count(state_.moments.size());
    for (const RecordedMoment& moment : state_.moments) {
      columns_.count(moment.when.has_value());
      if (moment.when) {
        columns_.real(moment.when->begin);
        columns_.real(moment.when->end);
      } else {
        columns_.count(moment.frame);
      }
      columns_.count(moment.items.size());
      for (const RecordedItem& item : moment.items) write(item, x, y);
    }
    columns_.count(x.size());
    columns_.values(x);
    columns_.values(y);
  }

  void write(const RecordedItem& item, std::vector<double>& x, std::vector<double>& y) {
    columns_.count(item.kind);
    for (std::size_t i = 0; i < pointsOf(item.kind); ++i) {
      x.push_back(item.points[i].x());
      y.push_back(item.points[i].y());
    }
    if (item.kind == RecordedItem::kContact) {
      columns_.single(item.points[1].x());
      columns_.single(item.points[1].y());
    }
    if (item.kind <= RecordedItem::kNearest) columns_.real(item.length);
    if (item.kind == RecordedItem::kText) columns_.text(item.text);
  }

  const RecordingState& state_;
  const Extent extent_;
  RecordingColumns columns_;
  std::map<BodyHandle, std::size_t> index_;
};

}  // namespace

std::string writtenRecording(const RecordingState& state) { return Writer(state).written(); }

}  // namespace tricover::detail
