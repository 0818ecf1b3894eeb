// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "hw/recording/little_endian.hpp"

namespace scanbed::hw {

/// What a record of a bag is: its field "op".
enum class BagOp : std::uint8_t {
  kMessage = 2,
  kBagHeader = 3,
  kIndex = 4,
  kChunk = 5,
  kChunkInfo = 6,
  kConnection = 7,
};

/// The value of a field of a record's header; nothing where it is missing or the header is malformed before
/// it. Of fields with the same name the first counts.
std::optional<std::string_view> find_bag_field(std::string_view header, std::string_view name);

/// A number of fixed width. @throws InputError where it is missing or of another width.
std::uint32_t bag_field32(std::string_view header, std::string_view name);
std::uint64_t bag_field64(std::string_view header, std::string_view name);
BagOp bag_op(std::string_view header);

/// A time as records hold it: seconds in the lower half, nanoseconds in the upper one. A nanosecond stands
/// for 0, which ROS takes for "no time". @throws InputError as to_nano_time.
std::uint64_t to_bag_time(double time_s);
double from_bag_time(std::uint64_t time);

/// Makes the header of a record, field by field.
class BagHeader {
 public:
  explicit BagHeader(BagOp op) { field("op", std::string_view(reinterpret_cast<const char*>(&op), 1)); }
  BagHeader() = default;  ///< the block of fields that a connection has for data

  BagHeader& field(std::string_view name, std::string_view value);
  BagHeader& field(std::string_view name, std::uint32_t value);
  BagHeader& field(std::string_view name, std::uint64_t value);

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Appends a record: header and data with their lengths.
void append_bag_record(std::string& out, const BagHeader& header, std::string_view data);

}  // namespace scanbed::hw
