// SPDX-License-Identifier: MIT
#include "hw/recording/byte_sink.hpp"

#include <gtest/gtest.h>

#include "hw/recording/byte_stream.hpp"
#include "tests/hw/recording/made_recording.hpp"

namespace scanbed::hw {
namespace {

TEST(ByteSinkTest, AFileHasItsNameOnlyWhenItIsFinished) {
  const TemporaryFolder folder;
  std::ofstream(folder / "x") << "older";
  FileSink sink(folder / "x");
  sink.append("new");
  EXPECT_EQ(bytes_of(folder / "x"), "older");
  EXPECT_EQ(bytes_of(folder / "x.part"), "new");
  sink.finish();
  EXPECT_EQ(bytes_of(folder / "x"), "new");
  EXPECT_FALSE(std::filesystem::exists(folder / "x.part"));
}

TEST(ByteSinkTest, WritesOverWhatIsThere) {
  const TemporaryFolder folder;
  FileSink sink(folder / "x");
  sink.append("abcdef");
  sink.overwrite(2, "XY");
  sink.append("g");
  sink.finish();
  EXPECT_EQ(bytes_of(folder / "x"), "abXYefg");
}

TEST(ByteSinkTest, SaysWhatCannotBeWritten) {
  EXPECT_THROW(FileSink("/nowhere/x"), WriteFault);
  FileSink full("/dev/full");
  EXPECT_FALSE(full.is_regular());
  EXPECT_THROW(full.append("x"), WriteFault);
}

TEST(ByteSinkTest, PackedBytesUnpackAgain) {
  const TemporaryFolder folder;
  std::string text;
  for (std::int64_t i = 0; i < 100000; ++i) text += std::to_string(i * i);
  const auto sink = pack_gzip(std::make_unique<FileSink>(folder / "x.gz"));
  for (std::size_t i = 0; i < text.size(); i += 1000) sink->append(std::string_view(text).substr(i, 1000));
  sink->finish();
  EXPECT_LT(bytes_of(folder / "x.gz").size(), text.size());
  const auto stream = unpack(open_file(folder / "x.gz"));
  std::string read(text.size() + 1, '\0');
  std::size_t num_read = 0;
  while (const std::size_t more = stream->read(std::span(read).subspan(num_read))) num_read += more;
  EXPECT_EQ(read.substr(0, num_read), text);
  EXPECT_EQ(stream->end(), StreamEnd::kClean);
}

// Scans of a slow laser are small pieces, seconds apart: a killed recorder must not take many along.
TEST(ByteSinkTest, PackedBytesAreThereBeforeTheEndButForAFewPieces) {
  const TemporaryFolder folder;
  const auto sink = pack_gzip(std::make_unique<FileSink>(folder / "x.gz"));
  for (int i = 0; i < 39; ++i) sink->append(std::string(9, static_cast<char>('0' + i % 10)) + "\n");
  const auto stream = unpack(from_memory(bytes_of(folder / "x.gz.part")));
  std::string read(1000, '\0');
  std::size_t num_read = 0;
  while (const std::size_t more = stream->read(std::span(read).subspan(num_read))) num_read += more;
  EXPECT_EQ(num_read, 320U);
  EXPECT_EQ(read.substr(310, 10), "111111111\n");
  EXPECT_EQ(stream->end(), StreamEnd::kCutOff);
}

}  // namespace
}  // namespace scanbed::hw
