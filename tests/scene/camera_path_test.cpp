#include "scene/camera_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene_test_tools.h"

namespace enfilade {
namespace {

CameraPath walk() {
  CameraPath path;
  path.name = "a \"walk\"\nthrough größe";
  path.vertical_fov = 1.234f;
  for (int i = 0; i < 50; ++i) {
    const float t = 0.1f * static_cast<float>(i);
    path.poses.push_back({static_cast<double>(i) / 30.0,
                          poseFromAngles({std::sin(t), 1.6f, -t}, 0.7f * t, 0.1f * std::cos(t))});
  }
  path.doors = {{0.5, "hall/\"kitchen\"-portal", false}, {1.25, "7", true}};
  return path;
}

void expectSamePoses(const CameraPath& a, const CameraPath& b) {
  ASSERT_EQ(a.poses.size(), b.poses.size());
  for (std::size_t i = 0; i < a.poses.size(); ++i) {
    EXPECT_EQ(a.poses[i].time, b.poses[i].time) << i;
    EXPECT_EQ(a.poses[i].pose.position, b.poses[i].pose.position) << i;
    EXPECT_EQ(a.poses[i].pose.world_from_camera_rotation,
              b.poses[i].pose.world_from_camera_rotation)
        << i;
  }
}

class CameraPaths : public testing::Test {
 protected:
  void expectBad(const std::string& content, const std::string& words) {
    const std::string file = folder_.file("path", content);
    expectError([&] { readCameraPath(file); }, ErrorKind::kBadInput, file, words);
  }
  /// A tour of these frames.
  static std::string tour(const std::string& frames) {
    return R"({"enfilade": "tour", "version": 1, "frames": [)" + frames + "]}";
  }
  TempFolder folder_;
};

TEST_F(CameraPaths, AreTheSameAfterWritingAndReading) {
  writeCameraPath(folder_ / "tour.json", walk());
  const CameraPath back = readCameraPath(folder_ / "tour.json");
  EXPECT_EQ(back.name, walk().name);
  EXPECT_EQ(back.vertical_fov, walk().vertical_fov);
  expectSamePoses(back, walk());
  ASSERT_EQ(back.doors.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back.doors[i].time, walk().doors[i].time);
    EXPECT_EQ(back.doors[i].portal, walk().doors[i].portal);
    EXPECT_EQ(back.doors[i].open, walk().doors[i].open);
  }
}

TEST_F(CameraPaths, DoorsAreChecked) {
  const std::string frames = R"({"t":0,"p":[0,0,0],"q":[0,0,0,1]})";
  const auto doors = [&](const std::string& text) {
    return R"({"enfilade": "tour", "version": 1, "frames": [)" + frames + "], \"doors\": " + text +
           "}";
  };
  expectBad(doors("5"), "\"doors\" is no list");
  expectBad(doors("[5]"), "doors[0]: \"t\" is no number");
  expectBad(doors(R"([{"t":1,"portal":5,"open":true}])"), "doors[0]: \"portal\" is no name");
  expectBad(doors(R"([{"t":1,"portal":"a","open":1}])"), "doors[0]: \"open\" is neither");
  expectBad(doors(R"([{"t":1,"portal":"a","open":true},{"t":0,"portal":"a","open":true}])"),
            "doors[1] is earlier");
}

TEST_F(CameraPaths, AreTheSameAfterWritingAndReadingAsTum) {
  writeTumPath(folder_ / "walk.txt", walk());
  const CameraPath back = readCameraPath(folder_ / "walk.txt");
  EXPECT_EQ(back.name, "walk");
  expectSamePoses(back, walk());
}

TEST_F(CameraPaths, ReadTumOfAnyLineEnds) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const std::string pose = " 0 0 0 0 0 0 1" + end;
    const std::string text = "# comment" + end + "1" + pose + end + "2" + pose;
    EXPECT_EQ(readCameraPath(folder_.file("t", text)).poses.size(), 2u);
    expectBad(text + "3", "line 5 is not the eight numbers");
  }
}

TEST_F(CameraPaths, AreToldApartByContentNotByName) {
  writeTumPath(folder_ / "tum.json", walk());
  writeCameraPath(folder_ / "tour.txt", walk());
  expectSamePoses(readCameraPath(folder_ / "tum.json"), readCameraPath(folder_ / "tour.txt"));
}

TEST_F(CameraPaths, ReadAJsonTourWrittenByHand) {
  const std::string file =
      folder_.file("t",
                   "\xef\xbb\xbf"
                   R"( {"frames": [{"q": [0, 2, 0, 0], "p": [1, 2.5, -3], "t": 4, "x": 1}],
           "vertical_fov_degrees": 90, "version": 1, "enfilade": "tour"})");
  const CameraPath path = readCameraPath(file);
  EXPECT_EQ(path.name, "");
  EXPECT_FLOAT_EQ(path.vertical_fov, glm::half_pi<float>());
  ASSERT_EQ(path.poses.size(), 1u);
  EXPECT_EQ(path.poses[0].time, 4.0);
  EXPECT_EQ(path.poses[0].pose.position, glm::vec3(1, 2.5f, -3));
  EXPECT_EQ(path.poses[0].pose.world_from_camera_rotation, glm::quat(0, 0, 1, 0)) << "normalised";
}

