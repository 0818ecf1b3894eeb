// SPDX-License-Identifier: MIT
#include "hw/recording/byte_stream.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <utility>

#include "core/errors/input_error.hpp"
#include "hw/serial/steady_clock.hpp"
#include "hw/serial/stop_signal.hpp"
#include "tests/hw/recording/late_parts.hpp"
#include "tests/support/gzip.hpp"

namespace scanbed::hw {
namespace {

using tests::gzip;

/// Reads all, `step` bytes at a time.
std::string drain(ByteStream& bytes, std::size_t step = 1000) {
  std::string all;
  std::string block(step, '\0');
  while (const std::size_t num_read = bytes.read(block)) all.append(block, 0, num_read);
  EXPECT_EQ(bytes.read(block), 0U) << "the end must stay the end";
  return all;
}

std::string drain_some(ByteStream& bytes, std::size_t num_bytes) {
  std::string block(num_bytes, '\0');
  block.resize(bytes.read(block));
  return block;
}

/// Gives one byte at a time, as a slow pipe does.
class Trickle final : public ByteStream {
 public:
  explicit Trickle(std::string bytes) : bytes_(std::move(bytes)) {}
  std::size_t read(std::span<char> out) override {
    if (position_ == bytes_.size()) return 0;
    out[0] = bytes_[position_++];
    return 1;
  }

