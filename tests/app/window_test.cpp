// The window, as a person has it: on a screen that nobody sees, by keys and a mouse.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "app/image_quality.h"
#include "app/methods.h"
#include "preprocess/bake_images.h"
#include "scene/camera_path.h"
#include "tests/app/run_program.h"
#include "tests/app/temporary_folder.h"
#include "tests/app/two_room_house.h"
#include "tests/app/virtual_screen.h"

namespace enfilade {
namespace {

constexpr double kPatience = 60;  // [s] for a machine that does other things too

class Window : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (!VirtualScreen::available()) return;
    here_ = std::make_unique<TemporaryFolder>();
    House house = colouredTwoRooms();
    std::filesystem::create_directory(*here_ / "rooms");
    bakeImages(house, parametersForAllImages(), *here_ / "rooms", {GlBackend::kOsMesa, 1}, {});
    writeHouse(*here_ / "rooms", house);
    CameraPath path;
    path.vertical_fov = 1.2f;
    path.poses = {{0, lookAt({2.0f, 1.6f, 2.2f}, {4.1f, 1.3f, 2.0f})},
                  {1, lookAt({2.3f, 1.6f, 2.2f}, {4.1f, 1.3f, 2.0f})}};
    writeCameraPath(*here_ / "path.json", path);
    screen_ = std::make_unique<VirtualScreen>(800, 600, here_->path());
  }
  static void TearDownTestSuite() {
    screen_.reset();
    here_.reset();
  }

  void SetUp() override {
    if (!VirtualScreen::available()) GTEST_SKIP() << "Xvfb and xdotool are not installed";
    ASSERT_FALSE(screen_->display().empty()) << textOf(*here_ / "xvfb.log");
    std::filesystem::create_directory(kept_ / "kept");
  }

  /// Opens the window with `arguments` and waits until one can walk.
  void open(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {ENFILADE_PROGRAM, "view"});
    arguments.insert(arguments.end(), {"--keep-in", kept_ / "kept"});
    view_ = std::make_unique<BackgroundProcess>(
        arguments, kept_ / "log",
        std::vector<std::string>{"DISPLAY=" + screen_->display(), "XDG_CONFIG_HOME=" + kept_.path(),
                                 // What the unloaded OpenGL driver leaves cannot be told by name.
                                 "ASAN_OPTIONS=detect_leaks=0"});
    ASSERT_TRUE(screen_->waitForWindow("Enfilade: rooms", kPatience)) << textOf(kept_ / "log");
  }
  void openRooms(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), *here_ / "rooms");
    open(std::move(arguments));
  }

  void act(const std::string& commands) {
    EXPECT_TRUE(screen_->act(commands)) << commands << ": " << textOf(*here_ / "xdotool.log");
  }

  /// Ends the window by its own key.
  void quit() {
    act("key ctrl+q");
    EXPECT_EQ(view_->wait(kPatience), 0) << textOf(kept_ / "log");
  }

  /// Waits until `count` files of `extension` were kept, and returns their paths.
  std::vector<std::string> keptFiles(const std::string& extension, std::size_t count) {
    std::vector<std::string> files;
    for (int i = 0; i < 50 * static_cast<int>(kPatience) && files.size() < count; ++i) {
      files.clear();
      for (const auto& entry : std::filesystem::directory_iterator(kept_ / "kept")) {
        if (entry.path().extension() == extension) files.push_back(entry.path().string());
      }
      view_->wait(0.02);
    }
    std::sort(files.begin(), files.end());
    EXPECT_EQ(files.size(), count) << textOf(kept_ / "log");
    return files;
  }

  /// Keeps the picture and returns it.
  Image picture(const std::string& key = "F12") {
    const std::size_t before = pictures_++;
    act("key " + key);
    const std::vector<std::string> files = keptFiles(".png", before + 1);
    for (const std::string& file : files) {
      if (seen_.insert(file).second) return readImage(file);
    }
    return {};
  }

  /// Records while `walk` is done, and returns the path.
  CameraPath recorded(const std::string& walk) {
    act("key r sleep 0.3 " + walk + " sleep 0.3 key r");
    const std::vector<std::string> files = keptFiles(".json", 1);
    return files.empty() ? CameraPath{} : readCameraPath(files.front());
  }

  static std::unique_ptr<TemporaryFolder> here_;
  static std::unique_ptr<VirtualScreen> screen_;
  TemporaryFolder kept_;
  std::unique_ptr<BackgroundProcess> view_;
  std::size_t pictures_ = 0;
  std::set<std::string> seen_;
};
std::unique_ptr<TemporaryFolder> Window::here_;
std::unique_ptr<VirtualScreen> Window::screen_;

