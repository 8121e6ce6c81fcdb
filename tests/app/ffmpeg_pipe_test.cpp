// The process at the other end of the pipe, played by small scripts.

#include "app/ffmpeg_pipe.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>

#include "scene/error.h"
#include "tests/app/temporary_folder.h"

namespace enfilade {
namespace {

class FfmpegPipeTest : public ::testing::Test {
 protected:
  std::string script(const std::string& lines) {
    const std::string file = here_ / "ffmpeg";
    writeText(file, "#!/bin/sh\n" + lines + "\n");
    chmod(file.c_str(), 0755);
    return file;
  }

  /// Writes `bytes` bytes to a script and finishes; what it says of that.
  std::string complaint(const std::string& lines, std::size_t bytes) {
    try {
      FfmpegPipe pipe(script(lines), {});
      const std::vector<std::uint8_t> some(1 << 16, 'x');
      for (std::size_t done = 0; done < bytes; done += some.size()) pipe.write(some);
      pipe.finish();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kMachine);
      return error.what();
    }
    return {};
  }

  TemporaryFolder here_;
};

TEST_F(FfmpegPipeTest, HandsOnItsArgumentsAndItsInputAsTheyAre) {
  const std::string odd = "a b;$(touch c)'\"*.mp4";
  FfmpegPipe pipe(script("printf '%s' \"$1\" >" + here_ / "name" + "; cat >" + here_ / "input"),
                  {odd});
  const std::vector<std::uint8_t> bytes = {'1', 0, '2'};
  pipe.write(bytes);
  pipe.finish();
  EXPECT_EQ(textOf(here_ / "name"), odd);
  EXPECT_EQ(textOf(here_ / "input"), std::string("1\0"
                                                 "2",
                                                 3));
}

TEST_F(FfmpegPipeTest, TellsTheLastLineThatItSaidWhenItFails) {
  EXPECT_EQ(complaint("cat >/dev/null; echo first >&2; echo 'No space left' >&2; exit 1", 1),
            "ffmpeg: No space left");
}

TEST_F(FfmpegPipeTest, ThatEndsEarlyIsAnErrorAndNoSignal) {
  EXPECT_EQ(complaint("echo 'Unknown encoder' >&2; exit 1", 1 << 24), "ffmpeg: Unknown encoder");
  EXPECT_EQ(complaint("exit 7", 1 << 24), "ffmpeg: ended early with status 7");
  EXPECT_EQ(complaint("kill -9 $$", 1 << 24), "ffmpeg: was ended by signal 9");
}

TEST_F(FfmpegPipeTest, SaysMoreThanAPipeHoldsWithoutStopping) {
  EXPECT_EQ(complaint("yes warning | head -n 100000 >&2; cat >/dev/null", 1 << 20), "");
}

TEST_F(FfmpegPipeTest, StandsStillWhileItIsHalted) {
  FfmpegPipe pipe(script("while read line; do echo $line >>" + here_ / "lines" + "; done"), {});
  pipe.halt();
  const std::vector<std::uint8_t> line = {'x', '\n'};
  pipe.write(line);
  usleep(50'000);
  EXPECT_EQ(textOf(here_ / "lines"), "");
  pipe.goOn();
  pipe.finish();
  EXPECT_EQ(textOf(here_ / "lines"), "x\n");
}

TEST_F(FfmpegPipeTest, IsEndedWithWhatHoldsItHaltedOrNot) {
  for (const bool halted : {false, true}) {
    FfmpegPipe pipe(script("cat >/dev/null; sleep 1000"), {});
    if (halted) pipe.halt();
  }
}

TEST_F(FfmpegPipeTest, IsFoundByPathAndSoughtNowhereElse) {
  const std::string old = std::getenv("PATH");
  script("");
  setenv("PATH", ("/nowhere::" + here_.path()).c_str(), 1);
  EXPECT_EQ(findFfmpeg(), here_ / "ffmpeg");
  setenv("PATH", "", 1);
  EXPECT_THROW(findFfmpeg(), Error);
  setenv("PATH", old.c_str(), 1);
}

}  // namespace
}  // namespace enfilade
