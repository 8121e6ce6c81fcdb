#include "scene/file_io.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "scene_test_tools.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

std::string textOf(const std::string& file) {
  const std::vector<std::uint8_t> bytes = readFile(file);
  return {bytes.begin(), bytes.end()};
}

std::size_t filesIn(const std::string& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(ReadFile, GivesEveryByte) {
  const TempFolder folder;
  const std::string content = std::string("a\0b\n", 4) + std::string(100'000, '\xff');
  EXPECT_EQ(textOf(folder.file("x", content)), content);
  EXPECT_TRUE(readFile(folder.file("empty", "")).empty());
}

TEST(ReadFile, TheStartOfAFileIsAsLongAsAskedForOrAsTheFile) {
  const TempFolder folder;
  const std::string file = folder.file("x", "content");
  EXPECT_EQ(readFileStart(file, 3), (std::vector<std::uint8_t>{'c', 'o', 'n'}));
  EXPECT_EQ(readFileStart(file, 100), readFile(file));
  EXPECT_TRUE(readFileStart(file, 0).empty());
}

TEST(ReadFile, SaysThatAFileIsMissing) {
  const TempFolder folder;
  expectError([&] { readFile(folder / "none"); }, ErrorKind::kBadInput, folder / "none",
              "no such file");
  folder.file("x", "");
  expectError([&] { readFile(folder / "x/y"); }, ErrorKind::kBadInput, folder / "x/y",
              "no such file");
}

TEST(ReadFile, RejectsADirectory) {
  const TempFolder folder;
  expectError([&] { readFile(folder.path()); }, ErrorKind::kBadInput, folder.path(),
              "is a directory");
}

TEST(ReadFile, RejectsAPipeWithoutHanging) {
  const TempFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  expectError([&] { readFile(folder / "pipe"); }, ErrorKind::kBadInput, folder / "pipe",
              "is not a regular file");
}

TEST(WriteFileAtomically, ReplacesTheOldContentAndLeavesNothingElse) {
  const TempFolder folder;
  writeFileAtomically(folder / "x", std::string("a longer text"));
  writeFileAtomically(folder / "x", std::string("short"));
  EXPECT_EQ(textOf(folder / "x"), "short");
  EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(WriteFileAtomically, LeavesNothingBehindWhenItFails) {
  const TempFolder folder;
  fs::create_directory(folder / "taken");
  expectError([&] { writeFileAtomically(folder / "taken", std::string("x")); }, ErrorKind::kMachine,
              folder / "taken", "is a directory");
  expectError([&] { writeFileAtomically(folder / "no/x", std::string("x")); }, ErrorKind::kMachine,
              folder / "no/x", "No such file or directory");
  EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(WriteFileAtomically, KeepsTheOldContentWhenTheNewDoesNotFit) {
  const TempFolder folder;
  folder.file("x", "old");
  // A limit on the size of files does what a full disk would.
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit old_limit{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old_limit), 0);
  const rlimit limit{1000, old_limit.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  expectError([&] { writeFileAtomically(folder / "x", std::string(5000, 'n')); },
              ErrorKind::kMachine, folder / "x", "File too large");
  ::setrlimit(RLIMIT_FSIZE, &old_limit);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_EQ(textOf(folder / "x"), "old");
  EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(WriteFileAtomically, LeavesNothingBehindWhereASignalEndsTheProgram) {
  const TempFolder folder;
  folder.file("x", "old");
  const pid_t child = ::fork();
  if (child == 0) {
    // In the midst of writing.
    std::signal(SIGXFSZ, [](int) {
      removeHalfWrittenFiles();
      ::_exit(7);
    });
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    writeFileAtomically(folder / "x", std::string(5000, 'n'));
    ::_exit(0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_EQ(textOf(folder / "x"), "old");
  EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(WriteFileAtomically, KeepsWhoMayReadAFile) {
  const TempFolder folder;
  const std::string file = folder.file("x", "old");
  for (const fs::perms perms : {fs::perms(0600), fs::perms(0444)}) {
    fs::permissions(file, perms);
    writeFileAtomically(file, std::string("new"));
    EXPECT_EQ(fs::status(file).permissions(), perms);
  }
}

TEST(ReadFile, RejectsOneThatIsTooLargeBeforeReadingIt) {
  const TempFolder folder;
  const std::string file = folder.file("x", "1234");
  fs::resize_file(file, std::uintmax_t{1} << 40);  // but for its start it takes no room
  expectError([&] { readFile(file, 3 << 20); }, ErrorKind::kBadInput, file,
              "is larger than 3 MiB, too large for what it is");
  fs::resize_file(file, 4);
  EXPECT_EQ(readFile(file, 4).size(), 4u);
}

TEST(WriteFileAtomically, TellsThatTheDiskIsFull) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  expectError([] { writeFileAtomically("/dev/full", std::string("x")); }, ErrorKind::kMachine,
              "/dev/full", "No space left on device");
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST(WriteFileAtomically, KeepsASymbolicLink) {
  const TempFolder folder;
  folder.file("target", "old");
  fs::create_symlink("target", folder / "link");
  writeFileAtomically(folder / "link", std::string("new"));
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(textOf(folder / "target"), "new");
}

TEST(WriteFileAtomically, FollowsALinkToAFileThatIsNotThereYet) {
  const TempFolder folder;
  fs::create_directory(folder / "there");
  fs::create_symlink("there/new", folder / "link");
  writeFileAtomically(folder / "link", std::string("new"));
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(textOf(folder / "there/new"), "new");
  fs::create_symlink("loop", folder / "loop");
  expectError([&] { writeFileAtomically(folder / "loop", std::string("x")); }, ErrorKind::kMachine,
              folder / "loop", "leads to itself");
}

TEST(WriteFileAtomically, WritesOnWhatTheShellHasOpened) {
  const TempFolder folder;
  std::FILE* log = std::fopen(folder.file("log", "before, ").c_str(), "ab");  // NOLINT
  ASSERT_NE(log, nullptr);
  writeFileAtomically("/dev/fd/" + std::to_string(fileno(log)), std::string("after"));
  std::fclose(log);  // NOLINT
  EXPECT_EQ(textOf(folder / "log"), "before, after");
  if (!fs::is_directory("/dev/shm")) return;
  const std::string memory = "/dev/shm/enfilade-" + std::to_string(::getpid());
  writeFileAtomically(memory, std::string("old"));
  writeFileAtomically(memory, std::string("new"));
  EXPECT_EQ(textOf(memory), "new") << "a file like any other";
  fs::remove(memory);
}

TEST(CreateTemporary, TakesNoNameThatIsTaken) {
  const TempFolder folder;
  const std::string first = createTemporary(folder / "x"), second = createTemporary(folder / "x");
  EXPECT_NE(first, second);
  EXPECT_TRUE(first.starts_with(folder / "x.tmp-"));
  const std::string left = createTemporaryFolder(folder / "y");
  writeFileAtomically(left + "/stale", std::string("x"));
  EXPECT_TRUE(fs::is_empty(createTemporaryFolder(folder / "y")));
  expectError([&] { createTemporary(folder / "no/x"); }, ErrorKind::kMachine, folder / "no/x",
              "No such file or directory");
}

TEST(CreateFolders, CreatesParentsAndAcceptsWhatIsThere) {
  const TempFolder folder;
  createFolders(folder / "a/b/c");
  createFolders(folder / "a/b/c");
  EXPECT_TRUE(fs::is_directory(folder / "a/b/c"));
}

TEST(CreateFolders, SaysThatAFileStandsInTheWay) {
  const TempFolder folder;
  folder.file("x", "");
  expectError([&] { createFolders(folder / "x/y"); }, ErrorKind::kMachine, folder / "x/y",
              "Not a directory");
}

TEST(Sha256Hex, AgreesWithTheExamplesOfItsStandard) {
  // NIST FIPS 180-4 example values.
  const std::string abc = "abc";
  EXPECT_EQ(sha256Hex({reinterpret_cast<const std::uint8_t*>(abc.data()), abc.size()}),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256Hex({}), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

}  // namespace
}  // namespace enfilade
