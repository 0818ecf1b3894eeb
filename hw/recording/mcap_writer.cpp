// SPDX-License-Identifier: MIT
#include "hw/recording/mcap_writer.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/errors/input_error.hpp"
#include "core/text/utf8.hpp"
#include "hw/recording/compression.hpp"
#include "hw/recording/little_endian.hpp"
#include "hw/recording/mcap_message.hpp"
#include "hw/recording/mcap_record.hpp"
#include "hw/recording/mcap_schemas.hpp"
#include "hw/recording/nano_time.hpp"

namespace scanbed::hw {
namespace {

constexpr std::size_t kMaxMcapChunk = std::size_t{1} << 20;
constexpr double kMaxMcapChunk_s = 1.0;
constexpr std::size_t kMostChannel = 65535;  // their numbers have 16 bits

struct McapIndexEntry {
  std::uint64_t time_ns = 0;
  std::uint64_t offset = 0;  // of the message in the unpacked chunk
};

struct WrittenChannel {
  std::uint16_t id = 0;
  std::size_t kind = 0;  // of McapContent
  std::string record;    // as it stands in chunk and summary
  std::uint64_t num_messages = 0;
  std::vector<McapIndexEntry> index;  // of the open chunk
};

/// Times of the messages of a chunk or of all; 0 where there are none.
struct TimeSpan {
  std::uint64_t start_ns = 0;
  std::uint64_t end_ns = 0;
  bool is_empty = true;

  void include(std::uint64_t time_ns) {
    start_ns = is_empty ? time_ns : std::min(start_ns, time_ns);
    end_ns = is_empty ? time_ns : std::max(end_ns, time_ns);
    is_empty = false;
  }
};

std::uint64_t to_ns(double time_s) {
  const NanoTime time = to_nano_time(time_s);
  return time.sec * 1'000'000'000U + time.nsec;
}

std::string schema_record(std::size_t content) {
  std::string record;
  append_number(record, static_cast<std::uint16_t>(content + 1));
  append_mcap_text(record, kMcapSchemas[content].name);
  append_mcap_text(record, "jsonschema");
  append_mcap_text(record, kMcapSchemas[content].text);
  return record;
}

class McapWriter final : public ScanWriter {
 public:
  McapWriter(std::unique_ptr<ByteSink> sink, const RecordingMetadata& metadata) : sink_(std::move(sink)) {
    std::string start(kMcapMagic);
    std::string header;
    append_mcap_text(header, "");
    append_mcap_text(header, "scanbed");
    append_mcap_record(start, McapOp::kHeader, header);
    const std::uint64_t metadata_at = start.size();
    append_metadata(start, metadata);
    append_metadata_index(metadata_at, start.size() - metadata_at);
    put(start);
  }

  void write(const ScanRecord& record) override {
    const LaserScan& scan = record.scan;
    const std::uint64_t time_ns = to_ns(scan.time_s);
    if (!chunk_.empty() &&
        (chunk_.size() > kMaxMcapChunk || scan.time_s - chunk_start_s_ >= kMaxMcapChunk_s)) {
      write_chunk();
    }
    if (chunk_.empty()) chunk_start_s_ = scan.time_s;
    // The scan comes last: a reader then has all that belongs to it.
    add(McapContent::kBeams, scan, time_ns, encode_mcap_beams(scan));
    if (record.features != nullptr) {
      add(McapContent::kFeatures, scan, time_ns, encode_mcap_features(*record.features, scan.time_s));
    }
    if (record.truth != nullptr) {
      add(McapContent::kTruth, scan, time_ns, encode_mcap_truth(*record.truth, scan.time_s));
    }
    add(McapContent::kScan, scan, time_ns, encode_mcap_scan(scan));
  }

  void finish() override {
    if (!chunk_.empty()) write_chunk();
    std::string bytes;
    std::string data_end;
    append_number(data_end, crc_);
    append_mcap_record(bytes, McapOp::kDataEnd, data_end);
    put(bytes);
    put(summary(position_));
    sink_->finish();
  }

 private:
  void put(std::string_view bytes) {
    sink_->append(bytes);
    position_ += bytes.size();
    crc_ = mcap_crc(crc_, bytes);
  }

