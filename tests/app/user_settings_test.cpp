#include "app/user_settings.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/app/temporary_folder.h"

namespace enfilade {
namespace {

using nlohmann::json;

/// Sets an environment variable, or takes it away, until the end of the scope.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old;
    value != nullptr ? ::setenv(name, value, 1) : ::unsetenv(name);
  }
  ~Variable() { old_.empty() ? ::unsetenv(name_) : ::setenv(name_, old_.c_str(), 1); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::string old_;
};

ViewSettings unlikeTheDefaults() {
  return {.house = "/home/ann/Häuser/\"brooks\"",
          .width = 1920,
          .height = 1017,
          .fullscreen = true,
          .method = "culling",
          .fov_degrees = 72.3f,
          .speed = 2.1f,
          .mouse_sensitivity = 0.3f,
          .show_plan = false,
          .show_graph = false,
          .invert_y = true};
}

class ViewSettingsFile : public ::testing::Test {
 protected:
  std::string file() const { return folder_ / "view.json"; }
  ReadViewSettings readText(const std::string& text) {
    writeText(file(), text);
    return readViewSettings(file());
  }
  /// That nothing of the file is taken, and one line says so.
  void expectDefaults(const ReadViewSettings& read, const std::string& words) {
    EXPECT_EQ(read.settings, ViewSettings{});
    EXPECT_NE(read.note.find(words), std::string::npos) << read.note;
    EXPECT_EQ(read.note.find('\n'), std::string::npos);
  }
  TemporaryFolder folder_;
};

TEST_F(ViewSettingsFile, ReadsBackWhatWasWritten) {
  for (const ViewSettings& settings : {ViewSettings{}, unlikeTheDefaults()}) {
    EXPECT_EQ(writeViewSettings(file(), settings), "");
    const ReadViewSettings read = readViewSettings(file());
    EXPECT_EQ(read.settings, settings);
    EXPECT_EQ(read.note, "");
  }
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"view.json"});
}

TEST_F(ViewSettingsFile, ThatIsNotThereGivesTheDefaultsWithoutAWord) {
  for (const std::string& name : {file(), folder_ / "no/such/folder.json", std::string()}) {
    const ReadViewSettings read = readViewSettings(name);
    EXPECT_EQ(read.settings, ViewSettings{});
    EXPECT_EQ(read.note, "");
  }
}

TEST_F(ViewSettingsFile, ThatIsEmptyIsDamaged) { expectDefaults(readText(""), "is damaged"); }

TEST_F(ViewSettingsFile, ThatIsCutShortIsDamaged) {
  ASSERT_EQ(writeViewSettings(file(), unlikeTheDefaults()), "");
  const std::string text = textOf(file());
  for (std::size_t length = 0; length + 2 < text.size(); ++length) {
    expectDefaults(readText(text.substr(0, length)), "is damaged");
  }
}

TEST_F(ViewSettingsFile, ThatIsNoTextIsDamaged) {
  expectDefaults(readText(std::string("\x89PNG\r\n\x1a\n\0\0\xff", 11)), "is damaged");
}

TEST_F(ViewSettingsFile, ThatHoldsAListOrANumberIsDamaged) {
  expectDefaults(readText("[1, 2]"), "is damaged");
  expectDefaults(readText("7"), "is damaged");
}

