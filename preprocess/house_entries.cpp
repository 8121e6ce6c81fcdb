#include "preprocess/house_entries.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

#include "ibr/image_kinds.h"
#include "portals/house_files.h"
#include "scene/error.h"
#include "scene/file_io.h"

namespace enfilade {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const std::string& folder, const std::string& name) {
  throw Error(ErrorKind::kUsage, folder,
              "holds other things (" + name + "): choose a new folder for the house");
}

/// Takes `digits` decimal digits or more off the start of `text`; false if there are fewer.
bool takeDigits(std::string_view& text) {
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  text.remove_prefix(digits);
  return digits > 0;
}

bool takeWord(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

/// "portal-0012-front"
bool isSideName(std::string_view name) {
  return takeWord(name, "portal-") && takeDigits(name) && (name == "-front" || name == "-back");
}

/// "texture-00.png" for one whose first is `first`.
bool isNumbered(std::string_view name, std::string_view first) {
  const std::size_t number = first.find_first_of('0');
  return takeWord(name, first.substr(0, number)) && takeDigits(name) &&
         name == first.substr(first.find_last_of('0') + 1);
}

bool isImageName(std::string_view name) {
  return name == ldiFileName() || isNumbered(name, textureFileName(0)) ||
         isNumbered(name, referenceFileName(0));
}

/// A name without what it bears while it is written; the name itself if it bears nothing such.
std::string wholeName(const std::string& name) {
  const std::size_t end = name.find(kTemporaryMark);
  const bool is_temporary =
      end != std::string::npos &&
      name.find_first_not_of("0123456789-", end + kTemporaryMark.size()) == std::string::npos;
  return is_temporary ? name.substr(0, end) : name;
}

/// Throws Error (kUsage) for a file in `folder`/`inner` whose name is none of those, and for what
/// is no file.
void refuseOtherFiles(const std::string& folder, const std::string& inner,
                      bool (*is_own)(std::string_view)) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder + "/" + inner, error)) {
    const std::string name = entry.path().filename().string();
    if (!is_own(wholeName(name)) || fs::is_directory(entry.symlink_status())) {
      refuse(folder, inner + "/" + name);
    }
  }
}

void refuseOtherSides(const std::string& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder + "/images", error)) {
    constexpr std::string_view kPart = ".part";  // while it is baked
    const std::string name = entry.path().filename().string();
    std::string_view side = name;
    if (side.ends_with(kPart)) side.remove_suffix(kPart.size());
    if (!isSideName(side) || !entry.is_directory(error)) refuse(folder, "images/" + name);
    refuseOtherFiles(folder, "images/" + name, isImageName);
  }
}

/// Whether a file is empty, or has `word` near its beginning.
bool speaksOf(const std::string& file, std::string_view word) {
  constexpr std::size_t kBeginning = std::size_t{1} << 16;
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return false;
  try {
    const std::vector<std::uint8_t> bytes = readFileStart(file, kBeginning);
    return bytes.empty() ||
           std::search(bytes.begin(), bytes.end(), word.begin(), word.end()) != bytes.end();
  } catch (const Error&) {
    return false;
  }
}

/// Whether nothing is in `folder` but what was half written.
bool isBare(const std::string& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) return false;
  const fs::directory_iterator entries(folder, error);
  return !error && std::all_of(begin(entries), end(entries), [](const auto& entry) {
    return isHalfWritten(entry, unfinishedEntries());
  });
}

}  // namespace

const std::set<std::string>& houseEntries() {
  static const std::set<std::string> entries = {"house.json", "geometry.glb", "cells.grid",
                                                "images", "unfinished"};
  return entries;
}

const std::set<std::string>& unfinishedEntries() {
  static const std::set<std::string> entries = {"job.json",      "cells.grid", "geometry.glb",
                                                "house.json",    "images",     "sides",
                                                "finished.json", "replaced"};
  return entries;
}

bool holdsHouse(const std::string& folder) {
  constexpr std::string_view kOfHouse = "\"enfilade\"", kOfJob = "\"program\"";
  const std::string unfinished = unfinishedFolder(folder);
  return speaksOf(houseJsonFile(folder), kOfHouse) ||
         speaksOf(houseJsonFile(unfinished), kOfHouse) ||
         speaksOf(unfinished + "/job.json", kOfJob) || isBare(unfinished);
}

bool isHalfWritten(const fs::directory_entry& entry, const std::set<std::string>& own) {
  const std::string name = entry.path().filename().string(), whole = wholeName(name);
  return whole != name && own.contains(whole) &&
         entry.symlink_status().type() == fs::file_type::regular;
}

void refuseOtherThings(const std::string& folder, const std::set<std::string>& own) {
  static const std::set<std::string> folders = {"images", "sides", "unfinished", "replaced"};
  std::error_code error;
  if (!fs::is_directory(folder, error)) return;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (isHalfWritten(entry, own)) continue;
    if (!own.contains(name) || entry.is_directory(error) != folders.contains(name)) {
      refuse(folder, name);
    }
  }
  if (own.contains("images")) refuseOtherSides(folder);
  if (own.contains("sides")) refuseOtherFiles(folder, "sides", isSideName);
  if (own.contains("unfinished")) refuseOtherThings(folder + "/unfinished", unfinishedEntries());
  if (own.contains("replaced")) refuseOtherThings(folder + "/replaced", houseEntries());
}

}  // namespace enfilade
