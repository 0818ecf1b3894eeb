// SPDX-License-Identifier: MIT
#include "hw/recording/bag_writer.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/errors/input_error.hpp"
#include "hw/recording/bag_reader.hpp"
#include "hw/recording/bag_record.hpp"
#include "hw/recording/compression.hpp"
#include "hw/recording/little_endian.hpp"
#include "hw/recording/ros_messages.hpp"

namespace scanbed::hw {
namespace {

constexpr std::size_t kMaxBagChunk = std::size_t{768} << 10;  // as rosbag's
constexpr double kMaxBagChunk_s = 1.0;
constexpr std::size_t kHeaderRecord = 4096;  // header and data of the bag's first record, as rosbag writes it

/// Such times do not compare as they are.
std::uint64_t in_order(std::uint64_t ros_time) {
  return (ros_time << 32) | (ros_time >> 32);
}

struct BagIndexEntry {
  std::uint64_t time = 0;
  std::uint32_t offset = 0;
};

struct ChunkInfo {
  std::uint64_t position = 0;
  std::uint64_t start = 0;
  std::uint64_t end = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> counts;  // of messages, by connection
};

struct Topic {
  std::uint32_t id = 0;
  std::string name;
  RosType type;
  std::uint32_t num_messages = 0;
};

/// A scan's topic; "/tf" is taken.
std::string scan_topic(const std::string& source) {
  return source.empty() || source == "tf" ? "/scan" : "/" + source;
}

void append_connection(std::string& out, const Topic& topic) {
  const BagHeader header = BagHeader(BagOp::kConnection).field("conn", topic.id).field("topic", topic.name);
  const BagHeader data = BagHeader()
                             .field("topic", topic.name)
                             .field("type", topic.type.name)
                             .field("md5sum", topic.type.md5)
                             .field("message_definition", topic.type.definition)
                             .field("callerid", std::string_view("/scanbed"));
  append_bag_record(out, header, data.bytes());
}

class BagWriter final : public ScanWriter {
 public:
  explicit BagWriter(std::unique_ptr<FileSink> sink) : sink_(std::move(sink)) {
    if (!sink_->is_regular()) {
      throw InputError(sink_->path().string() +
                       ": a bag can only be written to a file: its header comes last");
    }
    put(kBagMagic);
    put(bag_header(0));
  }

  void write(const ScanRecord& record) override {
    const LaserScan& scan = record.scan;
    if (!chunk_.empty() && (chunk_.size() > kMaxBagChunk || scan.time_s - chunk_start_s_ >= kMaxBagChunk_s)) {
      write_chunk();
    }
    if (chunk_.empty()) chunk_start_s_ = scan.time_s;
    // Encoded first: what cannot be written leaves nothing half done.
    const std::uint64_t time = to_bag_time(scan.time_s);
    Topic& topic = topic_of(scan_topic(scan.source), kLaserScanType);
    const std::string message = encode_laser_scan(scan, topic.num_messages);
    if (scan.X_OR) add(topic_of("/tf", kTransformType), time, encode_odometry(*scan.X_OR, scan.time_s));
    add(topic, time, message);
  }

  void finish() override {
    if (!chunk_.empty()) write_chunk();
    const std::uint64_t index_position = position_;
    std::string index;
    for (const auto& [name, topic] : topics_) append_connection(index, topic);
    for (const ChunkInfo& info : infos_) append_info(index, info);
    put(index);
    sink_->overwrite(kBagMagic.size(), bag_header(index_position));
    sink_->finish();
  }

 private:
  void put(std::string_view bytes) {
    sink_->append(bytes);
    position_ += bytes.size();
  }

  std::string bag_header(std::uint64_t index_position) const {
    const BagHeader header = BagHeader(BagOp::kBagHeader)
                                 .field("index_pos", index_position)
                                 .field("conn_count", static_cast<std::uint32_t>(topics_.size()))
                                 .field("chunk_count", static_cast<std::uint32_t>(infos_.size()));
    std::string bytes;
    append_bag_record(bytes, header, std::string(kHeaderRecord - header.bytes().size(), ' '));
    return bytes;
  }

  /// The topic, made known where it is new to the open chunk, so that each can be read without the others.
  Topic& topic_of(const std::string& name, const RosType& type) {
    const auto [found, is_new] = topics_.try_emplace(name);
    if (is_new) {
      found->second = {.id = static_cast<std::uint32_t>(topics_.size() - 1), .name = name, .type = type};
    }
    if (!index_.contains(found->second.id)) append_connection(chunk_, found->second);
    return found->second;
  }

  void add(Topic& topic, std::uint64_t time, const std::string& message) {
    index_[topic.id].push_back({time, static_cast<std::uint32_t>(chunk_.size())});
    append_bag_record(chunk_, BagHeader(BagOp::kMessage).field("conn", topic.id).field("time", time),
                      message);
    ++topic.num_messages;
  }

  /// Chunk and index records go out in one piece, so that a killed program tears as little as can be.
  void write_chunk() {
    ChunkInfo info = {.position = position_, .start = ~std::uint64_t{0}, .end = 0, .counts = {}};
    std::string bytes;
    append_bag_record(bytes,
                      BagHeader(BagOp::kChunk)
                          .field("compression", std::string_view("lz4"))
                          .field("size", static_cast<std::uint32_t>(chunk_.size())),
                      pack_lz4(chunk_));
    for (auto& [id, entries] : index_) {
      std::stable_sort(entries.begin(), entries.end(), [](const BagIndexEntry& a, const BagIndexEntry& b) {
        return in_order(a.time) < in_order(b.time);
      });
      info.start = std::min(info.start, in_order(entries.front().time));
      info.end = std::max(info.end, in_order(entries.back().time));
      info.counts.emplace_back(id, static_cast<std::uint32_t>(entries.size()));
      append_index(bytes, id, entries);
    }
    if (index_.empty()) info.start = 0;
    infos_.push_back(std::move(info));
    put(bytes);
    chunk_.clear();
    index_.clear();
  }

  static void append_index(std::string& out, std::uint32_t id, const std::vector<BagIndexEntry>& entries) {
    std::string data;
    for (const BagIndexEntry& entry : entries) {
      append_number(data, entry.time);
      append_number(data, entry.offset);
    }
    append_bag_record(out,
                      BagHeader(BagOp::kIndex)
                          .field("ver", std::uint32_t{1})
                          .field("conn", id)
                          .field("count", static_cast<std::uint32_t>(entries.size())),
                      data);
  }

  static void append_info(std::string& out, const ChunkInfo& info) {
    std::string data;
    for (const auto& [id, count] : info.counts) {
      append_number(data, id);
      append_number(data, count);
    }
    append_bag_record(out,
                      BagHeader(BagOp::kChunkInfo)
                          .field("ver", std::uint32_t{1})
                          .field("chunk_pos", info.position)
                          .field("start_time", in_order(info.start))
                          .field("end_time", in_order(info.end))
                          .field("count", static_cast<std::uint32_t>(info.counts.size())),
                      data);
  }

  std::unique_ptr<FileSink> sink_;
  std::uint64_t position_ = 0;  // in the file
  std::map<std::string, Topic> topics_;
  std::vector<ChunkInfo> infos_;
  std::string chunk_;  // open, not packed yet
  double chunk_start_s_ = 0.0;
  std::map<std::uint32_t, std::vector<BagIndexEntry>> index_;  // of the open chunk, by connection
};

}  // namespace

std::unique_ptr<ScanWriter> write_bag(std::unique_ptr<FileSink> sink) {
  return std::make_unique<BagWriter>(std::move(sink));
}

}  // namespace scanbed::hw