TEST_F(ViewSettingsFile, ThatIsNestedWithoutEndIsDamaged) {
  expectDefaults(readText(std::string(60'000, '[')), "is damaged");
  expectDefaults(readText(std::string(30'000, '[') + std::string(30'000, ']')), "is damaged");
}

TEST_F(ViewSettingsFile, ThatIsFarTooLargeIsNotRead) {
  expectDefaults(readText("{\"house\": \"" + std::string(1 << 20, 'x') + "\"}"), "too large");
}

TEST_F(ViewSettingsFile, ThatIsAFolderIsNotRead) {
  expectDefaults(readViewSettings(folder_.path()), "no file");
}

TEST_F(ViewSettingsFile, ThatIsAPipeIsNotWaitedFor) {
  ASSERT_EQ(::mkfifo(file().c_str(), 0600), 0);
  expectDefaults(readViewSettings(file()), "no file");
}

TEST_F(ViewSettingsFile, ThatMayNotBeReadSaysSo) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  writeText(file(), "{}");
  ASSERT_EQ(::chmod(file().c_str(), 0), 0);
  expectDefaults(readViewSettings(file()), "cannot be read");
}

TEST_F(ViewSettingsFile, OfSomeKeysKeepsTheOthersDefaults) {
  const ReadViewSettings read = readText(R"({"speed": 3, "unknown": {"a": [1]}})");
  EXPECT_EQ(read.settings, (ViewSettings{.speed = 3}));
  EXPECT_EQ(read.note, "");
}

TEST_F(ViewSettingsFile, ValuesOutOfLimitsAreIgnoredAndNamed) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> bad = {
      {"house", {"1", "null", "[]", "\"a\\u0000b\"", "\"" + std::string(5000, 'x') + "\""}},
      {"width", {"0", "-5", "159", "16385", "1e9", "800.5", "\"800\"", "true", "1e999"}},
      {"height", {"119", "99999999999999999999", "null"}},
      {"fullscreen", {"1", "\"yes\"", "null"}},
      {"method", {"\"magic\"", "\"\"", "3", "[\"ldi\"]", "\"LDI\""}},
      {"fov_degrees", {"0", "19.9", "121", "-60", "{}"}},
      {"speed", {"0", "-1", "21", "\"fast\""}},
      {"mouse_sensitivity", {"0", "1e300", "-1e-9"}},
      {"show_plan", {"0"}},
      {"show_graph", {"\"\""}},
      {"invert_y", {"[]"}}};
  for (const auto& [key, values] : bad) {
    for (const std::string& value : values) {
      const ReadViewSettings read = readText("{\"" + key + "\": " + value + "}");
      EXPECT_EQ(read.settings, ViewSettings{}) << key << " " << value;
      const bool named = read.note.find(value == "1e999" ? "damaged" : key) != std::string::npos;
      EXPECT_TRUE(named) << key << " " << value << ": " << read.note;
    }
  }
}

TEST_F(ViewSettingsFile, OneBadValueCostsNoOther) {
  json root = {{"speed", -1}, {"width", 640}, {"method", "warp"}, {"invert_y", 2}};
  const ReadViewSettings read = readText(root.dump());
  EXPECT_EQ(read.settings, (ViewSettings{.width = 640, .method = "warp"}));
  EXPECT_NE(read.note.find("speed, invert_y"), std::string::npos) << read.note;
}

TEST_F(ViewSettingsFile, IsWrittenIntoFoldersThatAreMade) {
  const std::string deep = folder_ / "a/b/view.json";
  EXPECT_EQ(writeViewSettings(deep, unlikeTheDefaults()), "");
  EXPECT_EQ(readViewSettings(deep).settings, unlikeTheDefaults());
}

TEST_F(ViewSettingsFile, ThatCannotBeWrittenIsANoteAndNoError) {
  writeText(folder_ / "plain", "");
  const std::string note = writeViewSettings(folder_ / "plain/view.json", {});
  EXPECT_NE(note, "");
  EXPECT_EQ(note.find('\n'), std::string::npos);
  EXPECT_EQ(writeViewSettings("", {}), "") << "there is nowhere to write";
}

TEST_F(ViewSettingsFile, OfAPathThatIsNoTextIsWrittenAllTheSame) {
  EXPECT_EQ(writeViewSettings(file(), {.house = "/tmp/\xff\xfe"}), "");
  EXPECT_EQ(readViewSettings(file()).note, "");
}

TEST(ViewSettingsFolder, IsTheOneOfTheEnvironment) {
  const Variable home("HOME", "/home/ann");
  {
    const Variable config("XDG_CONFIG_HOME", "/etc/ann");
    EXPECT_EQ(viewSettingsFile(), "/etc/ann/enfilade/view.json");
  }
  for (const char* none : {static_cast<const char*>(nullptr), "", "relative/folder"}) {
    const Variable config("XDG_CONFIG_HOME", none);
    EXPECT_EQ(viewSettingsFile(), "/home/ann/.config/enfilade/view.json");
  }
}

TEST(ViewSettingsFolder, IsNoneWithoutAHome) {
  const Variable config("XDG_CONFIG_HOME", nullptr);
  for (const char* none : {static_cast<const char*>(nullptr), "", "home"}) {
    const Variable home("HOME", none);
    EXPECT_EQ(viewSettingsFile(), "");
  }
}

}  // namespace
}  // namespace enfilade
