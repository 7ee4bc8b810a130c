// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/export.h"
#include "tricover/least_distance.h"
#include "tricover/scene.h"
#include "tricover/trajectory.h"

namespace tricover {

namespace detail {
struct RecordingState;
}

/// An interval of time, both ends included.
struct TimeInterval {
  double begin;  ///< When it begins,
  double end;    ///< and when it ends, which isn't earlier.
};

/// A scene in motion, as one HTML file that needs nothing else: a browser plays it, without a network. Bodies are
/// recorded frame by frame, or by their trajectories, which the file keeps as such and draws where Trajectory::at()
/// puts them. The page shows what the library has found, and tests nothing itself: who meets whom is what was recorded.
///
/// A recording is of one scene. Times are by one clock of the caller's: seconds, say. Between two frames the page shows
/// the earlier one. A body with a trajectory follows it in all frames. The page draws bodies within a pixel of where
/// they are, up to 1024 times larger than all of them fit into 2000 pixels.
///
/// Drawings beside the bodies are shown for a time interval; without one, as long as the last frame is. Numbers are
/// written the same in every locale, and equal recordings make equal files. A file takes about 16 bytes for each frame
/// and body that moves, 30 to 80 for each leg of a trajectory, 11 for each vertex of a shape, and 60 kB for the page.
///
/// \throws std::invalid_argument in all members, for a time, a point or a length that is not finite, for an interval
/// that ends before it begins, and, where an interval is missing, if there is no frame yet
/// \snippet recording.cpp frames
class TRICOVER_EXPORT SceneRecording {
 public:
  /// Makes an empty recording. The page shows its title.
  explicit SceneRecording(const std::string& title = "Recording");
  ~SceneRecording();
  SceneRecording(const SceneRecording& other);             ///< Copies all that is recorded. Polygons are shared.
  SceneRecording& operator=(const SceneRecording& other);  ///< Replaces all that is recorded.

  /// Records where all bodies of a scene are, with their margins and categories, and which pairs meet, as the scene's
  /// collisions() says, or another query. Bodies may appear and go from frame to frame.
  /// \throws std::invalid_argument for a time that is not later than the last frame's, and for a body whose polygon is
  /// not that of earlier frames, as in another scene
  /// \throws std::out_of_range for a pair that names no body of the scene
  /// \snippet recording.cpp frames
  void frame(double time, const Scene& scene, const std::vector<BodyPair>& meeting = {});
  /// Records how bodies of a scene move. Its other bodies rest where they are, unless frames have them.
  /// \throws std::invalid_argument for a body that has a trajectory already, and for one whose polygon is not that of
  /// earlier frames
  /// \throws std::out_of_range for a handle that names no body of the scene
  /// \snippet recording.cpp trajectories
  void trajectories(const Scene& scene, const std::vector<BodyTrajectory>& trajectories);
  /// Names a body for the page, which calls it "body 3" otherwise.
  /// \throws std::out_of_range for a body that is not recorded
  /// \snippet recording.cpp trajectories
  void name(Scene::Body body, const std::string& name);

  /// Marks the time intervals in which pairs meet on the time line, and highlights the pairs then.
  /// \throws std::out_of_range for a body that is not recorded
  /// \snippet recording.cpp trajectories
  void conflicts(const std::vector<PairConflict>& conflicts);
  /// Marks first impacts on the time line, and draws them with their normals around these times.
  /// \throws std::out_of_range for a body that is not recorded
  /// \snippet recording.cpp trajectories
  void impacts(const std::vector<PairImpact>& impacts);

  /// Draws each contact: the point, an arrow along the normal and, in its true length, the translation by `depth`.
  /// \snippet recording.cpp frames
  void contacts(const std::vector<Contact>& contacts, const std::optional<TimeInterval>& when = {});
  /// Draws the nearest points, the line between them, and the distance.
  /// \snippet recording.cpp frames
  void nearest(const DistanceResult& result, const std::optional<TimeInterval>& when = {});
  /// Marks the time of the least distance on the time line, and draws the nearest points around that time.
  /// \snippet recording.cpp least distance
  void nearest(const LeastDistance& result);
  /// Draws a ray: to its hit, and faintly from there on.
  /// \snippet recording.cpp frames
  void ray(const Vec2& from, const Vec2& to, const std::optional<BodyRayHit>& hit = {},
           const std::optional<TimeInterval>& when = {});
  /// Writes a line of text, centred at `position`.
  /// \snippet recording.cpp frames
  void text(const Vec2& position, const std::string& text, const std::optional<TimeInterval>& when = {});

  /// Returns the page, a whole HTML document in UTF-8.
  /// \throws std::logic_error while no body is recorded
  /// \snippet recording.cpp frames
  std::string str() const;
  /// Writes the page to a file. A file that is there is replaced only when the new one is whole.
  /// \throws std::logic_error while no body is recorded
  /// \throws std::runtime_error where the file can't be written. The text has its path.
  /// \snippet recording.cpp trajectories
  void save(const std::string& path) const;

 private:
  std::unique_ptr<detail::RecordingState> state_;
};

}  // namespace tricover
