// SPDX-License-Identifier: MIT
#include "hw/recording/bag_reader.hpp"

#include <map>
#include <optional>
#include <utility>

#include "core/errors/input_error.hpp"
#include "hw/recording/bag_record.hpp"
#include "hw/recording/compression.hpp"
#include "hw/recording/little_endian.hpp"
#include "hw/recording/piece_reader.hpp"
#include "hw/recording/ros_messages.hpp"

namespace scanbed::hw {
namespace {

constexpr std::uint32_t kMostHeader = std::uint32_t{1} << 20;
constexpr std::size_t kMostConnections = 65536;

std::string without_slash(std::string_view topic) {
  if (topic.starts_with('/')) topic.remove_prefix(1);
  return std::string(topic);
}

enum class ConnectionContent { kOther, kScan, kTransform };

struct Connection {
  ConnectionContent content = ConnectionContent::kOther;
  std::string source;  // of its scans
};

/// What a bag's first record announces, and what of it was seen.
struct Inventory {
  bool is_indexed = false;
  std::uint32_t num_connections = 0;
  std::uint32_t num_chunks = 0;
  std::uint32_t num_seen_connections = 0;  // in the index, not in chunks
  std::uint32_t num_seen_chunks = 0;       // in the index

  bool is_complete() const {
    return is_indexed && num_seen_connections >= num_connections && num_seen_chunks >= num_chunks;
  }
};

class BagSource final : public ScanSource {
 public:
  BagSource(std::unique_ptr<ByteStream> bytes, std::string name, const BagOptions& options,
            DamageReport report)
      : pieces_(std::move(bytes)),
        name_(std::move(name)),
        only_(without_slash(options.only)),
        report_(std::move(report)) {
    read_start();
  }

  bool read(RecordedScan& out) override { return read_until(out, kNoDeadline_s) == Arrival::kScan; }

  Arrival read_until(RecordedScan& out, double deadline_s) override {
    for (;;) {
      while (cursor_.num_left() > 0) {
        if (try_chunk_record(out)) return Arrival::kScan;
      }
      if (!has_record(deadline_s)) return Arrival::kNothingYet;
      if (!next_record()) break;
      if (take_record(out)) return Arrival::kScan;
    }
    if (inventory_.is_complete()) return Arrival::kEnd;
    throw InputError(name_ + ": is not finished: it ends after " + std::to_string(counts_.num_scans) +
                     " scans without its index (cut off, or its recorder was killed)");
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(name_ + ": record at byte " + std::to_string(record_at_) + ": " + what);
  }

  void damaged(const std::string& what) {
    ++counts_.num_damaged_lines;
    if (report_) report_(name_ + ": record at byte " + std::to_string(record_at_) + " skipped: " + what);
  }

  void read_start() {
    std::string magic;
    if (!pieces_.read(magic, kBagMagic.size()) || magic != kBagMagic) {
      throw InputError(name_ + ": is no ROS bag of version 2.0: it begins otherwise");
    }
    if (!next_record()) throw InputError(name_ + ": is cut off in its first record");
    if (bag_op_here() != BagOp::kBagHeader) fail("is not the bag's header");
    try {
      inventory_.is_indexed = bag_field64(header_, "index_pos") != 0;
      inventory_.num_connections = bag_field32(header_, "conn_count");
      inventory_.num_chunks = bag_field32(header_, "chunk_count");
    } catch (const InputError& error) {
      fail(error.what());
    }
    const auto encryptor = find_bag_field(header_, "encryptor");
    if (encryptor && !encryptor->empty()) fail("the bag is encrypted; expected one that is not");
  }

  BagOp bag_op_here() const {
    try {
      return bag_op(header_);
    } catch (const InputError& error) {
      fail(error.what());
    }
  }

