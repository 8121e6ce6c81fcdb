#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "scene/camera_path.h"
#include "scene/gltf_writer.h"
#include "scene/image.h"
#include "tests/app/run_program.h"
#include "tests/app/temporary_folder.h"
#include "tests/app/two_room_house.h"

namespace enfilade {

using Arguments = std::vector<std::string>;

inline std::string outputOf(const std::string& command) {
  FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  std::array<char, 256> some{};
  while (fgets(some.data(), some.size(), pipe) != nullptr) text += some.data();
  pclose(pipe);
  return text;
}

/// A house without images, and walks through it of 12 poses.
class FilmTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    here_ = std::make_unique<TemporaryFolder>();
    writeGlb(*here_ / "model.glb", twoRoomHouse().building);
    run({"preprocess", "model.glb", "-o", "house", "--no-images", "--sight-lines", "5000", "-q"});
    run({"tour", "house", "-o", "tour.json", "--frames", "12", "-q"});
    CameraPath slow = readCameraPath(*here_ / "tour.json");
    for (std::size_t i = 0; i < slow.poses.size(); ++i) {
      slow.poses[i].time = 5 + 0.01 * static_cast<double>(i * i);  // 1.21 s
    }
    writeCameraPath(*here_ / "slow.json", slow);
  }
  static void TearDownTestSuite() { here_.reset(); }

  void SetUp() override {
    if (std::system("ffmpeg -version >/dev/null 2>&1 && ffprobe -version >/dev/null 2>&1") != 0) {
      GTEST_SKIP() << "ffmpeg is not installed";
    }
  }

  static ProgramResult run(const Arguments& arguments) {
    return runEnfilade(arguments, here_->path());
  }
  static ProgramResult play(const Arguments& more) {
    Arguments arguments = {"play", "house", "-q", "--warm-up", "0"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  /// What ffprobe says of a film's stream, by name.
  static std::map<std::string, std::string> probe(const std::string& file) {
    std::istringstream lines(outputOf(
        "ffprobe -v error -count_frames -show_entries stream=codec_name,pix_fmt,width,height,"
        "r_frame_rate,nb_read_frames:format=duration -of default=nw=1 '" +
        *here_ / file + "'"));
    std::map<std::string, std::string> values;
    for (std::string line; std::getline(lines, line);) {
      const std::size_t equals = line.find('=');
      values[line.substr(0, equals)] = line.substr(equals + 1);
    }
    return values;
  }

  static Image filmFrame(const std::string& file, int frame) {
    const std::string png = *here_ / "frame.png";
    outputOf("ffmpeg -v error -y -i '" + *here_ / file + "' -vf 'select=eq(n\\," +
             std::to_string(frame) + ")' -frames:v 1 '" + png + "'");
    return readImage(png);
  }

  static Image part(const Image& image, const glm::ivec2& low, const glm::ivec2& size) {
    Image out{size.x, size.y, {}};
    for (int y = low.y; y < low.y + size.y; ++y) {
      const auto row = image.rgba.begin() + 4 * (y * image.width + low.x);
      out.rgba.insert(out.rgba.end(), row, row + 4 * size.x);
    }
    return out;
  }

  static inline std::unique_ptr<TemporaryFolder> here_;
};

}  // namespace enfilade