TEST_F(Window, KeepsThePictureThatPlayPaints) {
  const std::string frames = kept_ / "frames";
  const ProgramResult played =
      runEnfilade({"play", *here_ / "rooms", "--tour", *here_ / "path.json", "--methods",
                   "geometry,raycast,culling,texture,warp,warp2,ldi", "--size", "320x256",
                   "--frames-dir", frames, "-o", kept_ / "report"},
                  kept_.path());
  ASSERT_EQ(played.status, 0) << played.errors;
  openRooms({"--tour", *here_ / "path.json", "--size", "320x256", "--fov", "68.7549354"});
  int number = 0;
  for (const MethodInfo& method : allMethods()) {
    act("key " + std::to_string(++number));
    const Image kept = picture();
    const Image truth = readImage(frames + "/" + method.name + "/frame-00000.png");
    ASSERT_EQ(kept.width, 320) << method.name;
    EXPECT_GT(psnr(kept, truth), 60) << method.name;
  }
  quit();
}

TEST_F(Window, KeepsTheWalkThatIsBeingRecordedHoweverItEnds) {
  const auto walkAndEnd = [&](const std::function<void()>& end, int status) {
    openRooms({});
    act("key r sleep 0.3 keydown w sleep 0.3 keyup w");
    end();
    EXPECT_EQ(view_->wait(kPatience), status) << textOf(kept_ / "log");
    const std::vector<std::string> files = keptFiles(".json", 1);
    ASSERT_EQ(files.size(), 1u);
    EXPECT_GT(readCameraPath(files.front()).poses.size(), 2u);
    EXPECT_NE(textOf(kept_ / "log").find("frames kept as " + kept_.path()), std::string::npos)
        << textOf(kept_ / "log");
    std::filesystem::remove(files.front());
  };
  walkAndEnd([&] { act("key ctrl+q"); }, 0);
  walkAndEnd([&] { view_->send(SIGTERM); }, 128 + SIGTERM);
  EXPECT_TRUE(std::filesystem::exists(kept_ / "enfilade/view.json"));
}

TEST_F(Window, EndsAsOfAMachineThatCannotWhenTheDisplayIsGone) {
  auto screen = std::make_unique<VirtualScreen>(800, 600, kept_.path());
  ASSERT_FALSE(screen->display().empty());
  std::swap(screen, screen_);
  openRooms({});
  act("key r sleep 0.3 keydown w sleep 0.3 keyup w");
  std::swap(screen, screen_);
  screen.reset();
  EXPECT_EQ(view_->wait(kPatience), 3) << textOf(kept_ / "log");
  EXPECT_NE(textOf(kept_ / "log").find("enfilade: window: the display is gone\n"),
            std::string::npos);
  EXPECT_EQ(keptFiles(".json", 1).size(), 1u);
}

TEST_F(Window, UnderALimitOnMemoryItShowsTheImagesThatFitOnceTheyAreThere) {
  const std::string frames = kept_ / "frames";
  const ProgramResult played =
      runEnfilade({"play", *here_ / "rooms", "--tour", *here_ / "path.json", "--methods",
                   "culling,ldi", "--size", "320x256", "--frames-dir", frames},
                  kept_.path());
  ASSERT_EQ(played.status, 0) << played.errors;
  for (const auto& [mib, method] : {std::pair("100", "ldi"), std::pair("0.001", "culling")}) {
    openRooms({"--tour", *here_ / "path.json", "--size", "320x256", "--fov", "68.7549354",
               "--method", "ldi", "--memory", mib});
    act("sleep 2");  // nobody waits in the window, so the test does
    const Image truth = readImage(frames + "/" + method + "/frame-00000.png");
    EXPECT_GT(psnr(picture(), truth), 60) << mib;
    quit();
  }
}

