// SPDX-License-Identifier: MIT
#include "hw/recording/mcap_reader.hpp"

#include <map>
#include <utility>

#include "core/errors/input_error.hpp"
#include "hw/recording/compression.hpp"
#include "hw/recording/mcap_message.hpp"
#include "hw/recording/mcap_schemas.hpp"
#include "hw/recording/piece_reader.hpp"

namespace scanbed::hw {
namespace {

constexpr std::uint64_t kMostRecord = kMostUnpacked + 4096;
constexpr std::size_t kMostMessage = std::size_t{4} << 20;  // JSON takes up to 40 times its length in memory

enum class ChannelContent { kOther, kScan, kBeams, kFeatures, kTruth };

struct Schema {
  std::string name;
  ChannelContent content = ChannelContent::kOther;
};

struct Channel {
  ChannelContent content = ChannelContent::kOther;
  std::string scan_topic;  // of the scan that it is about, without the leading slash
};

struct MessageView {
  std::uint16_t channel = 0;
  std::uint64_t log_time = 0;
  std::string_view data;
};

ChannelContent content_of(std::string_view schema) {
  for (std::size_t i = 0; i < kMcapSchemas.size(); ++i) {
    if (kMcapSchemas[i].name == schema) return static_cast<ChannelContent>(i + 1);
  }
  return ChannelContent::kOther;
}

std::string scan_topic_of(std::string_view topic, ChannelContent content) {
  if (topic.starts_with('/')) topic.remove_prefix(1);
  if (content != ChannelContent::kOther) {
    const std::string_view ending = kMcapSchemas[static_cast<std::size_t>(content) - 1].topic_ending;
    if (topic.ends_with(ending)) topic.remove_suffix(ending.size());
  }
  return std::string(topic);
}

class McapSource final : public ScanSource {
 public:
  McapSource(std::unique_ptr<ByteStream> bytes, std::string name, std::string only, DamageReport report)
      : pieces_(std::move(bytes)),
        name_(std::move(name)),
        only_(std::move(only)),
        report_(std::move(report)) {
    if (only_.starts_with('/')) only_.erase(0, 1);
    std::string magic;
    if (!pieces_.read(magic, kMcapMagic.size()) || magic != kMcapMagic) {
      throw InputError(name_ + ": is no MCAP file of version 0: it begins otherwise");
    }
    crc_ = mcap_crc(0, magic);
  }

  bool read(RecordedScan& out) override { return read_until(out, kNoDeadline_s) == Arrival::kScan; }

  Arrival read_until(RecordedScan& out, double deadline_s) override {
    for (;;) {
      while (chunk_records_.num_left() > 0) {
        if (try_chunk_record(out)) return Arrival::kScan;
      }
      if (!has_record(deadline_s)) return Arrival::kNothingYet;
      if (!next_record()) break;
      if (take_record(out)) return Arrival::kScan;
    }
    if (has_footer_) skip_rest();
    need_clean_end(pieces_.end(), name_, counts_.num_scans);
    if (!has_footer_) {
      throw InputError(name_ + ": is not finished: it ends after " + std::to_string(counts_.num_scans) +
                       " scans without its index (cut off, or its recorder was killed)");
    }
    if (is_crc_wrong_) throw InputError(name_ + ": is damaged: the checksum over all its data does not fit");
    return Arrival::kEnd;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(name_ + ": record at byte " + std::to_string(record_at_) + ": " + what);
  }

  void damaged(const std::string& what) {
    ++counts_.num_damaged_lines;
    if (report_) report_(name_ + ": record at byte " + std::to_string(record_at_) + " skipped: " + what);
  }

  /// Whether next_record() would not wait, or does not before `deadline_s`.
  bool has_record(double deadline_s) {
    if (has_footer_) return true;
    if (!pieces_.has(kMcapPrefix, deadline_s)) return false;
    ByteCursor cursor(pieces_.ahead());
    cursor.number<std::uint8_t>();
    const auto length = cursor.number<std::uint64_t>();
    const bool is_refused = !cursor.ok() || length > kMostRecord;
    return is_refused || pieces_.has(kMcapPrefix + length, deadline_s);
  }

