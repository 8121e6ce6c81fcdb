#include "scene/file_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "scene/warning_log.h"

namespace enfilade {

std::string guessFormat(std::span<const std::uint8_t> bytes) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 10> kKnown{{
      {"ISO-10303-21", "an IFC or STEP file; convert it to glTF first"},
      {"PK\x03\x04", "a ZIP archive; unpack it first"},
      {"Kaydara FBX", "an FBX file; convert it to glTF first"},
      {"BLENDER", "a Blender file; export it as glTF 2.0"},
      {"<?xml", "an XML file"},
      {"ply", "a PLY file; convert it to glTF first"},
      {"solid", "an STL file; convert it to glTF first"},
      {"\x89PNG", "a PNG image"},
      {"\xff\xd8\xff", "a JPEG image"},
      {"version https://git-lfs", "a Git LFS pointer; fetch the file itself with git lfs pull"},
  }};
  const std::string text(bytes.begin(),
                         bytes.begin() + std::min<std::ptrdiff_t>(std::ssize(bytes), 60));
  for (const auto& [magic, what] : kKnown) {
    if (text.starts_with(magic)) return fmt::format("it seems to be {}", what);
  }
  const bool is_text = std::all_of(
      text.begin(), text.end(), [](unsigned char c) { return c >= 0x20 || std::isspace(c) != 0; });
  return is_text ? fmt::format("it begins with \"{}\"", oneLine(text, 30))
                 : "its first bytes are those of some other binary format";
}

}  // namespace enfilade
