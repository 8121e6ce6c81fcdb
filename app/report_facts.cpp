#include "app/report_facts.h"

#include <fmt/format.h>

#include <span>

#include "scene/file_io.h"

namespace enfilade {

void describeHouse(const House& house, Report& report) {
  report.model = house.info.model_name;
  report.model_sha256 = house.info.model_sha256;
  report.house_version = house.info.tool_version;
  report.house_parameters = house.info.parameters;
  report.cells = house.graph.cells.size();
  report.portals = house.graph.portals.size();
  report.triangles = triangleCount(house.building);
}

void describePath(const House& house, const CameraPath& path, Report& report) {
  report.frames = path.poses.size();
  report.tour_sha256 = pathSha256(path);
  report.plan = planOf(house, path);
}

std::string pathSha256(const CameraPath& path) {
  std::string text;
  for (const TimedPose& timed : path.poses) {
    const glm::vec3& p = timed.pose.position;
    const glm::quat& q = timed.pose.world_from_camera_rotation;
    text += fmt::format("{} {} {} {} {} {} {} {}\n", timed.time, p.x, p.y, p.z, q.x, q.y, q.z, q.w);
  }
  for (const DoorEvent& door : path.doors) {
    text += fmt::format("{} {} {}\n", door.time, door.open, door.portal);
  }
  return sha256Hex({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace enfilade