  /// Reads the next record of the file into op_ and content_; false at the end or in a torn record.
  bool next_record() {
    if (has_footer_) return false;
    record_at_ = pieces_.offset();
    if (!pieces_.read(prefix_, kMcapPrefix)) return false;
    ByteCursor cursor(prefix_);
    op_ = static_cast<McapOp>(cursor.number<std::uint8_t>());
    const auto length = cursor.number<std::uint64_t>();
    if (op_ == McapOp{0}) fail("is of kind 0, which there is not");
    if (length > kMostRecord) {
      fail("claims " + std::to_string(length) + " bytes, more than " + std::to_string(kMostRecord));
    }
    if (!pieces_.read(content_, length)) return false;
    if (op_ == McapOp::kDataEnd) check_crc();
    crc_ = mcap_crc(mcap_crc(crc_, prefix_), content_);
    return true;
  }

  /// Of the first DataEnd; a second one in the same file has no meaning.
  void check_crc() {
    const auto expected = ByteCursor(content_).number<std::uint32_t>();
    is_crc_wrong_ = expected != 0 && expected != crc_;
  }

  /// Takes a record of the file; whether it was a scan outside of a chunk.
  bool take_record(RecordedScan& out) {
    try {
      switch (op_) {
        case McapOp::kChunk:
          open_chunk();
          return false;
        case McapOp::kMetadata:
          take_metadata();
          return false;
        case McapOp::kFooter:
          check_end();
          return false;
        default:
          return take_data_record(op_, content_, out);
      }
    } catch (const InputError& error) {
      damaged(error.what());
      return false;
    }
  }

  void check_end() {
    std::string magic;
    has_footer_ = pieces_.read(magic, kMcapMagic.size()) && magic == kMcapMagic;
  }

  /// Reads on behind the end: compressed data tells of damage only at its own end.
  void skip_rest() {
    constexpr std::uint64_t kBlock = std::uint64_t{1} << 18;
    record_at_ = pieces_.offset();
    std::string rest;
    if (pieces_.read(rest, 1)) damaged("stands behind the end of the recording, as all that follows does");
    while (pieces_.read(rest, kBlock)) continue;
  }

  void take_metadata() {
    ByteCursor cursor(content_);
    const std::string_view record_name = cursor.piece();
    RecordingMetadata map = read_mcap_map(cursor);
    if (!cursor.ok()) throw InputError("malformed metadata");
    if (record_name == "scanbed") metadata_ = std::move(map);
  }

  void open_chunk() {
    ByteCursor cursor(content_);
    cursor.take(16);  // start and end
    const auto num_bytes = cursor.number<std::uint64_t>();
    const auto crc = cursor.number<std::uint32_t>();
    const std::string packing_name(cursor.piece());
    const std::string_view packed = cursor.take(cursor.number<std::uint64_t>());
    const std::optional<Packing> packing = packing_of_name(packing_name);
    if (!cursor.ok()) throw InputError("a chunk's lengths do not fit");
    if (!packing || packing == Packing::kBzip2) throw InputError("a chunk is packed in an unknown way");
    chunk_ = unpack_chunk(packed, *packing, num_bytes);
    if (crc != 0 && mcap_crc(0, chunk_) != crc) throw InputError("a chunk's checksum does not fit");
    chunk_records_ = ByteCursor(chunk_);
  }

  bool try_chunk_record(RecordedScan& out) {
    const auto op = static_cast<McapOp>(chunk_records_.number<std::uint8_t>());
    const std::string_view content = chunk_records_.take(chunk_records_.number<std::uint64_t>());
    try {
      if (!chunk_records_.ok()) {
        chunk_records_ = ByteCursor(std::string_view());
        throw InputError("a record in the chunk is longer than what is left of it");
      }
      return take_data_record(op, content, out);
    } catch (const InputError& error) {
      damaged(error.what());
      return false;
    }
  }

  /// Takes a record that may stand inside or outside of chunks; whether it was a scan.
  bool take_data_record(McapOp op, std::string_view content, RecordedScan& out) {
    switch (op) {
      case McapOp::kSchema:
        add_schema(content);
        return false;
      case McapOp::kChannel:
        add_channel(content);
        return false;
      case McapOp::kMessage:
        return take_message(content, out);
      default:
        return false;
    }
  }

