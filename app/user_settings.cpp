#include "app/user_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/methods.h"
#include "scene/error.h"
#include "scene/file_io.h"
#include "scene/warning_log.h"

namespace enfilade {

namespace {

using nlohmann::json;

constexpr std::uintmax_t kMostBytes = 65536;  // of a file that is looked into
constexpr std::size_t kLongestPath = 4096;

// Every member once, for the reader and the writer alike.
template <typename Settings, typename Visitor>
void visitMembers(Settings& s, const Visitor& visit) {
  visit.path("house", s.house);
  visit.number("width", s.width, 160, 16384);
  visit.number("height", s.height, 120, 16384);
  visit.flag("fullscreen", s.fullscreen);
  visit.method("method", s.method);
  visit.number("fov_degrees", s.fov_degrees, 20.0f, 120.0f);
  visit.number("speed", s.speed, 0.1f, 20.0f);
  visit.number("mouse_sensitivity", s.mouse_sensitivity, 0.05f, 20.0f);
  visit.flag("show_plan", s.show_plan);
  visit.flag("show_graph", s.show_graph);
  visit.flag("invert_y", s.invert_y);
}

// Takes what is there and fit, and lists the keys of what is not.
struct Reader {
  const json& root;
  std::vector<std::string>& ignored;

  template <typename T>
  void number(const char* key, T& value, T least, T most) const {
    take(key, [&](const json& j) {
      if (!(std::is_integral_v<T> ? j.is_number_integer() : j.is_number())) return false;
      const auto found = j.get<double>();
      if (!(found >= double(least) && found <= double(most))) return false;
      value = static_cast<T>(found);
      return true;
    });
  }
  void flag(const char* key, bool& value) const {
    take(key, [&](const json& j) {
      if (j.is_boolean()) value = j;
      return j.is_boolean();
    });
  }
  void path(const char* key, std::string& value) const {
    take(key, [&](const json& j) {
      if (!j.is_string()) return false;
      const std::string& text = j.get_ref<const std::string&>();
      const bool fit = text.size() <= kLongestPath && text.find('\0') == std::string::npos;
      if (fit) value = text;
      return fit;
    });
  }
  void method(const char* key, std::string& value) const {
    take(key, [&](const json& j) {
      const auto methods = allMethods();
      const auto found = std::find_if(methods.begin(), methods.end(),
                                      [&](const MethodInfo& info) { return j == info.name; });
      if (found != methods.end()) value = found->name;
      return found != methods.end();
    });
  }

 private:
  template <typename Take>
  void take(const char* key, const Take& fits) const {
    const auto found = root.find(key);
    if (found != root.end() && !fits(*found)) ignored.emplace_back(key);
  }
};

struct Writer {
  nlohmann::ordered_json& root;

  template <typename T>
  void number(const char* key, T value, T, T) const {
    // As the shortest decimal that gives the float again.
    root[key] = nlohmann::ordered_json::parse(fmt::format("{}", value), nullptr, false);
  }
  void flag(const char* key, bool value) const { root[key] = value; }
  void path(const char* key, const std::string& value) const { root[key] = value; }
  void method(const char* key, const std::string& value) const { root[key] = value; }
};

// A relative path would mean another file in every folder that the program is run from.
std::string absoluteFolder(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && value[0] == '/' ? value : "";
}

ReadViewSettings defaults(const std::string& file, const std::string& reason) {
  return {{}, fmt::format("{}: {}; the window starts as new", oneLine(file, 200), reason)};
}

}  // namespace

std::string viewSettingsFile() {
  const std::string config = absoluteFolder("XDG_CONFIG_HOME");
  if (!config.empty()) return config + "/enfilade/view.json";
  const std::string home = absoluteFolder("HOME");
  return home.empty() ? "" : home + "/.config/enfilade/view.json";
}

ReadViewSettings decodeViewSettings(std::span<const std::uint8_t> bytes, const std::string& file) {
  ReadViewSettings read;
  std::vector<std::string> ignored;
  const json root = json::parse(bytes.begin(), bytes.end(), nullptr, false);
  if (!root.is_object()) return defaults(file, "is damaged");
  visitMembers(read.settings, Reader{root, ignored});
  if (!ignored.empty()) {
    read.note = fmt::format("{}: ignored what is no fit value: {}", oneLine(file, 200),
                            fmt::join(ignored, ", "));
  }
  return read;
}

ReadViewSettings readViewSettings(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (file.empty() || status.type() == fs::file_type::not_found) return {};
  if (!fs::is_regular_file(status)) return defaults(file, "is no file that can be read");
  if (fs::file_size(file, error) > kMostBytes) return defaults(file, "is far too large");
  try {
    return decodeViewSettings(readFile(file), file);
  } catch (const Error& failure) {
    return {{}, failure.what()};
  }
}

std::string writeViewSettings(const std::string& file, const ViewSettings& settings) {
  if (file.empty()) return {};
  nlohmann::ordered_json root;
  visitMembers(settings, Writer{root});
  try {
    createFolders(std::filesystem::path(file).parent_path().string());
    writeFileAtomically(
        file, root.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
  } catch (const Error& failure) {
    return failure.what();
  }
  return {};
}

}  // namespace enfilade
