// Films that the built program makes.  Without ffmpeg and ffprobe these skip, and say so.

#include "app/image_quality.h"
#include "tests/app/film_maker.h"

namespace enfilade {
namespace {

TEST_F(FilmTest, OfOneMethodShowsTheFramesThatAreKept) {
  const ProgramResult played = play({"--tour", "tour.json", "--methods", "culling", "--size",
                                     "160x128", "--video", "plain.mp4", "--frames-dir", "frames"});
  ASSERT_EQ(played.status, 0) << played.errors;
  EXPECT_NE(played.output.find("film: plain.mp4: 12 frames of 160 x 128 pixels, 0.4 s\n"),
            std::string::npos)
      << played.output;
  EXPECT_EQ(played.output.find("report: "), std::string::npos) << "nobody asked for one";
  auto film = probe("plain.mp4");
  EXPECT_EQ(film["codec_name"], "h264");
  EXPECT_EQ(film["pix_fmt"], "yuv420p");
  EXPECT_EQ(film["width"] + "x" + film["height"], "160x128");
  EXPECT_EQ(film["r_frame_rate"], "30/1");
  EXPECT_EQ(film["nb_read_frames"], "12");
  for (const int frame : {0, 7, 11}) {
    char name[64];
    std::snprintf(name, sizeof name, "frames/culling/frame-%05d.png", frame);
    EXPECT_GT(psnr(filmFrame("plain.mp4", frame), readImage(*here_ / name)), 30) << frame;
  }
  const std::string bytes = textOf(*here_ / "plain.mp4");
  EXPECT_LT(bytes.find("moov"), bytes.find("mdat")) << "cannot be shown before it is all there";
}

TEST_F(FilmTest, LastsAsLongAsThePathAtAnyFramesASecond) {
  for (const auto& [fps, frames] : {std::pair{"10", "13"}, {"30", "37"}, {"60", "73"}}) {
    ASSERT_EQ(play({"--tour", "slow.json", "--methods", "culling", "--size", "64x64", "--fps", fps,
                    "--video", "long.mkv"})
                  .status,
              0);
    auto film = probe("long.mkv");
    EXPECT_EQ(film["nb_read_frames"], frames);
    EXPECT_EQ(film["r_frame_rate"], std::string(fps) + "/1");
    EXPECT_NEAR(std::stod(film["duration"]), 1.21, 1.5 / std::stod(fps));
  }
}

TEST_F(FilmTest, OfTwoMethodsShowsThemSideBySideWithTheirCaptions) {
  ASSERT_EQ(play({"--tour", "tour.json", "--methods", "geometry,culling", "--size", "321x257",
                  "--video", "both.mp4", "--frames-dir", "both"})
                .status,
            0);
  EXPECT_EQ(probe("both.mp4")["width"], "646");
  EXPECT_EQ(probe("both.mp4")["height"], "258");
  const Image film = filmFrame("both.mp4", 6);
  const Image frame = readImage(*here_ / "both/culling/frame-00006.png");
  const glm::ivec2 below(321, 257 / 2);  // no caption is as high
  const Image truth = part(frame, {0, 257 - below.y}, below);
  EXPECT_GT(psnr(part(film, {0, 257 - below.y}, below), truth), 30);
  EXPECT_GT(psnr(part(film, {325, 257 - below.y}, below), truth), 30);
  const glm::ivec2 corner(100, 40);
  for (const int x : {0, 325}) {
    EXPECT_LT(psnr(part(film, {x, 0}, corner), part(frame, {0, 0}, corner)), 25) << "no caption";
  }
}

TEST_F(FilmTest, HasCaptionsWhereTheyAreAskedForAndNoneWhereNot) {
  const Arguments film = {"--tour",       "tour.json", "--size",  "200x160",
                          "--frames-dir", "plain",     "--video", "film.mp4"};
  const auto differs = [&](const Arguments& more) {
    Arguments arguments = film;
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(play(arguments).status, 0);
    const Image shown = part(filmFrame("film.mp4", 3), {0, 0}, {200, 160});
    return psnr(shown, readImage(*here_ / "plain/culling/frame-00003.png")) < 28;
  };
  EXPECT_TRUE(differs({"--methods", "culling", "--captions"}));
  EXPECT_FALSE(differs({"--methods", "culling,geometry", "--no-captions"}));
}

TEST_F(FilmTest, IsWebmByItsNameAndMayBeCalledAnything) {
  const std::string name = "-a film's: 100%d of $HOME.webm";
  ASSERT_EQ(
      play({"--tour", "tour.json", "--methods", "culling", "--size", "64x64", "--video=" + name})
          .status,
      0);
  const std::string bytes = textOf(*here_ / name);
  EXPECT_NE(bytes.substr(0, 64).find("webm"), std::string::npos);
}

TEST_F(FilmTest, WithinTheReportComesWithIt) {
  for (int again = 0; again < 2; ++again) {
    const ProgramResult played =
        play({"--tour", "tour.json", "--methods", "culling", "--size", "64x64", "--video",
              "report/films/tour.mp4", "-o", "report"});
    ASSERT_EQ(played.status, 0) << played.errors;
    EXPECT_TRUE(std::filesystem::exists(*here_ / "report/frames.csv"));
    EXPECT_TRUE(std::filesystem::exists(*here_ / "report/films/tour.mp4"));
  }
}

}  // namespace
}  // namespace enfilade
