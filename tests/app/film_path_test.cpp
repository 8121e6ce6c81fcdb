#include "app/film_path.h"

#include <gtest/gtest.h>

#include "scene/error.h"

namespace enfilade {
namespace {

/// Along x, as far as the square root of the time.
CameraPath pathAt(const std::vector<double>& times) {
  CameraPath path;
  for (const double time : times) {
    const auto x = static_cast<float>(std::sqrt(time - times.front()));
    path.poses.push_back({time, poseFromAngles({x, 1.6f, 0}, x, 0)});
  }
  return path;
}

TEST(FilmPath, OfAPoseAFrameIsThePathItself) {
  std::vector<double> times;
  for (int i = 0; i < 520; ++i) times.push_back(i / 30.0);
  const CameraPath path = pathAt(times);
  const CameraPath film = filmPath(path, 30, "");
  ASSERT_EQ(film.poses.size(), 520u);
  for (std::size_t i = 0; i < 520; ++i) {
    EXPECT_NEAR(glm::distance(film.poses[i].pose.position, path.poses[i].pose.position), 0, 1e-5);
  }
}

TEST(FilmPath, LastsAsLongAsThePathWhateverItsStepsAndTheFilms) {
  const CameraPath path = pathAt({10.0, 10.1, 10.15, 11.0, 12.5, 12.52, 14.0});
  for (const int fps : {1, 7, 24, 30, 60, 240}) {
    const CameraPath film = filmPath(path, fps, "");
    EXPECT_EQ(film.poses.size(), static_cast<std::size_t>(4 * fps + 1)) << fps;
    EXPECT_EQ(film.poses.front().pose.position, path.poses.front().pose.position);
    EXPECT_EQ(film.poses.back().pose.position, path.poses.back().pose.position);
    EXPECT_NEAR(film.poses.back().time, 14.0, 1e-9);
  }
}

TEST(FilmPath, StandsBetweenThePosesThatItsTimeIsBetween) {
  const CameraPath path = pathAt({0.0, 1.0, 4.0});  // x = 0, 1, 2
  const CameraPath film = filmPath(path, 2, "");
  const double expected[] = {0, 0.5, 1, 1 + 1 / 6.0, 1 + 2 / 6.0, 1.5, 1 + 4 / 6.0, 1 + 5 / 6.0, 2};
  ASSERT_EQ(film.poses.size(), std::size(expected));
  for (std::size_t i = 0; i < std::size(expected); ++i) {
    EXPECT_NEAR(film.poses[i].pose.position.x, expected[i], 1e-5) << i;
  }
}

TEST(FilmPath, OfPosesWithoutTimesShowsAPoseAFrame) {
  const CameraPath path = pathAt({0.0, 0.0, 0.0});
  EXPECT_EQ(filmPath(path, 60, "").poses.size(), 3u);
  EXPECT_EQ(filmPath(pathAt({3.0}), 60, "").poses.size(), 1u);
}

TEST(FilmPath, JumpsWhereTwoPosesHaveOneTime) {
  CameraPath path = pathAt({0.0, 1.0, 1.0, 2.0});
  path.poses[2].pose.position.x = 50;
  path.poses[3].pose.position.x = 60;
  const CameraPath film = filmPath(path, 2, "");
  ASSERT_EQ(film.poses.size(), 5u);
  EXPECT_NEAR(film.poses[1].pose.position.x, 0.5, 1e-5);
  EXPECT_NEAR(film.poses[2].pose.position.x, 50, 1e-5);
  EXPECT_NEAR(film.poses[3].pose.position.x, 55, 1e-5);
}

TEST(FilmPath, KeepsTheDoorsAndTheFieldOfView) {
  CameraPath path = pathAt({0.0, 1.0});
  path.doors.push_back({0.5, "door", false});
  path.vertical_fov = 0.7f;
  const CameraPath film = filmPath(path, 30, "");
  ASSERT_EQ(film.doors.size(), 1u);
  EXPECT_EQ(film.doors[0].time, 0.5);
  EXPECT_EQ(film.vertical_fov, 0.7f);
}

TEST(FilmPath, RefusesAPathThatLastsAYear) {
  try {
    filmPath(pathAt({0.0, 3.2e7}), 30, "long.txt");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_TRUE(std::string(error.what()).starts_with("long.txt: lasts 32000000 s"));
  }
}

}  // namespace
}  // namespace enfilade
