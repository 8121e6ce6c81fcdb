#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "scene/error.h"
#include "scene/file_io.h"

namespace enfilade {

/// A new folder that goes with its owner.
class TempFolder {
 public:
  TempFolder() {
    std::string name = testing::TempDir() + "enfilade-XXXXXX";
    path_ = ::mkdtemp(name.data());
  }
  ~TempFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  std::string path() const { return path_; }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

  /// Writes a file of this content and returns its path.
  std::string file(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    // Some file systems wait for the disk when a file is cut to nothing and written again.
    std::filesystem::remove(path_ / name);
    std::ofstream(path_ / name, std::ios::binary) << content;
    return *this / name;
  }
  std::string file(const std::string& name, const std::vector<std::uint8_t>& content) const {
    return file(name, std::string(content.begin(), content.end()));
  }

 private:
  std::filesystem::path path_;
};

/// Expects `action` to throw an Error of `kind` whose one line begins with `subject` and holds
/// `words`.
inline void expectError(const std::function<void()>& action, ErrorKind kind,
                        const std::string& subject, const std::string& words) {
  try {
    action();
    ADD_FAILURE() << "no error; expected \"" << words << "\"";
  } catch (const Error& error) {
    const std::string what = error.what();
    EXPECT_EQ(error.kind(), kind) << what;
    EXPECT_TRUE(what.starts_with(subject + ": ")) << what;
    EXPECT_NE(what.find(words), std::string::npos) << what << "\nlacks \"" << words << "\"";
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  }
}

}  // namespace enfilade
