#include "app/report_plan.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "app/floor_plan.h"

namespace enfilade {

namespace {

constexpr float kWidest = 480.0f;       // [pixels] so that names are read beside the charts
constexpr float kHighest = 560.0f;      // [pixels]
constexpr float kSliceHeight = 1.2f;    // [m] above a floor
constexpr float kBesideThePath = 0.5f;  // [m] that are shown too
constexpr float kLedge = 0.3f;          // [m] below a floor its storey begins

/// The house's own crop and where the path leads beyond it, but no farther than the house is large.
PlanCrop cropOf(const House& house, const CameraPath& path) {
  PlanCrop crop = planCrop(house);
  const glm::vec2 least = crop.low - (crop.high - crop.low);
  const glm::vec2 most = crop.high + (crop.high - crop.low);
  for (const TimedPose& timed : path.poses) {
    const glm::vec2 at(timed.pose.position.x, timed.pose.position.z);
    crop.low = glm::max(glm::min(crop.low, at - kBesideThePath), least);
    crop.high = glm::min(glm::max(crop.high, at + kBesideThePath), most);
  }
  const glm::vec2 metres = crop.high - crop.low;
  crop.scale = std::min(kWidest / metres.x, kHighest / metres.y);
  return crop;
}

/// The highest storey whose floor is not above `feet`.
std::size_t storeyAt(const CellGraph& graph, float feet) {
  std::size_t storey = 0;
  for (std::size_t s = 1; s < graph.storeys.size(); ++s) {
    if (graph.storeys[s].floor_y - kLedge <= feet) storey = s;
  }
  return storey;
}

ReportPlan::Step stepOf(const House& house, const Pose& pose, const PlanCrop& crop) {
  const glm::vec3 ahead = pose.world_from_camera_rotation * glm::vec3(0, 0, -1);
  ReportPlan::Step step;
  step.place = crop.pixels(pose.position.x, pose.position.z);
  step.heading = glm::degrees(std::atan2(ahead.z, ahead.x));
  step.storey = storeyAt(house.graph, pose.position.y - house.eye_height);
  return step;
}

}  // namespace

ReportPlan planOf(const House& house, const CameraPath& path) {
  const PlanCrop crop = cropOf(house, path);
  ReportPlan plan;
  plan.size = crop.size();
  plan.scale = crop.scale;
  for (std::size_t s = 0; s < house.graph.storeys.size(); ++s) {
    const Storey& storey = house.graph.storeys[s];
    plan.storeys.push_back(
        {storey.name, storey.floor_y, storeyDrawing(house, s, kSliceHeight, crop)});
  }
  for (const TimedPose& timed : path.poses) plan.steps.push_back(stepOf(house, timed.pose, crop));
  return plan;
}

}  // namespace enfilade