  static void append_metadata(std::string& out, const RecordingMetadata& metadata) {
    std::string record;
    append_mcap_text(record, "scanbed");
    append_mcap_map(record, metadata);
    append_mcap_record(out, McapOp::kMetadata, record);
  }

  void append_metadata_index(std::uint64_t offset, std::uint64_t length) {
    std::string record;
    append_number(record, offset);
    append_number(record, length);
    append_mcap_text(record, "scanbed");
    append_mcap_record(metadata_index_, McapOp::kMetadataIndex, record);
  }

  /// The channel, made known to the file where it is new.
  WrittenChannel& channel_of(McapContent content, const LaserScan& scan) {
    const auto kind = static_cast<std::size_t>(content);
    const std::string topic = "/" + (scan.source.empty() ? "scan" : as_utf8(scan.source)) +
                              std::string(kMcapSchemas[kind].topic_ending);
    const auto [found, is_new] = ids_.try_emplace({topic, kind}, channels_.size());
    if (is_new && found->second > kMostChannel) {
      throw InputError("an MCAP file holds no more than 65536 channels, four a source");
    }
    if (is_new) add_channel(topic, kind);
    return channels_[found->second];
  }

  void add_channel(const std::string& topic, std::size_t kind) {
    if (!std::exchange(is_schema_known_[kind], true)) {
      append_mcap_record(schemas_, McapOp::kSchema, schema_record(kind));
    }
    WrittenChannel channel;
    channel.kind = kind;
    channel.id = static_cast<std::uint16_t>(channels_.size());
    std::string record;
    append_number(record, channel.id);
    append_number(record, static_cast<std::uint16_t>(kind + 1));
    append_mcap_text(record, topic);
    append_mcap_text(record, "json");
    append_mcap_map(record, {});
    append_mcap_record(channel.record, McapOp::kChannel, record);
    channels_.push_back(std::move(channel));
  }

  /// In every chunk anew, so that each can be read without the others.
  void define_in_chunk(const WrittenChannel& channel) {
    if (!std::exchange(is_schema_in_chunk_[channel.kind], true)) {
      append_mcap_record(chunk_, McapOp::kSchema, schema_record(channel.kind));
    }
    chunk_.append(channel.record);
  }

  void add(McapContent content, const LaserScan& scan, std::uint64_t time_ns, const std::string& json) {
    WrittenChannel& channel = channel_of(content, scan);
    if (channel.index.empty()) define_in_chunk(channel);
    channel.index.push_back({time_ns, chunk_.size()});
    chunk_span_.include(time_ns);
    span_.include(time_ns);
    std::string message;
    append_number(message, channel.id);
    append_number(message, static_cast<std::uint32_t>(channel.num_messages++));
    append_number(message, time_ns);
    append_number(message, time_ns);
    message.append(json);
    append_mcap_record(chunk_, McapOp::kMessage, message);
  }

  /// Chunk and message indexes go out in one piece, so that a killed program tears as little as can be.
  void write_chunk() {
    std::string chunk;
    const std::string packed = pack_lz4(chunk_);
    append_number(chunk, chunk_span_.start_ns);
    append_number(chunk, chunk_span_.end_ns);
    append_number(chunk, static_cast<std::uint64_t>(chunk_.size()));
    append_number(chunk, mcap_crc(0, chunk_));
    append_mcap_text(chunk, "lz4");
    append_number(chunk, static_cast<std::uint64_t>(packed.size()));
    chunk.append(packed);
    std::string bytes;
    append_mcap_record(bytes, McapOp::kChunk, chunk);
    const std::uint64_t chunk_length = bytes.size();
    std::string offsets;
    for (WrittenChannel& channel : channels_) append_message_index(bytes, offsets, channel);

    std::string index;
    append_number(index, chunk_span_.start_ns);
    append_number(index, chunk_span_.end_ns);
    append_number(index, position_);
    append_number(index, chunk_length);
    append_mcap_text(index, offsets);
    append_number(index, bytes.size() - chunk_length);
    append_mcap_text(index, "lz4");
    append_number(index, static_cast<std::uint64_t>(packed.size()));
    append_number(index, static_cast<std::uint64_t>(chunk_.size()));
    append_mcap_record(chunk_indexes_, McapOp::kChunkIndex, index);
    ++num_chunks_;
    put(bytes);
    chunk_.clear();
    chunk_span_ = {};
    is_schema_in_chunk_ = {};
  }