TEST_F(Window, WalksWhereTheKeysSay) {
  openRooms({"--size", "320x256", "--method", "culling"});
  const CameraPath path = recorded("keydown w sleep 1 keyup w");
  ASSERT_GT(path.poses.size(), 20u);
  const Pose& first = path.poses.front().pose;
  const glm::vec3 way = path.poses.back().pose.position - first.position;
  const glm::vec3 ahead = first.world_from_camera_rotation * glm::vec3(0, 0, -1);
  EXPECT_GT(glm::length(way), 0.3f);
  EXPECT_LT(glm::length(way), 3.0f);
  EXPECT_GT(glm::dot(glm::normalize(way), ahead), 0.7f);
  const House house = colouredTwoRooms();
  for (const TimedPose& timed : path.poses) {
    EXPECT_TRUE(locate(house.graph, house.grid, timed.pose.position).in_free_space);
  }
  quit();
}

TEST_F(Window, TheMouseLooksOnceItIsTaken) {
  openRooms({"--size", "320x256", "--method", "culling"});
  act("key Tab mousemove 160 128 sleep 0.2 click 1 sleep 0.5");
  const CameraPath path = recorded("mousemove_relative 80 0 sleep 0.3 mousemove_relative 0 20");
  ASSERT_FALSE(path.poses.empty());
  const auto ahead = [](const TimedPose& timed) {
    return timed.pose.world_from_camera_rotation * glm::vec3(0, 0, -1);
  };
  EXPECT_LT(glm::dot(ahead(path.poses.front()), ahead(path.poses.back())), 0.99f);
  EXPECT_LT(ahead(path.poses.back()).y, -0.02f);
  const glm::vec3 way = path.poses.back().pose.position - path.poses.front().pose.position;
  EXPECT_LT(glm::length(way), 1e-3f);
  quit();
}

TEST_F(Window, KeepsARecordedPathInEveryFormatAndPlaysIt) {
  openRooms({"--size", "320x256", "--method", "culling"});
  const CameraPath path = recorded("keydown w sleep 0.6 keyup w");
  ASSERT_FALSE(path.poses.empty());
  const std::string json = keptFiles(".json", 1).front();
  for (const char* extension : {".tum", ".gltf"}) {
    const std::string other = json.substr(0, json.size() - 5) + extension;
    ASSERT_TRUE(std::filesystem::exists(other));
    EXPECT_NEAR(static_cast<double>(readCameraPath(other).poses.size()),
                static_cast<double>(path.poses.size()), 1);
  }
  act("key t sleep 2");
  quit();
  const ProgramResult played = runEnfilade({"play", *here_ / "rooms", "--tour", json, "--methods",
                                            "culling", "--size", "64x64", "-o", kept_ / "report"},
                                           kept_.path());
  EXPECT_EQ(played.status, 0) << played.errors;
}

TEST_F(Window, EveryViewOfHowAPictureIsMadeChangesIt) {
  openRooms({"--tour", *here_ / "path.json", "--size", "640x480", "--method", "ldi"});
  act("key Tab");
  const auto settled = [&] {
    act("sleep 0.2 key Escape sleep 0.2");  // what was said is gone again
    return picture("shift+F12");
  };
  const Image plain = settled();
  for (const char* key : {"p", "c", "i", "y", "v", "x"}) {
    act(std::string("key ") + key);
    const Image changed = settled();
    act(std::string("key ") + key);
    ASSERT_EQ(changed.rgba.size(), plain.rgba.size()) << key;
    EXPECT_LT(psnr(changed, plain), 60) << key;
  }
  EXPECT_GT(psnr(settled(), plain), 60) << "and none leaves a trace";
  quit();
}

TEST_F(Window, TheLineBetweenTwoMethodsGoesWhereItIsDragged) {
  openRooms({"--size", "640x480", "--method", "culling"});
  act("key Tab key x sleep 0.5");
  act("mousemove 320 300 mousedown 1 mousemove 300 300 mousemove 200 300 mouseup 1 sleep 0.5");
  act("key Escape sleep 0.3");
  const Image kept = picture("shift+F12");
  ASSERT_EQ(kept.width, 640);
  int line = -1;  // the column that is orange from top to bottom
  for (int x = 0; x < kept.width && line < 0; ++x) {
    bool orange = true;
    for (int y = 0; y < kept.height; y += 40) {
      const std::uint8_t* p = &kept.rgba[4 * static_cast<std::size_t>(y * kept.width + x)];
      orange = orange && p[0] > 230 && p[1] > 160 && p[1] < 200 && p[2] < 90;
    }
    if (orange) line = x;
  }
  EXPECT_NEAR(line, 200, 3);
  quit();
}

