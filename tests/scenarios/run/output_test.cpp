// SPDX-License-Identifier: MIT
#include "scenarios/run/output.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/scenarios/support.hpp"

namespace scanbed::scenarios {
namespace {

namespace fs = std::filesystem;
using testing::read_file;
using testing::TemporaryFolder;

std::size_t num_files(const TemporaryFolder& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
}

TEST(OutputTest, GivesAFileItsNameWhenItIsComplete) {
  const TemporaryFolder folder;
  Output output(folder / "a");
  EXPECT_TRUE(output.write("one\n"));
  EXPECT_FALSE(fs::exists(folder / "a"));
  EXPECT_TRUE(output.write(std::string(200'000, 'x')));
  EXPECT_TRUE(output.commit());
  EXPECT_EQ(read_file(folder / "a"), "one\n" + std::string(200'000, 'x'));
  EXPECT_EQ(num_files(folder), 1u);
}

TEST(OutputTest, LeavesTheOldFileWhereTheNewOneWasNotCommitted) {
  const TemporaryFolder folder;
  testing::write_file(folder / "a", "old");
  { Output(folder / "a").write("new"); }
  EXPECT_EQ(read_file(folder / "a"), "old");
  EXPECT_EQ(num_files(folder), 1u);
}

TEST(OutputTest, WritesThroughALink) {
  const TemporaryFolder folder;
  testing::write_file(folder / "a", "old");
  fs::create_symlink(folder / "a", folder / "b");
  write_whole(folder / "b", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "b"));
  EXPECT_EQ(read_file(folder / "a"), "new");
}

TEST(OutputTest, WritesToDevicesWithoutReplacingThem) {
  write_whole("/dev/null", "text");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(OutputTest, ThrowsWhereItCannotWrite) {
  const TemporaryFolder folder;
  EXPECT_THROW(Output(folder / "none/a"), OutputFault);
  EXPECT_THROW(Output{folder.path()}, OutputFault);
  EXPECT_THROW(write_whole("/dev/full", "text"), OutputFault);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST(OutputTest, SaysWhenTheReaderOfAPipeHasGone) {
  const TemporaryFolder folder;
  ::signal(SIGPIPE, SIG_IGN);
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const int reader = ::open((folder / "pipe").c_str(), O_RDONLY | O_NONBLOCK);
  Output output(folder / "pipe");
  EXPECT_TRUE(output.write("one\n"));
  ::close(reader);
  EXPECT_FALSE(output.write("two\n"));
  EXPECT_FALSE(output.write("three\n"));
  EXPECT_FALSE(output.commit());
}

}  // namespace
}  // namespace scanbed::scenarios