TEST_F(CameraPaths, ReadTumWithCommentsBlanksAndWindowsLines) {
  const std::string file = folder_.file("t",
                                        "# timestamp tx ty tz qx qy qz qw\r\n\r\n"
                                        "1311868164.5 1 -2e-1 +3 0 0 0 1\r\n"
                                        "  1311868165\t4 5 6  0 1 0 0  ");
  const CameraPath path = readCameraPath(file);
  ASSERT_EQ(path.poses.size(), 2u);
  EXPECT_EQ(path.poses[0].time, 1311868164.5);
  EXPECT_EQ(path.poses[0].pose.position, glm::vec3(1, -0.2f, 3));
  EXPECT_EQ(path.poses[0].pose.world_from_camera_rotation, glm::quat(1, 0, 0, 0));
  EXPECT_EQ(path.poses[1].pose.world_from_camera_rotation, glm::quat(0, 0, 1, 0));
}

TEST_F(CameraPaths, NameAFileThatIsMissing) {
  expectError([&] { readCameraPath(folder_ / "none"); }, ErrorKind::kBadInput, folder_ / "none",
              "no such file");
}

TEST_F(CameraPaths, RejectFilesOfOtherFormats) {
  expectBad("", "is empty");
  expectBad(" \n", "is empty");
  expectBad("hello world\n", "is no camera path (neither a tour, nor glTF, nor TUM): it begins");
  expectBad("\x89PNG\r\n\x1a\n", "PNG image");
  expectBad("# only a comment\n", "holds no poses");
  expectBad("[1, 2]", "is JSON, but neither a tour nor glTF");
  expectBad(R"({"enfilade": "house"})", "is an Enfilade \"house\", not a tour");
  expectBad(R"({"enfilade": "tour", "version")", "damaged or cut short");
}

TEST_F(CameraPaths, RejectATourOfAnotherVersion) {
  expectBad(R"({"enfilade": "tour", "version": 2, "frames": []})",
            "is a tour of version 2; this program reads version 1");
  expectBad(R"({"enfilade": "tour"})", "is a tour of version \"?\"");
}

TEST_F(CameraPaths, RejectATourWithoutFrames) {
  expectBad(tour(""), "is a tour without frames");
  expectBad(R"({"enfilade": "tour", "version": 1, "frames": 3})", "is a tour without frames");
}

TEST_F(CameraPaths, NameTheFrameThatIsWrong) {
  const std::string good = R"({"t": 1, "p": [0, 0, 0], "q": [0, 0, 0, 1]},)";
  expectBad(tour(good + "7"), "frame 1 is no object");
  expectBad(tour(good + R"({"p": [0, 0, 0], "q": [0, 0, 0, 1]})"), "frame 1: \"t\" is no number");
  expectBad(tour(good + R"({"t": 2, "p": [0, 0], "q": [0, 0, 0, 1]})"),
            "frame 1: \"p\" is not 3 numbers");
  expectBad(tour(good + R"({"t": 2, "p": [0, 0, 0], "q": [0, 0, 0, "1"]})"),
            "frame 1: \"q\" is not 4 numbers");
  expectBad(tour(good + R"({"t": 2, "p": [0, 0, 0], "q": [0, 0, 0, 0]})"),
            "frame 1 has no rotation");
  expectBad(tour(good + R"({"t": 2, "p": [0, 1e200, 0], "q": [0, 0, 0, 1]})"),
            "frame 1 has a number that is not finite");
  expectBad(tour(good + R"({"t": 2, "p": [0, -1e13, 0], "q": [0, 0, 0, 1]})"),
            "frame 1 is more than 1e12 m from the origin");
  expectBad(tour(good + R"({"t": 0.5, "p": [0, 0, 0], "q": [0, 0, 0, 1]})"),
            "frame 1 is earlier than the one before it");
}

TEST_F(CameraPaths, RejectDoorsThatMoveWithoutEnd) {
  std::string doors;
  for (int i = 0; i < 10'001; ++i) {
    doors += std::string(i > 0 ? "," : "") + R"({"t": 0, "portal": "1", "open": true})";
  }
  expectBad(R"({"enfilade": "tour", "version": 1, "frames": [{"t": 1, "p": [0, 0, 0],
                "q": [0, 0, 0, 1]}], "doors": [)" +
                doors + "]}",
            "moves doors 10001 times; 10000 at most");
}

TEST_F(CameraPaths, RejectAFieldOfViewThatCannotBe) {
  for (const char* fov : {"0", "180", "-5", "1e-300", "0.99", "170.1", "\"wide\""}) {
    expectBad(std::string(R"({"enfilade": "tour", "version": 1, "vertical_fov_degrees": )") + fov +
                  R"(, "frames": [{"t": 1, "p": [0, 0, 0], "q": [0, 0, 0, 1]}]})",
              "\"vertical_fov_degrees\" is ");
  }
}

TEST_F(CameraPaths, NameTheTumLineThatIsWrong) {
  expectBad("1 2 3 4\n", "line 1 is not the eight numbers of a TUM path: \"1 2 3 4\"");
  expectBad("# c\n0 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1 9\n", "line 3 is not the eight numbers");
  expectBad("0 0 0 0 0 0 0 1\n1 0 0 zero 0 0 0 1\n", "line 2 is not the eight numbers");
  expectBad("0 0 0 nan 0 0 0 1\n", "line 1 has a number that is not finite");
  expectBad("0 0 0 0 0 0 0 0\n", "line 1 has no rotation");
  expectBad("2 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n", "line 2 is earlier");
}

TEST_F(CameraPaths, AreNotWrittenWhereThereIsNoFolder) {
  expectError([&] { writeCameraPath(folder_ / "no/tour.json", walk()); }, ErrorKind::kMachine,
              folder_ / "no/tour.json", "cannot be written");
}

}  // namespace
}  // namespace enfilade
