// SPDX-License-Identifier: MIT
#include "hw/recording/open_recording.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "core/errors/input_error.hpp"
#include "hw/recording/bag_reader.hpp"
#include "hw/recording/bag_writer.hpp"
#include "hw/recording/byte_sink.hpp"
#include "hw/recording/carmen_log.hpp"
#include "hw/recording/carmen_writer.hpp"
#include "hw/recording/json_lines.hpp"
#include "hw/recording/mcap_reader.hpp"
#include "hw/recording/mcap_writer.hpp"
#include "hw/recording/player_log.hpp"
#include "hw/recording/player_writer.hpp"
#include "hw/recording/recording_format.hpp"
#include "hw/recording/streamed_reader.hpp"
#include "hw/recording/time_order.hpp"

namespace scanbed::hw {
namespace {

/// Of a file: long comments may stand before what tells its format.
constexpr std::size_t kMostHead = std::size_t{1} << 16;

/// What the head of a packed file unpacks to, or the head itself.
std::string unpacked_head(const std::string& head) {
  const std::unique_ptr<ByteStream> stream = unpack(from_memory(head));
  std::string unpacked(kMostHead, '\0');
  unpacked.resize(stream->read(unpacked));
  return unpacked;
}

/// A stream that is looked into before it is read: no farther than until its format shows, since what is
/// behind may be long in coming.
class PeekedBytes final : public ByteStream {
 public:
  explicit PeekedBytes(std::unique_ptr<ByteStream> source) : source_(std::move(source)) {
    std::string piece(kMostHead, '\0');
    while (!format_ && head_.size() < kMostHead) {
      const std::size_t num_read = source_->read(std::span(piece).first(kMostHead - head_.size()));
      if (num_read == 0) break;
      head_.append(piece, 0, num_read);
      format_ = format_of_content(unpacked_head(head_));
    }
  }

  /// Empty where the content does not tell.
  std::optional<RecordingFormat> format() const { return format_; }

  std::size_t read(std::span<char> out) override {
    if (position_ == head_.size()) return source_->read(out);
    const std::size_t num_read = std::min(out.size(), head_.size() - position_);
    std::copy_n(head_.data() + position_, num_read, out.data());
    position_ += num_read;
    return num_read;
  }

  bool wait_until(double deadline_s) override {
    return position_ < head_.size() || source_->wait_until(deadline_s);
  }

  StreamEnd end() const override { return source_->end(); }

 private:
  std::unique_ptr<ByteStream> source_;
  std::string head_;
  std::optional<RecordingFormat> format_;
  std::size_t position_ = 0;
};

}  // namespace

void RecordingOptions::validate() const {
  require(!no_return_m || *no_return_m > 0.0, "log.no_return_m", no_return_m.value_or(0.0), "> 0");
}

std::unique_ptr<ScanReader> open_recording(const std::filesystem::path& path, const RecordingOptions& options,
                                           DamageReport report) {
  return open_recording(open_file(path, options.is_interrupted), path.string(), options, std::move(report));
}

std::unique_ptr<ScanReader> open_recording(std::unique_ptr<ByteStream> bytes, const std::string& name,
                                           const RecordingOptions& options, DamageReport report) {
  options.validate();
  auto peeked = std::make_unique<PeekedBytes>(std::move(bytes));
  std::optional<RecordingFormat> format = peeked->format();
  if (!format) format = format_of_name(name);
  std::unique_ptr<ScanSource> source;
  switch (format.value_or(RecordingFormat::kCarmen)) {
    case RecordingFormat::kCarmen:
      return std::make_unique<CarmenLog>(
          std::move(peeked), name,
          CarmenLogOptions{
              .only = options.only, .no_return_m = options.no_return_m, .is_guess = !format.has_value()},
          std::move(report));
    case RecordingFormat::kPlayer:
      source = read_player_log(std::move(peeked), name, {.only = options.only}, std::move(report));
      break;
    case RecordingFormat::kBag:
      source = read_bag(unpack(std::move(peeked)), name, {.only = options.only}, report);
      source = in_time_order(std::move(source), name, std::move(report));
      break;
    case RecordingFormat::kMcap:
      source = read_mcap(unpack(std::move(peeked)), name, {.only = options.only}, report);
      source = in_time_order(std::move(source), name, std::move(report));
      break;
    case RecordingFormat::kJsonLines:
      source = read_json_lines(std::move(peeked), name, {.only = options.only}, std::move(report));
      break;
  }
  return std::make_unique<StreamedReader>(std::move(source), name, options);
}

std::unique_ptr<ScanWriter> create_recording(const std::filesystem::path& path,
                                             const RecordingMetadata& metadata) {
  const std::optional<RecordingFormat> format = format_of_name(path);
  if (!format || path.extension() == ".part") {
    throw InputError(path.string() +
                     ": its ending is of no recording; allowed: .jsonl .mcap .bag .log .clf " +
                     ".player .plog, and .gz behind .jsonl .log .clf .player .plog");
  }
  auto file = std::make_unique<FileSink>(path);
  if (*format == RecordingFormat::kBag) return write_bag(std::move(file));
  if (*format == RecordingFormat::kMcap) return write_mcap(std::move(file), metadata);
  std::unique_ptr<ByteSink> sink = std::move(file);
  if (is_packed_name(path)) sink = pack_gzip(std::move(sink));
  if (*format == RecordingFormat::kCarmen) return write_carmen_log(std::move(sink), metadata);
  if (*format == RecordingFormat::kPlayer) return write_player_log(std::move(sink), metadata);
  return write_json_lines(std::move(sink), metadata);
}

}  // namespace scanbed::hw