TEST_F(Window, AClickOnThePlanGoesThere) {
  openRooms({"--size", "640x480", "--method", "culling"});
  act("mousemove 330 200 sleep 0.2");
  // The plan's lower right corner is 22 pixels from the window's, 2 m outside the rooms.
  act("key r sleep 0.3 mousemove 560 400 click 1 sleep 0.5 key r");
  const std::vector<std::string> files = keptFiles(".json", 1);
  ASSERT_FALSE(files.empty());
  const CameraPath path = readCameraPath(files.front());
  const glm::vec3 before = path.poses.front().pose.position;
  const glm::vec3 after = path.poses.back().pose.position;
  EXPECT_GT(glm::length(after - before), 1.0f);
  const House house = colouredTwoRooms();
  const CellLocation where = locate(house.graph, house.grid, after);
  EXPECT_TRUE(where.in_free_space);
  EXPECT_NE(where.cell, kExterior);
  quit();
}

TEST_F(Window, FollowsItsSizeAndRemembersIt) {
  openRooms({"--size", "320x256", "--method", "warp"});
  act("search --name '^Enfilade: rooms$' windowsize 500 300 sleep 0.5");
  const Image kept = picture();
  EXPECT_EQ(kept.width, 500);
  EXPECT_EQ(kept.height, 300);
  quit();
  const nlohmann::json remembered = nlohmann::json::parse(textOf(kept_ / "enfilade/view.json"));
  EXPECT_EQ(remembered["width"], 500);
  EXPECT_EQ(remembered["method"], "warp");
  open({});  // the house that was viewed last
  EXPECT_EQ(picture().width, 500);
  quit();
}

TEST_F(Window, ASettingsFileThatIsBrokenIsToldAndLeftOut) {
  std::filesystem::create_directory(kept_ / "enfilade");
  writeText(kept_ / "enfilade/view.json", "{\"width\": -5, \"method\": 7");
  openRooms({"--size", "320x256"});
  quit();
  EXPECT_NE(textOf(kept_ / "log").find("view.json"), std::string::npos);
}

TEST_F(Window, AWalkAtRandomKeysStaysInTheBuildingsAir) {
  openRooms({"--size", "320x256", "--method", "ldi"});
  std::mt19937 random(7);
  const char* const held[] = {"w", "a", "s", "d", "Left", "Right", "Up", "Down", "shift+w"};
  const char* const tapped[] = {"1",
                                "3",
                                "7",
                                "p",
                                "c",
                                "i",
                                "u",
                                "y",
                                "v",
                                "z",
                                "x",
                                "m",
                                "g",
                                "o",
                                "F1",
                                "bracketleft",
                                "bracketright",
                                "equal",
                                "minus"};
  std::string walk;
  for (int i = 0; i < 60; ++i) {
    const std::string key = held[random() % std::size(held)];
    walk += " keydown " + key + " sleep 0.15 keyup " + key;
    if (i % 3 == 0) walk += std::string(" key ") + tapped[random() % std::size(tapped)];
  }
  const CameraPath path = recorded(walk);
  EXPECT_TRUE(view_->runs());
  ASSERT_GT(path.poses.size(), 60u);
  const House house = colouredTwoRooms();
  for (const TimedPose& timed : path.poses) {
    EXPECT_TRUE(locate(house.graph, house.grid, timed.pose.position).in_free_space)
        << "at " << timed.time << " s";
  }
  act("key Escape");
  quit();
}

TEST(WindowWithoutAScreen, SaysWhatNeedsNone) {
  const TemporaryFolder here;
  writeHouse(here / "rooms", twoRoomHouse());
  const std::string line = "cd '" + here.path() + "' && DISPLAY= WAYLAND_DISPLAY= '" +
                           ENFILADE_PROGRAM + "' view rooms 2>err";
  const int status = std::system(line.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 3);
  const std::string errors = textOf(here / "err");
  EXPECT_NE(errors.find("'enfilade play' needs no display"), std::string::npos) << errors;
  EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
}

TEST(WindowWithoutAScreen, SaysWhatIsWrongWithAHouseBeforeItOpens) {
  const TemporaryFolder here;
  const ProgramResult result = runEnfilade({"view", "nowhere"}, here.path());
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.errors.find("nowhere"), std::string::npos) << result.errors;
}

}  // namespace
}  // namespace enfilade
