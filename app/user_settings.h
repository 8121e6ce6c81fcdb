#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace enfilade {

/// What the window remembers of its last use.
struct ViewSettings {
  std::string house{};          ///< the house folder; empty: none yet
  int width = 1280;             ///< [pixels] [160…16384]
  int height = 800;             ///< [pixels] [120…16384]
  bool fullscreen = false;      ///< instead of that
  std::string method = "ldi";   ///< one of allMethods()
  float fov_degrees = 60;       ///< [degrees] [20…120] vertical
  float speed = 1.4f;           ///< [m/s] [0.1…20]
  float mouse_sensitivity = 1;  ///< [0.05…20]
  bool show_plan = true;
  bool show_graph = true;
  bool invert_y = false;

  bool operator==(const ViewSettings&) const = default;
};

/// Where they are kept: $XDG_CONFIG_HOME/enfilade/view.json, or ~/.config/enfilade/view.json.
/// Empty without such a folder: nothing is remembered.
/// Source: XDG Base Directory Specification 0.8 (a relative $XDG_CONFIG_HOME counts as none).
std::string viewSettingsFile();

struct ReadViewSettings {
  ViewSettings settings;
  std::string note;  ///< a line that says what was not taken and why; empty if nothing
};

/// Reads them.  Whatever is missing, of the wrong type or out of its limits keeps its default; a
/// file that is not there or whose name is empty gives them all.  Never throws for what is in a
/// file.
ReadViewSettings readViewSettings(const std::string& file);

/// The same of the bytes of `file`.
ReadViewSettings decodeViewSettings(std::span<const std::uint8_t> bytes, const std::string& file);

/// Writes them by way of a temporary name, with the folders that it takes.  A line that says why it
/// could not; empty if it could, or if `file` is.
std::string writeViewSettings(const std::string& file, const ViewSettings& settings);

}  // namespace enfilade
