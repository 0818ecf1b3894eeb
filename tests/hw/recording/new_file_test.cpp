// SPDX-License-Identifier: MIT
#include "hw/recording/new_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cerrno>
#include <memory>

#include "tests/hw/recording/made_recording.hpp"

namespace scanbed::hw {
namespace {

namespace fs = std::filesystem;
using Unfinished = NewFile::Unfinished;

void put(const NewFile& file, std::string_view text) {
  ASSERT_EQ(::write(file.descriptor(), text.data(), text.size()), static_cast<ssize_t>(text.size()));
}

std::string fault_of(const fs::path& path, Unfinished unfinished) {
  try {
    NewFile file(path, unfinished);
  } catch (const WriteFault& fault) {
    return fault.what();
  }
  return "";
}

class NewFileTest : public ::testing::TestWithParam<Unfinished> {
 protected:
  fs::path made(const std::string& name, std::string_view text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  std::ptrdiff_t num_files() const { return std::distance(fs::directory_iterator(folder_ / ""), {}); }

  TemporaryFolder folder_;
};

TEST_P(NewFileTest, HasItsNameOnlyWhenItIsFinished) {
  const fs::path path = made("x", "older");
  NewFile file(path, GetParam());
  put(file, "new");
  EXPECT_EQ(bytes_of(path), "older");
  EXPECT_EQ(bytes_of(file.growing()), "new");
  file.finish();
  EXPECT_EQ(bytes_of(path), "new");
  EXPECT_EQ(num_files(), 1);
}

TEST_P(NewFileTest, WritesThroughALinkEvenToWhatIsNotThereYet) {
  fs::create_directory(folder_ / "far");
  fs::create_symlink("far/x", folder_ / "near");
  fs::create_symlink(folder_ / "near", folder_ / "link");
  for (const char* text : {"one", "two"}) {
    NewFile file(folder_ / "link", GetParam());
    put(file, text);
    file.finish();
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "near"));
    EXPECT_EQ(bytes_of(folder_ / "far/x"), text);
  }
}

TEST_P(NewFileTest, WritesIntoAPipeWithoutReplacingIt) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const FileDescriptor reader(::open(pipe.c_str(), O_RDONLY | O_NONBLOCK));
  NewFile file(pipe, GetParam());
  EXPECT_FALSE(file.is_regular());
  put(file, "text");
  file.finish();
  EXPECT_TRUE(fs::is_fifo(pipe));
  std::string read(9, '\0');
  EXPECT_EQ(::read(reader.get(), read.data(), read.size()), 4);
  EXPECT_EQ(num_files(), 1);
}

TEST_P(NewFileTest, SaysWhatCannotBeWritten) {
  EXPECT_EQ(fault_of(folder_ / "none/x", GetParam()),
            (folder_ / "none/x").string() + ": cannot be written: No such file or directory");
  EXPECT_EQ(fault_of(folder_ / "", GetParam()), (folder_ / "").string() + ": is a folder, not a file");
  NewFile file(folder_ / "x", GetParam());
  fs::create_directory(folder_ / "x");
  EXPECT_THROW(file.finish(), WriteFault);
}

INSTANTIATE_TEST_SUITE_P(Unfinished, NewFileTest, ::testing::Values(Unfinished::kRemoved, Unfinished::kKept),
                         [](const auto& instance) {
                           return instance.param == Unfinished::kKept ? "Kept" : "Removed";
                         });

TEST_F(NewFileTest, UnfinishedItGoesAwayOrStays) {
  { put(NewFile(folder_ / "a", Unfinished::kRemoved), "half"); }
  EXPECT_EQ(num_files(), 0);
  { put(NewFile(folder_ / "a", Unfinished::kKept), "half"); }
  EXPECT_EQ(bytes_of(folder_ / "a.part"), "half");
}

TEST_F(NewFileTest, RefusesASecondWriterUntilTheFirstOneIsGone) {
  auto first = std::make_unique<NewFile>(folder_ / "x", Unfinished::kKept);
  put(*first, "first");
  EXPECT_EQ(fault_of(folder_ / "x", Unfinished::kKept),
            (folder_ / "x").string() + ": is being written already, as " + (folder_ / "x.part").string());
  EXPECT_EQ(bytes_of(folder_ / "x.part"), "first");
  first.reset();
  NewFile second(folder_ / "x", Unfinished::kKept);
  put(second, "second");
  second.finish();
  NewFile third(folder_ / "x", Unfinished::kKept);
  EXPECT_EQ(bytes_of(folder_ / "x"), "second");
}

}  // namespace
}  // namespace scanbed::hw
