#include "app/walker.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "preprocess/walk_clearance.h"

namespace enfilade {

namespace {

constexpr float kTick = 1.0f / 120.0f;  // [s] the longest that is walked at once
constexpr float kMostSeconds = 1.0f;    // of one step
constexpr float kReaction = 0.04f;      // [s] in which speed comes within 1/e of what is wished
constexpr float kStill = 0.01f;         // [m/s] slower is standing
constexpr float kEyeReaction = 0.08f;   // [s] the same of the eye's height
constexpr float kBody = 0.2f;           // [m] radius that is kept free where there is room
constexpr float kShoulder = 0.08f;      // [m] by which it gives way
constexpr float kPush = 1.6f;           // away from a wall, of the way walked, with all of it
constexpr float kShortWay = 0.4f;       // of a column: the longest way that is tried at once
constexpr float kMostPitch = 1.53f;     // [rad]
constexpr float kMostSpeed = 50.0f;     // [m/s]
constexpr float kLeastEye = 0.3f;       // [m]
constexpr float kUnderCeiling = 0.1f;   // [m] the eye stays lower
constexpr float kBodyBottom = 0.1f;     // [m] what is lower stops nobody

float clean(float value) { return std::isfinite(value) ? value : 0.0f; }
float cleanPress(float value) { return std::clamp(clean(value), -1.0f, 1.0f); }
bool isFinite(const glm::vec3& p) { return std::isfinite(p.x + p.y + p.z); }

}  // namespace

Walker::Walker(const House& house) : Walker(std::make_shared<const WalkGround>(house)) {}

Walker::Walker(std::shared_ptr<const WalkGround> ground) : ground_(std::move(ground)) {
  gait_.eye_height = ground_->grid().limits.eye_height;
  const std::vector<Portal>& portals = ground_->house().graph.portals;
  for (PortalId p = 0; p < portals.size(); ++p) {
    if (!portals[p].active) shut_.push_back(p);
  }
  placeInCell(ground_->startCell());
}

void Walker::stand(SpotId spot) {
  const glm::vec2 center = ground_->grid().centerOf(spot);
  spot_ = spot;
  flying_ = false;
  velocity_ = glm::vec3(0);
  eye_ = {center.x, 0, center.y};
  eye_.y = eyeTarget();
}

void Walker::place(const glm::vec3& eye) {
  if (!isFinite(eye)) return;
  const SpotId spot = flying_ ? kNoSpot : ground_->nearestSpot(eye);
  if (spot != kNoSpot) {
    stand(spot);
    return;
  }
  flying_ = true;
  spot_ = kNoSpot;
  velocity_ = glm::vec3(0);
  eye_ = glm::clamp(eye, ground_->flightBounds().min, ground_->flightBounds().max);
}

bool Walker::placeInCell(CellId cell) {
  const CellSpot& spot = ground_->cellSpot(cell);
  look(spot.yaw, 0);
  if (spot.spot != kNoSpot) {
    stand(spot.spot);
    return true;
  }
  flying_ = true;
  place(spot.eye);
  return false;
}

void Walker::turn(float yaw, float pitch) { look(yaw_ + clean(yaw), pitch_ + clean(pitch)); }

void Walker::look(float yaw, float pitch) {
  yaw_ = std::remainder(clean(yaw), glm::two_pi<float>());
  pitch_ = std::clamp(clean(pitch), -kMostPitch, kMostPitch);
}

void Walker::step(const Stride& stride, float seconds) {
  if (!(seconds > 0)) return;
  seconds = std::min(seconds, kMostSeconds);
  const glm::vec3 wish = wishOf(stride);
  const int ticks = static_cast<int>(std::ceil(seconds / kTick - 1e-3f));
  const float tick = seconds / static_cast<float>(std::max(ticks, 1));
  for (int i = 0; i < std::max(ticks, 1); ++i) {
    const glm::vec3 way = accelerate(wish, tick);
    if (flying_) {
      fly(way);
    } else {
      walk({way.x, way.z});
      followFloor(tick);
    }
  }
}

void Walker::setDoors(std::span<const std::uint8_t> open) {
  shut_.clear();
  const std::size_t count = std::min(open.size(), ground_->barriers().size());
  for (PortalId p = 0; p < count; ++p) {
    if (open[p] == 0) shut_.push_back(p);
  }
}

void Walker::setGait(const Gait& gait) {
  const float highest = ground_->grid().limits.head_room - kUnderCeiling;
  gait_.speed = std::clamp(clean(gait.speed), 0.0f, kMostSpeed);
  gait_.eye_height = std::clamp(clean(gait.eye_height), kLeastEye, highest);
}

void Walker::setFlying(bool flying) {
  if (flying == flying_) return;
  flying_ = flying;
  spot_ = kNoSpot;
  if (!flying) place(eye_);
}

float Walker::floorHeight() const noexcept {
  return spot_ == kNoSpot ? std::numeric_limits<float>::quiet_NaN() : ground_->grid().floor[spot_];
}

// The velocity that the keys ask for; no faster along a diagonal.
glm::vec3 Walker::wishOf(const Stride& stride) const {
  const glm::vec3 ahead(-std::sin(yaw_), 0, -std::cos(yaw_));
  const glm::vec3 right(-ahead.z, 0, ahead.x);
  glm::vec3 wish = cleanPress(stride.right) * right;
  if (flying_) {
    const glm::vec3 sight = std::cos(pitch_) * ahead + glm::vec3(0, std::sin(pitch_), 0);
    wish += cleanPress(stride.forward) * sight + glm::vec3(0, cleanPress(stride.up), 0);
  } else {
    wish += cleanPress(stride.forward) * ahead;
  }
  const float length = glm::length(wish);
  return gait_.speed * (length > 1.0f ? wish / length : wish);
}

// The way of a time in which the velocity decays exponentially to what is wished: exact, so that
// it does not matter how the time is cut up.
glm::vec3 Walker::accelerate(const glm::vec3& wish, float seconds) {
  const float left = std::exp(-seconds / kReaction);
  const glm::vec3 lag = velocity_ - wish;
  velocity_ = wish + left * lag;
  if (wish == glm::vec3(0) && glm::length(velocity_) < kStill) velocity_ = glm::vec3(0);
  return seconds * wish + kReaction * (1.0f - left) * lag;
}

void Walker::fly(const glm::vec3& way) {
  eye_ = glm::clamp(eye_ + way, ground_->flightBounds().min, ground_->flightBounds().max);
}

void Walker::walk(const glm::vec2& way) {
  const float longest = kShortWay * ground_->grid().pitch;
  const int pieces = static_cast<int>(std::ceil(glm::length(way) / longest));
  for (int i = 0; i < pieces; ++i) walkShort(way / static_cast<float>(pieces));
}

// Near a wall one is pushed away from it, the more the nearer: so one stops before it, slides along
// it, is turned aside by a door's jamb and yet gets through a passage narrower than the body, in
// whose middle nothing pushes. Where that does not lead on, along the wall, then along one axis.
void Walker::walkShort(const glm::vec2& way) {
  const Room room = roomAround();
  const float lack = std::clamp((kBody - room.distance) / kShoulder, 0.0f, 1.25f);
  const float length = glm::length(way);
  glm::vec2 pushed = way + kPush * lack * length * room.away;
  pushed *= std::min(1.0f, length / std::max(glm::length(pushed), 1e-9f));
  if (tryMove(at() + pushed)) return;
  const float steep = glm::length(room.away);
  if (steep > 0) {
    const glm::vec2 away = room.away / steep;
    if (tryMove(at() + way - std::min(glm::dot(way, away), 0.0f) * away)) return;
  }
  const bool x_first = std::abs(pushed.x) >= std::abs(pushed.y);
  const glm::vec2 along_x(pushed.x, 0);
  const glm::vec2 along_z(0, pushed.y);
  if (!tryMove(at() + (x_first ? along_x : along_z))) tryMove(at() + (x_first ? along_z : along_x));
}

// Invariant: one stands on a spot that a tour might use, joined to the one before by a step, and
// never nearer to a shut door than kNarrowestClearance except on the way out of it.
bool Walker::tryMove(const glm::vec2& to) {
  const glm::ivec2 offset = ground_->grid().columnAt(to) - ground_->grid().columnOf(spot_);
  if (std::max(std::abs(offset.x), std::abs(offset.y)) > 1) return false;
  const SpotId next = ground_->stepTo(spot_, to);
  if (next == kNoSpot) return false;
  const float door = doorDistance(to);
  if (door < kNarrowestClearance && door < doorDistance(at())) return false;
  spot_ = next;
  eye_.x = to.x;
  eye_.z = to.y;
  return true;
}

float Walker::doorDistance(const glm::vec2& at) const noexcept {
  float distance = kMostClearance;
  const float floor = ground_->grid().floor[spot_];
  for (const PortalId p : shut_) {
    const WalkBarrier& barrier = ground_->barriers()[p];
    const bool above = barrier.bottom > floor + ground_->grid().limits.head_room;
    if (above || barrier.top < floor + kBodyBottom) continue;
    distance = std::min(distance, barrier.distance(at, distance));
  }
  return distance;
}

float Walker::roomAt(SpotId spot, const glm::vec2& at) const noexcept {
  return std::min(ground_->clearanceAt(spot, at), doorDistance(at));
}

Walker::Room Walker::roomAround() const noexcept {
  Room room{roomAt(spot_, at()), glm::vec2(0)};
  if (room.distance >= kBody) return room;
  const float h = 0.5f * ground_->grid().pitch;
  for (int axis = 0; axis < 2; ++axis) {
    glm::vec2 by(0);
    by[axis] = h;
    room.away[axis] = (roomAt(spot_, at() + by) - roomAt(spot_, at() - by)) / (2.0f * h);
  }
  const float length = glm::length(room.away);
  if (length > 1.0f) room.away /= length;
  return room;
}

float Walker::eyeTarget() const noexcept {
  const float highest = ground_->grid().ceiling[spot_] - kUnderCeiling;
  return std::min(ground_->smoothFloor(spot_) + gait_.eye_height, highest);
}

void Walker::followFloor(float seconds) {
  const float target = eyeTarget();
  eye_.y = target + (eye_.y - target) * std::exp(-seconds / kEyeReaction);
}

}  // namespace enfilade