  /// A length in front of its bytes; false where the file ends in it or in them.
  bool read_piece(std::string& piece, std::uint64_t most) {
    std::string length_bytes;
    if (!pieces_.read(length_bytes, 4)) return false;
    const auto length = ByteCursor(length_bytes).number<std::uint32_t>();
    if (length > most) {
      fail("claims " + std::to_string(length) + " bytes, more than " + std::to_string(most));
    }
    return pieces_.read(piece, length);
  }

  /// Whether next_record() would not wait, or does not before `deadline_s`.
  bool has_record(double deadline_s) {
    if (is_over_) return true;
    std::uint64_t num_bytes = 0;
    for (const std::uint64_t most : {std::uint64_t{kMostHeader}, std::uint64_t{kMostUnpacked}}) {
      if (!pieces_.has(num_bytes + 4, deadline_s)) return false;
      ByteCursor cursor(pieces_.ahead());
      cursor.take(num_bytes);
      const auto length = cursor.number<std::uint32_t>();
      if (!cursor.ok() || length > most) return true;  // torn, or refused
      num_bytes += 4 + length;
    }
    return pieces_.has(num_bytes, deadline_s);
  }

  /// Reads the next record of the file; false at the end. What there is of a torn one stays in data_.
  bool next_record() {
    if (is_over_) return false;
    record_at_ = pieces_.offset();
    data_.clear();
    if (!read_piece(header_, kMostHeader)) {
      is_over_ = true;
      return false;
    }
    is_over_ = !read_piece(data_, kMostUnpacked);
    if (!is_over_) return true;
    // The whole messages of a torn chunk are as good as others, if it is not packed.
    const auto packing = find_bag_field(header_, "compression");
    return packing && *packing == "none";
  }

  /// Whether it was a scan.
  bool take_record(RecordedScan& out) {
    switch (bag_op_here()) {
      case BagOp::kChunk:
        open_chunk();
        return false;
      case BagOp::kConnection:
        ++inventory_.num_seen_connections;
        index_connection();
        return false;
      case BagOp::kChunkInfo:
        ++inventory_.num_seen_chunks;
        return false;
      case BagOp::kIndex:
        return false;
      case BagOp::kMessage:
        if (is_in_unfinished_chunk_) return take_loose_message(out);
        break;
      default:
        break;
    }
    fail("is of an unknown kind");
  }

  bool take_loose_message(RecordedScan& out) {
    try {
      return take_chunk_record(header_, data_, out);
    } catch (const InputError& error) {
      damaged(error.what());
      return false;
    }
  }

  /// Bags that hold connections only in their index are not ours, but may be read in part.
  void index_connection() {
    try {
      add_connection(header_, data_);
    } catch (const InputError& error) {
      damaged(error.what());
    }
  }

  void open_chunk() {
    try {
      const std::string_view name = find_bag_field(header_, "compression").value_or("?");
      const std::optional<Packing> packing = packing_of_name(name);
      if (!packing || *packing == Packing::kZstd) throw InputError("packed in an unknown way");
      if (data_.empty() && !inventory_.is_indexed) return enter_unfinished_chunk(*packing);
      // Of what is not packed the length is known anyway; old writers announced another one.
      chunk_ = *packing == Packing::kNone ? std::move(data_)
                                          : unpack_chunk(data_, *packing, bag_field32(header_, "size"));
      cursor_ = ByteCursor(chunk_);
    } catch (const InputError& error) {
      damaged(error.what());
    }
  }

  /// A recorder that was killed leaves its last chunk without a length, and what the chunk holds behind it.
  void enter_unfinished_chunk(Packing packing) {
    is_in_unfinished_chunk_ = packing == Packing::kNone;
    is_over_ = packing != Packing::kNone;  // what is packed is no records
  }