  /// Appends the index of a channel's messages in the open chunk, and where it will stand to `offsets`.
  void append_message_index(std::string& bytes, std::string& offsets, WrittenChannel& channel) const {
    if (channel.index.empty()) return;
    append_number(offsets, channel.id);
    append_number(offsets, position_ + bytes.size());
    std::string entries;
    for (const McapIndexEntry& entry : channel.index) {
      append_number(entries, entry.time_ns);
      append_number(entries, entry.offset);
    }
    std::string record;
    append_number(record, channel.id);
    append_mcap_text(record, entries);
    append_mcap_record(bytes, McapOp::kMessageIndex, record);
    channel.index.clear();
  }

  std::string statistics() const {
    std::string counts;
    std::uint64_t num_messages = 0;
    for (const WrittenChannel& channel : channels_) {
      append_number(counts, channel.id);
      append_number(counts, channel.num_messages);
      num_messages += channel.num_messages;
    }
    const auto num_schemas = std::count(is_schema_known_.begin(), is_schema_known_.end(), true);
    std::string record;
    append_number(record, num_messages);
    append_number(record, static_cast<std::uint16_t>(num_schemas));
    append_number(record, static_cast<std::uint32_t>(channels_.size()));
    append_number(record, std::uint32_t{0});
    append_number(record, std::uint32_t{1});
    append_number(record, num_chunks_);
    append_number(record, span_.start_ns);
    append_number(record, span_.end_ns);
    append_mcap_text(record, counts);
    std::string out;
    append_mcap_record(out, McapOp::kStatistics, record);
    return out;
  }

  /// All that follows DataEnd, in a file that is `start` bytes long up to there.
  std::string summary(std::uint64_t start) const {
    std::string out;
    std::string offsets;
    const auto add_group = [&](McapOp op, const std::string& group) {
      if (group.empty()) return;
      std::string record;
      append_number(record, static_cast<std::uint8_t>(op));
      append_number(record, start + out.size());
      append_number(record, static_cast<std::uint64_t>(group.size()));
      append_mcap_record(offsets, McapOp::kSummaryOffset, record);
      out.append(group);
    };
    std::string channels;
    for (const WrittenChannel& channel : channels_) channels.append(channel.record);
    add_group(McapOp::kSchema, schemas_);
    add_group(McapOp::kChannel, channels);
    add_group(McapOp::kStatistics, statistics());
    add_group(McapOp::kChunkIndex, chunk_indexes_);
    add_group(McapOp::kMetadataIndex, metadata_index_);
    const std::uint64_t offsets_start = start + out.size();
    out.append(offsets);
    // The footer is put together by hand: its checksum covers its own beginning.
    append_number(out, static_cast<std::uint8_t>(McapOp::kFooter));
    append_number(out, std::uint64_t{20});
    append_number(out, start);
    append_number(out, offsets_start);
    append_number(out, mcap_crc(0, out));
    out.append(kMcapMagic);
    return out;
  }

  std::unique_ptr<ByteSink> sink_;
  std::uint64_t position_ = 0;  // in the file
  std::uint32_t crc_ = 0;       // of all bytes so far
  std::vector<WrittenChannel> channels_;
  std::map<std::pair<std::string, std::size_t>, std::size_t> ids_;  // by topic and kind
  std::array<bool, kMcapSchemas.size()> is_schema_known_ = {};
  std::array<bool, kMcapSchemas.size()> is_schema_in_chunk_ = {};  // that is open

  std::string chunk_;  // open, not packed yet
  double chunk_start_s_ = 0.0;
  TimeSpan chunk_span_;
  TimeSpan span_;

  // Of the summary, as they will stand in it.
  std::string schemas_;
  std::string chunk_indexes_;
  std::string metadata_index_;
  std::uint32_t num_chunks_ = 0;
};

}  // namespace

std::unique_ptr<ScanWriter> write_mcap(std::unique_ptr<ByteSink> sink, const RecordingMetadata& metadata) {
  return std::make_unique<McapWriter>(std::move(sink), metadata);
}

}  // namespace scanbed::hw
