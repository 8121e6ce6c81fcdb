#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "app/walk_ground.h"
#include "scene/camera.h"

namespace enfilade {

/// What a person presses: a direction in the camera's frame.
struct Stride {
  float forward = 0;  ///< [-1…1]
  float right = 0;    ///< [-1…1]
  float up = 0;       ///< [-1…1] counts when flying only
};

/// How a person moves.
struct Gait {
  float speed = 1.4f;       ///< [m/s] [0…50]
  float eye_height = 1.6f;  ///< [m] [0.3…the head room of the ground] above the floor
};

/// A person who walks through a house at eye height: along floors and up stairs, through open
/// doors, sliding along walls, never through them, down no drop of more than a step; or who flies
/// through everything.  Numbers that are not finite count as zero.  Not for several threads at
/// once.
class Walker {
 public:
  /// Finds the ground first, see WalkGround.  `house` must outlive the walker.
  explicit Walker(const House& house);
  /// On ground that is known, at its start: ground may be made in another thread.
  explicit Walker(std::shared_ptr<const WalkGround> ground);

  /// Stands at the nearest place to `eye` where one can, one of the same storey and room before
  /// others; when flying, or where there is no place at all, exactly there.
  void place(const glm::vec3& eye);

  /// Stands at the cell's best place and looks at what is most worth it, see CellSpot.
  /// False: nobody can stand there.  Then the walker flies in the cell's middle.
  bool placeInCell(CellId cell);

  /// Turns by these angles, positive left and up [rad]; the pitch stops short of straight up or
  /// down.
  void turn(float yaw, float pitch);
  /// Looks along these angles, as poseFromAngles().
  void look(float yaw, float pitch);

  /// Moves for a time [s], of which no more than a second counts.  The way is the same however the
  /// time is cut up, within a centimetre or so.
  void step(const Stride& stride, float seconds);

  /// Which doors stand open, one flag a portal, as FramePainter::setDoors.  At first as in the
  /// house.
  void setDoors(std::span<const std::uint8_t> open);

  const Gait& gait() const noexcept { return gait_; }
  void setGait(const Gait& gait);

  bool flying() const noexcept { return flying_; }
  /// Landing goes to the nearest place to stand; where there is none, one goes on flying.
  void setFlying(bool flying);

  glm::vec3 eye() const noexcept { return eye_; }
  float yaw() const noexcept { return yaw_; }      ///< [rad] −π…π
  float pitch() const noexcept { return pitch_; }  ///< [rad]
  Pose pose() const { return poseFromAngles(eye_, yaw_, pitch_); }
  glm::vec3 velocity() const noexcept { return velocity_; }  ///< wished, before walls [m/s]
  float floorHeight() const noexcept;  ///< [m] of the place where one stands; NaN when flying
  const WalkGround& ground() const noexcept { return *ground_; }

 private:
  struct Room {
    float distance = 0;  // [m] to what stops one
    glm::vec2 away{0};   // where it grows, as far as it does
  };

  void stand(SpotId spot);
  glm::vec3 accelerate(const glm::vec3& wish, float seconds);
  glm::vec3 wishOf(const Stride& stride) const;
  void walk(const glm::vec2& way);
  void walkShort(const glm::vec2& way);
  bool tryMove(const glm::vec2& to);
  void fly(const glm::vec3& way);
  void followFloor(float seconds);
  float eyeTarget() const noexcept;
  float doorDistance(const glm::vec2& at) const noexcept;
  float roomAt(SpotId spot, const glm::vec2& at) const noexcept;
  Room roomAround() const noexcept;
  glm::vec2 at() const noexcept { return {eye_.x, eye_.z}; }

  std::shared_ptr<const WalkGround> ground_;
  std::vector<PortalId> shut_;
  Gait gait_;
  glm::vec3 eye_{0};
  glm::vec3 velocity_{0};
  float yaw_ = 0, pitch_ = 0;
  bool flying_ = false;
  SpotId spot_ = kNoSpot;  // where one stands; kNoSpot when flying
};

}  // namespace enfilade