  /// Takes one record of the chunk; whether it was a scan.
  bool try_chunk_record(RecordedScan& out) {
    const std::string_view header = cursor_.piece();
    const std::string_view data = cursor_.piece();
    try {
      if (!cursor_.ok()) {
        cursor_ = ByteCursor(std::string_view());
        if (is_over_) return false;  // torn; the end is told as such
        throw InputError("a record in the chunk is longer than what is left of it");
      }
      return take_chunk_record(header, data, out);
    } catch (const InputError& error) {
      damaged(error.what());
      return false;
    }
  }

  bool take_chunk_record(std::string_view header, std::string_view data, RecordedScan& out) {
    switch (bag_op(header)) {
      case BagOp::kConnection:
        add_connection(header, data);
        return false;
      case BagOp::kMessage:
        return take_message(header, data, out);
      default:
        throw InputError("a record in the chunk is of an unknown kind");
    }
  }

  void add_connection(std::string_view header, std::string_view data) {
    const std::uint32_t id = bag_field32(header, "conn");
    if (connections_.size() >= kMostConnections) throw InputError("more connections than 65536");
    Connection connection;
    connection.source = without_slash(find_bag_field(header, "topic").value_or(""));
    const auto type = find_bag_field(data, "type");
    const auto md5 = find_bag_field(data, "md5sum");
    const bool is_wanted = only_.empty() || connection.source == only_;
    const auto is = [&](const RosType& known) { return type == known.name && md5 == known.md5; };
    if (is(kLaserScanType) && is_wanted) connection.content = ConnectionContent::kScan;
    if (is(kLaserScanType) && !is_wanted) left_out_.add(connection.source);
    const bool is_old_transform = type == kOldTransformName && md5 == kTransformType.md5;
    if (is(kTransformType) || is_old_transform) connection.content = ConnectionContent::kTransform;
    if (connection.content == ConnectionContent::kOther && is_wanted && type &&
        type->ends_with("LaserScan")) {
      left_out_.add_unread(std::string(*type) + (*type == kLaserScanType.name ? " with another sum" : ""));
    }
    if (connection.source == "scan") connection.source.clear();
    connections_.insert_or_assign(id, std::move(connection));
  }

  bool take_message(std::string_view header, std::string_view data, RecordedScan& out) {
    const auto found = connections_.find(bag_field32(header, "conn"));
    if (found == connections_.end()) throw InputError("a message of an unknown connection");
    switch (found->second.content) {
      case ConnectionContent::kScan:
        decode_laser_scan(data, out.scan);
        // Where the driver had no time, when it was recorded.
        if (out.scan.time_s == 0.0) out.scan.time_s = from_bag_time(bag_field64(header, "time"));
        out.scan.source = found->second.source;
        out.scan.X_OR = X_OR_;
        out.features.reset();
        out.truth.reset();
        ++counts_.num_scans;
        return true;
      case ConnectionContent::kTransform:
        if (const auto X_OR = decode_odometry(data)) X_OR_ = X_OR;
        break;
      case ConnectionContent::kOther:
        break;
    }
    ++counts_.num_other_lines;
    return false;
  }

  PieceReader pieces_;
  std::string name_;
  std::string only_;
  DamageReport report_;
  Inventory inventory_;
  std::map<std::uint32_t, Connection> connections_;
  std::optional<Pose2> X_OR_;  // the last one that came by

  std::uint64_t record_at_ = 0;  // where the record of the file begins, for messages
  std::string header_;           // of the record of the file
  std::string data_;
  bool is_over_ = false;                                // the file has ended, after or within that record
  bool is_in_unfinished_chunk_ = false;                 // whose records stand in the file itself
  std::string chunk_;                                   // unpacked
  ByteCursor cursor_ = ByteCursor(std::string_view());  // on what is left of it
};

}  // namespace

std::unique_ptr<ScanSource> read_bag(std::unique_ptr<ByteStream> bytes, std::string name,
                                     const BagOptions& options, DamageReport report) {
  return std::make_unique<BagSource>(std::move(bytes), std::move(name), options, std::move(report));
}

}  // namespace scanbed::hw
