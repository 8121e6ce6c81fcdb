#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/camera_path.h"

namespace enfilade {

/// How a walk is written down.
struct RecorderParameters {
  double frames_per_second = 30;  ///< [> 0] of the path
  double longest = 7200;          ///< [s] [≥ 0] where it ends, however long the walk
  float vertical_fov = 1.047f;    ///< [rad] of the path
  std::string name = "walk";      ///< of the path
};

/// Makes a camera path of the frames that a person sees, whenever they come.
class PathRecorder {
 public:
  explicit PathRecorder(RecorderParameters parameters = {});

  /// A frame was shown at `time` [s], of any clock that only goes forward.  The first one begins
  /// the path.  Left out: numbers that are not finite, times before the last.  After a quarter of a
  /// second or more without a frame one stood still until then, as one saw.  False: the path has
  /// reached its greatest length and ends there.
  bool addFrame(double time, const Pose& pose);

  /// A door was moved, see DoorEvent.  Before the first frame: at its time.
  void addDoor(double time, const std::string& portal, bool open);
  /// How all doors stand now, one flag a portal, by whose numbers changes are kept.  The first call
  /// says how they stand in the house.
  void addDoors(double time, std::span<const std::uint8_t> open);

  bool full() const noexcept { return full_; }
  double duration() const noexcept;  ///< [s] so far

  /// The path so far: times from 0, evenly spaced, rotations of one sign.  Without poses if no
  /// frame was shown.
  const CameraPath& path() const noexcept { return path_; }

 private:
  struct Frame {
    double time;  // [s] since the first
    Pose pose;
  };
  void resampleTo(const Frame& frame);

  RecorderParameters parameters_;
  CameraPath path_;
  std::optional<double> begin_;  // of the caller's clock
  Frame last_{};
  std::vector<std::uint8_t> open_;
  bool full_ = false;
};

}  // namespace enfilade
