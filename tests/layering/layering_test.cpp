#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;

using Folders = std::set<std::string>;

// Which folders each may include from, besides its own.
const std::map<std::string, Folders> kMayUse = {
    {"scene", {}},
    {"portals", {"scene"}},
    {"visibility", {"portals", "scene"}},
    {"render", {"scene"}},
    {"ibr", {"render", "portals", "scene"}},
    {"preprocess", {"ibr", "visibility", "render", "portals", "scene"}},
    {"models", {"scene"}},
    {"app", {"models", "preprocess", "ibr", "visibility", "render", "portals", "scene"}},
};

// The folders of ours that `text` includes from.
Folders includedFolders(const std::string& text) {
  static const std::regex pattern("(^|\n)[ \t]*#[ \t]*include[ \t]*\"([a-z]+)/");
  Folders found;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
    if (kMayUse.contains((*it)[2])) found.insert((*it)[2]);
  }
  return found;
}

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Folders forbidden(const std::string& folder, const std::string& text) {
  Folders found = includedFolders(text);
  found.erase(folder);
  for (const std::string& allowed : kMayUse.at(folder)) found.erase(allowed);
  return found;
}

TEST(Layering, EveryIncludeGoesUpTheHouse) {
  int files = 0;
  for (const auto& [folder, uses] : kMayUse) {
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(ENFILADE_SOURCE_DIR) / folder)) {
      const fs::path extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp") continue;
      ++files;
      for (const std::string& used : forbidden(folder, contentOf(entry.path()))) {
        ADD_FAILURE() << entry.path() << " includes from " << used << ", which " << folder
                      << " may not use";
      }
    }
  }
  EXPECT_GT(files, 20);
}

TEST(Layering, AForbiddenIncludeIsFound) {
  EXPECT_EQ(forbidden("scene", "#include <vector>\n#include \"portals/house.h\"\n"),
            Folders{"portals"});
  EXPECT_EQ(forbidden("render", "#  include \"ibr/ldi.h\""), Folders{"ibr"});
  EXPECT_TRUE(forbidden("app", "#include \"ibr/ldi.h\"").empty());
}

}  // namespace
