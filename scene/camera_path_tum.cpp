#include <fmt/format.h>

#include <array>
#include <cctype>
#include <charconv>
#include <filesystem>

#include "scene/camera_path_formats.h"
#include "scene/error.h"
#include "scene/file_format.h"
#include "scene/warning_log.h"

namespace enfilade {
namespace {

constexpr std::string_view kBlank = " \t\r";

/// Whether `line` is exactly eight numbers.
bool parseNumbers(std::string_view line, std::array<double, 8>& numbers) {
  for (double& number : numbers) {
    line.remove_prefix(std::min(line.find_first_not_of(kBlank), line.size()));
    if (line.starts_with('+')) line.remove_prefix(1);
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
    if (error != std::errc()) return false;
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    if (!line.empty() && kBlank.find(line.front()) == std::string_view::npos) return false;
  }
  return line.find_first_not_of(kBlank) == std::string_view::npos;
}

[[noreturn]] void fail(const std::string& file, std::size_t line_number, std::string_view line,
                       bool is_first) {
  if (is_first && std::isdigit(static_cast<unsigned char>(line.front())) == 0) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(line.data());
    throw Error(ErrorKind::kBadInput, file,
                "is no camera path (neither a tour, nor glTF, nor TUM): " +
                    guessFormat({bytes, line.size()}));
  }
  throw Error(ErrorKind::kBadInput, file,
              fmt::format("line {} is not the eight numbers of a TUM path: \"{}\"", line_number,
                          oneLine(std::string(line), 40)));
}

}  // namespace

CameraPath readTum(const std::string& file, std::string_view text) {
  CameraPath path;
  path.name = std::filesystem::path(file).stem().string();
  for (std::size_t line_number = 1; !text.empty(); ++line_number) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = text.substr(0, end);
    const bool two = text.substr(end).starts_with("\r\n");
    text.remove_prefix(std::min(end + (two ? 2 : 1), text.size()));
    const std::size_t start = line.find_first_not_of(kBlank);
    if (start == std::string_view::npos || line[start] == '#') continue;

    std::array<double, 8> n{};
    const std::string place = fmt::format("line {}", line_number);
    if (!parseNumbers(line, n)) {
      fail(file, line_number, line, path.poses.empty());
    }
    TimedPose pose;
    pose.time = n[0];
    pose.pose.position = glm::vec3(glm::dvec3(n[1], n[2], n[3]));
    pose.pose.world_from_camera_rotation = glm::quat(glm::dquat(n[7], n[4], n[5], n[6]));
    appendPose(file, place, pose, path);
  }
  if (path.poses.empty()) throw Error(ErrorKind::kBadInput, file, "holds no poses");
  return path;
}

}  // namespace enfilade