 private:
  std::string bytes_;
  std::size_t position_ = 0;
};

/// A text that fills several of the unpacker's 64 KiB buffers even when packed.
std::string long_text() {
  std::string text;
  unsigned state = 1;
  for (int i = 0; i < 200000; ++i) {
    state = state * 1664525U + 1013904223U;
    text.push_back(static_cast<char>(state >> 24U));
  }
  return text;
}

class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& content)
      : path_(std::filesystem::temp_directory_path() / ("byte_stream_test." + std::to_string(::getpid()))) {
    std::ofstream(path_, std::ios::binary) << content;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { std::filesystem::remove(path_); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string refusal(const std::filesystem::path& path) {
  try {
    open_file(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

TEST(OpenFileTest, GivesTheBytesOfTheFile) {
  const TemporaryFile file(std::string("a\0b\n", 4));
  EXPECT_EQ(drain(*open_file(file.path())), std::string("a\0b\n", 4));
}

TEST(OpenFileTest, NamesAMissingFile) {
  EXPECT_EQ(refusal("/nowhere/x.log"), "/nowhere/x.log: cannot be opened: No such file or directory");
}

TEST(OpenFileTest, RefusesAFolder) {
  EXPECT_EQ(refusal("/tmp"), "/tmp: is a folder; expected a file");
}

TEST(OpenFileTest, RefusesAnEmptyFile) {
  const TemporaryFile file("");
  EXPECT_EQ(refusal(file.path()), file.path().string() + ": is empty");
}

TEST(UnpackTest, PassesPlainBytesOn) {
  for (const std::string text : {"", "a", "\x1f", "\x1fz", "plain text"}) {
    const auto bytes = unpack(from_memory(text));
    EXPECT_EQ(drain(*bytes), text);
    EXPECT_EQ(bytes->end(), StreamEnd::kClean);
  }
  EXPECT_EQ(drain(*unpack(from_memory(long_text()))), long_text());
}

TEST(UnpackTest, UnpacksWhatTheMagicBytesAnnounce) {
  for (const std::size_t step : {1U, 7U, 100000U}) {
    const auto bytes = unpack(from_memory(gzip(long_text())));
    EXPECT_EQ(drain(*bytes, step), long_text());
    EXPECT_EQ(bytes->end(), StreamEnd::kClean);
  }
}

TEST(UnpackTest, UnpacksBytesThatTrickle) {
  EXPECT_EQ(drain(*unpack(std::make_unique<Trickle>(gzip("one") + gzip("two")))), "onetwo");
  EXPECT_EQ(drain(*unpack(std::make_unique<Trickle>("plain"))), "plain");
}

TEST(UnpackTest, JoinsMembersAndSkipsPadding) {
  const std::string padding(100000, '\0');
  const auto bytes = unpack(from_memory(gzip("one ") + gzip("") + gzip("two") + padding));
  EXPECT_EQ(drain(*bytes), "one two");
  EXPECT_EQ(bytes->end(), StreamEnd::kClean);
}

TEST(UnpackTest, SaysThatDataIsCutOffWhereverItIs) {
  const std::string packed = gzip("some text that is packed");
  for (std::size_t size = 2; size < packed.size(); ++size) {
    const auto bytes = unpack(from_memory(packed.substr(0, size)));
    const std::string text = drain(*bytes);
    EXPECT_EQ(bytes->end(), StreamEnd::kCutOff) << size;
    EXPECT_TRUE(std::string("some text that is packed").starts_with(text)) << size;
  }
}

TEST(UnpackTest, SaysThatDataIsDamaged) {
  const std::string text = "some text that is packed";
  std::string wrong_checksum = gzip(text);
  wrong_checksum[wrong_checksum.size() - 8] ^= 1;  // RFC 1952: CRC32 and size are the last eight bytes
  const auto bytes = unpack(from_memory(wrong_checksum));
  EXPECT_EQ(drain(*bytes), text);
  EXPECT_EQ(bytes->end(), StreamEnd::kDamaged);

  const auto garbage = unpack(from_memory(gzip(text) + "garbage"));
  EXPECT_EQ(drain(*garbage), text);
  EXPECT_EQ(garbage->end(), StreamEnd::kDamaged);
}

// A pipe's writer may be slow; a file is all there.
TEST(ByteStreamTest, WaitsForAPipeNoLongerThanIsAllowed) {
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe2(pipe.data(), O_CLOEXEC), 0);
  const auto bytes = open_file("/proc/self/fd/" + std::to_string(pipe[0]));
  ::close(pipe[0]);
  const double before_s = steady_now_s();
  EXPECT_FALSE(bytes->wait_until(before_s + 0.02));
  EXPECT_GE(steady_now_s(), before_s + 0.02);
  EXPECT_FALSE(bytes->wait_until(before_s));
  ASSERT_EQ(::write(pipe[1], "abc", 3), 3);
  EXPECT_TRUE(bytes->wait_until(before_s));
  EXPECT_EQ(drain_some(*bytes, 3), "abc");
  EXPECT_FALSE(bytes->wait_until(before_s));
  ::close(pipe[1]);
  EXPECT_TRUE(bytes->wait_until(before_s)) << "the end has come";
}

// A pipe whose writer says nothing, and a FIFO that has none yet.
TEST(ByteStreamTest, AWaitForBytesCanBeInterrupted) {
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe2(pipe.data(), O_CLOEXEC), 0);
  const TemporaryFile place("");
  const std::filesystem::path fifo = place.path().string() + ".fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  for (const std::string& path : {"/proc/self/fd/" + std::to_string(pipe[0]), fifo.string()}) {
    int num_asked = 0;
    const auto bytes = open_file(path, [&] { return ++num_asked == 3; });
    EXPECT_THROW(drain_some(*bytes, 1), Stopped) << path;
    EXPECT_EQ(num_asked, 3);
  }
  std::filesystem::remove(fifo);
  for (const int end : pipe) ::close(end);
}

TEST(ByteStreamTest, NeverWaitsForWhatIsThere) {
  const TemporaryFile file("ab");
  EXPECT_TRUE(open_file(file.path())->wait_until(0.0));
  EXPECT_TRUE(from_memory("")->wait_until(0.0));
}

TEST(ByteStreamTest, WhatIsUnpackedHasArrivedWithItsBytes) {
  std::size_t num_arrived = 0;
  const auto plain = unpack(std::make_unique<LateParts>(std::vector<std::string>{"abc", "d"}, num_arrived));
  EXPECT_TRUE(plain->wait_until(0.0));
  EXPECT_EQ(drain_some(*plain, 3), "abc");
  EXPECT_FALSE(plain->wait_until(0.0));
  EXPECT_EQ(drain(*plain), "d");
  EXPECT_TRUE(plain->wait_until(0.0));
  EXPECT_TRUE(unpack(from_memory(gzip("abc")))->wait_until(0.0));
}

}  // namespace
}  // namespace scanbed::hw
