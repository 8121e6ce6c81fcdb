// Films that the built program does not make.

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/app/film_maker.h"

namespace enfilade {
namespace {

/// What needs ffmpeg to fail.
class FilmFailure : public FilmTest {};

TEST_F(FilmFailure, ThatFfmpegCannotMakeSaysWhatFfmpegSays) {
  const TemporaryFolder fake;
  writeText(fake / "ffmpeg", "#!/bin/sh\necho 'Unknown encoder' >&2\nexit 1\n");
  std::filesystem::permissions(fake / "ffmpeg", std::filesystem::perms::owner_all);
  const auto before = here_->tree();
  const std::string old = std::getenv("PATH");
  setenv("PATH", fake.path().c_str(), 1);
  const ProgramResult played = play({"--tour", "tour.json", "--methods", "culling", "--size",
                                     "64x64", "--video", "new.mp4", "-o", "new"});
  setenv("PATH", old.c_str(), 1);
  EXPECT_EQ(played.status, 3);
  EXPECT_EQ(played.errors, "enfilade: ffmpeg: Unknown encoder\n");
  EXPECT_EQ(here_->tree(), before);
}

TEST_F(FilmFailure, LeavesNothingWhenItIsStopped) {
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) {
    const auto before = here_->tree();
    const TemporaryFolder streams;
    const pid_t child = fork();
    if (child == 0) {
      const int messages = open((streams / "err").c_str(), O_WRONLY | O_CREAT, 0600);
      dup2(messages, STDERR_FILENO);
      if (chdir(here_->path().c_str()) != 0) _exit(1);
      execl(ENFILADE_PROGRAM, "enfilade", "play", "house", "--methods", "culling", "--size",
            "320x256", "--fps", "240", "--video", "stopped.mp4", "-o", "stopped", nullptr);
      _exit(1);
    }
    for (int i = 0; i < 600; ++i) {  // until it has begun with the film
      if (textOf(streams / "err").find("playing by culling") != std::string::npos) break;
      usleep(50'000);
    }
    usleep(300'000);
    EXPECT_NE(here_->tree(), before);
    kill(child, signal);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    EXPECT_EQ(here_->tree(), before);
  }
}

/// What needs no ffmpeg to be told.
class FilmRefusal : public FilmTest {
 protected:
  void SetUp() override {}

  static void expectRefusal(const Arguments& arguments, int status, const std::string& line) {
    const auto before = here_->tree();
    const ProgramResult played = play(arguments);
    EXPECT_EQ(played.status, status);
    EXPECT_EQ(played.errors, "enfilade: " + line + "\n");
    EXPECT_EQ(played.output, "");
    EXPECT_EQ(here_->tree(), before);
  }
};

TEST_F(FilmRefusal, OfAFormatThatThereIsNot) {
  for (const std::string name : {"tour.avi", "tour", ".mp4", "tour.mp4/"}) {
    expectRefusal(
        {"--methods", "culling", "--video", name}, 1,
        "--video " + name + ": no film's name; the extension says the format: .mp4, .mkv, .webm");
  }
}

TEST_F(FilmRefusal, WithoutFfmpegBeforeAnyWork) {
  const std::string old = std::getenv("PATH");
  setenv("PATH", "", 1);
  expectRefusal({"--methods", "culling", "--video", "tour.mp4", "-o", "new"}, 3,
                "ffmpeg: is not there, and films are made by it: apt-get install ffmpeg");
  setenv("PATH", old.c_str(), 1);
}

TEST_F(FilmRefusal, OfFramesASecondThatAreNone) {
  EXPECT_EQ(play({"--methods", "culling", "--video", "tour.mp4", "--fps", "0"}).status, 1);
  EXPECT_EQ(play({"--methods", "culling", "--video", "tour.mp4", "--fps", "241"}).status, 1);
}

TEST_F(FilmRefusal, OfAPlaceThatCannotBeWrittenTo) {
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no ffmpeg";
  expectRefusal({"--methods", "culling", "--video", "nowhere/tour.mp4"}, 3,
                "nowhere/tour.mp4: cannot be written: No such file or directory");
}

}  // namespace
}  // namespace enfilade
