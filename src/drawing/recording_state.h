// SPDX-License-Identifier: BSD-3-Clause
// All that is recorded, as it was given: recording.cpp fills it, recording_writer.cpp writes it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tricover/recording.h"

namespace tricover::detail {

/// A polygon, once for all bodies that have it.
struct RecordedShape {
  Polygon polygon;
  Vec2 centre;    ///< The middle of its rings' box, in its frame: bodies are placed by it.
  double radius;  ///< No vertex is farther away from there.
};

/// Where a body is in a frame: its shape's centre, and how far it has rotated since its look began. NaN where the body
/// isn't there.
struct RecordedRow {
  Vec2 centre;
  double turn;
  bool operator==(const RecordedRow& other) const { return centre == other.centre && turn == other.turn; }
};

/// What a body looks like from a frame on: all of its pose that a centre and a rotation don't tell is in `linear`.
struct RecordedLook {
  std::size_t row;
  double margin;
  std::uint32_t category;
  Eigen::Matrix2d linear;
};

struct RecordedBody {
  std::size_t shape = 0;
  std::string name;
  std::vector<RecordedLook> looks;
  /// From the first frame on. Where the last ones are missing, the body rests.
  std::vector<RecordedRow> rows;
  std::size_t first_frame = 0, last_frame = 0;
  std::optional<Trajectory> trajectory;
  bool trajectory_is_given = false;  ///< Otherwise it rests where the scene has it, unless frames have it.
  BodyOptions options;               ///< With a trajectory.

  bool follows() const { return trajectory && (trajectory_is_given || rows.empty()); }
};

/// A pair that meets from a frame until before another one.
struct RecordedMeeting {
  BodyPair pair;
  std::size_t begin, end;
};

/// Something drawn beside the bodies.
struct RecordedItem {
  enum Kind { kContact, kNearest, kRay, kRayHit, kText } kind;
  std::array<Vec2, 3> points;  ///< The second one of a contact is its normal.
  double length;               ///< A depth or a distance.
  std::string text;
};

/// What is shown for the same time.
struct RecordedMoment {
  std::optional<TimeInterval> when;
  std::size_t frame;  ///< Without an interval.
  std::vector<RecordedItem> items;
};

struct RecordingState {
  std::string title;
  std::vector<RecordedShape> shapes;
  std::map<std::uint64_t, std::size_t> shape_of;  ///< By a polygon's id.
  std::map<BodyHandle, RecordedBody> bodies;
  std::vector<double> times;               ///< Of frames.
  std::vector<RecordedMeeting> meetings;   ///< Those that have ended.
  std::vector<RecordedMeeting> meets_now;  ///< Those of the last frame, sorted by pair.
  std::vector<PairConflict> conflicts;
  std::vector<PairImpact> impacts;
  std::vector<LeastDistance> least;
  std::vector<RecordedMoment> moments;
};

/// How many points of a kind of items are in the world.
inline std::size_t pointsOf(RecordedItem::Kind kind) {
  constexpr std::size_t counts[] = {1, 2, 2, 3, 1};
  return counts[kind];
}

/// The page's data, a JSON object.
std::string writtenRecording(const RecordingState& state);

}  // namespace tricover::detail