  void add_schema(std::string_view content) {
    ByteCursor cursor(content);
    const auto id = cursor.number<std::uint16_t>();
    const std::string_view schema = cursor.piece();
    if (!cursor.ok()) throw InputError("malformed schema");
    schemas_.insert_or_assign(id, Schema{std::string(schema), content_of(schema)});
  }

  void add_channel(std::string_view content) {
    ByteCursor cursor(content);
    const auto id = cursor.number<std::uint16_t>();
    const auto found = schemas_.find(cursor.number<std::uint16_t>());
    const Schema schema = found == schemas_.end() ? Schema() : found->second;
    const std::string_view topic = cursor.piece();
    const std::string_view encoding = cursor.piece();
    if (!cursor.ok()) throw InputError("malformed channel");
    Channel channel;
    if (encoding == "json") channel.content = schema.content;
    if (channel.content == ChannelContent::kOther && schema.name.ends_with("LaserScan")) {
      left_out_.add_unread(schema.name + " in " + std::string(encoding) +
                           " (read: foxglove.LaserScan in json)");
    }
    channel.scan_topic = scan_topic_of(topic, channel.content);
    if (!only_.empty() && channel.scan_topic != only_) {
      if (channel.content == ChannelContent::kScan) left_out_.add(channel.scan_topic);
      channel.content = ChannelContent::kOther;
    }
    channels_.insert_or_assign(id, std::move(channel));
  }

  bool take_message(std::string_view content, RecordedScan& out) {
    ByteCursor cursor(content);
    MessageView message;
    message.channel = cursor.number<std::uint16_t>();
    cursor.number<std::uint32_t>();  // sequence
    message.log_time = cursor.number<std::uint64_t>();
    cursor.number<std::uint64_t>();  // publish time
    message.data = cursor.take(cursor.num_left());
    const auto channel = channels_.find(message.channel);
    if (!cursor.ok()) throw InputError("malformed message");
    if (channel == channels_.end()) throw InputError("a message of an unknown channel");
    if (channel->second.content == ChannelContent::kOther) {
      ++counts_.num_other_lines;
      return false;
    }
    if (message.data.size() > kMostMessage) throw InputError("a message is longer than 4 MiB");
    return take_known_message(channel->second, message, out);
  }

  bool take_known_message(const Channel& channel, const MessageView& message, RecordedScan& out) {
    if (message.log_time != side_time_ || channel.scan_topic != side_topic_) {
      side_ = {};
      side_time_ = message.log_time;
      side_topic_ = channel.scan_topic;
    }
    switch (channel.content) {
      case ChannelContent::kBeams:
        side_.beams = message.data;
        return false;
      case ChannelContent::kFeatures:
        side_.features = message.data;
        return false;
      case ChannelContent::kTruth:
        side_.truth = message.data;
        return false;
      default:
        break;
    }
    const McapSideMessages side = std::exchange(side_, {});
    decode_mcap_scan(message.data, side, out);
    if (side.beams.empty() && channel.scan_topic != "scan") out.scan.source = channel.scan_topic;
    ++counts_.num_scans;
    return true;
  }

  PieceReader pieces_;
  std::string name_;
  std::string only_;
  DamageReport report_;
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, Channel> channels_;

  std::uint64_t record_at_ = 0;  // where the record of the file begins, for messages
  std::string prefix_;
  McapOp op_ = McapOp{0};
  std::string content_;
  std::string chunk_;  // unpacked
  ByteCursor chunk_records_ = ByteCursor(std::string_view());

  McapSideMessages side_;  // of the scan to come, ...
  std::uint64_t side_time_ = 0;
  std::string side_topic_;  // ... which has this time and topic

  std::uint32_t crc_ = 0;  // of all bytes so far
  bool is_crc_wrong_ = false;
  bool has_footer_ = false;
};

}  // namespace

std::unique_ptr<ScanSource> read_mcap(std::unique_ptr<ByteStream> bytes, std::string name,
                                      const McapOptions& options, DamageReport report) {
  return std::make_unique<McapSource>(std::move(bytes), std::move(name), options.only, std::move(report));
}

}  // namespace scanbed::hw
