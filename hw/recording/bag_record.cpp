// SPDX-License-Identifier: MIT
#include "hw/recording/bag_record.hpp"

#include "core/errors/input_error.hpp"
#include "hw/recording/nano_time.hpp"

namespace scanbed::hw {
namespace {

constexpr std::uint64_t kTimeZero = std::uint64_t{1} << 32U;

template <class Number>
Number number_field(std::string_view header, std::string_view name) {
  const std::optional<std::string_view> value = find_bag_field(header, name);
  if (value && value->size() == sizeof(Number)) return ByteCursor(*value).number<Number>();
  throw InputError("a record's field '" + std::string(name) + "' is " +
                   (value ? "of the wrong length" : "missing"));
}

}  // namespace

std::optional<std::string_view> find_bag_field(std::string_view header, std::string_view name) {
  ByteCursor cursor(header);
  while (cursor.num_left() > 0) {
    const std::string_view field = cursor.piece();
    const std::size_t equals = field.find('=');
    if (!cursor.ok() || equals == std::string_view::npos) return std::nullopt;
    if (field.substr(0, equals) == name) return field.substr(equals + 1);
  }
  return std::nullopt;
}

std::uint32_t bag_field32(std::string_view header, std::string_view name) {
  return number_field<std::uint32_t>(header, name);
}

std::uint64_t bag_field64(std::string_view header, std::string_view name) {
  return number_field<std::uint64_t>(header, name);
}

BagOp bag_op(std::string_view header) {
  return static_cast<BagOp>(number_field<std::uint8_t>(header, "op"));
}

std::uint64_t to_bag_time(double time_s) {
  const NanoTime time = to_nano_time(time_s);
  const std::uint64_t both = static_cast<std::uint64_t>(time.nsec) << 32U | time.sec;
  return both == 0 ? kTimeZero : both;
}

double from_bag_time(std::uint64_t time) {
  if (time == kTimeZero) return 0.0;
  return to_seconds({.sec = time & 0xFFFFFFFFU, .nsec = static_cast<std::uint32_t>(time >> 32U)});
}

BagHeader& BagHeader::field(std::string_view name, std::string_view value) {
  append_number(bytes_, static_cast<std::uint32_t>(name.size() + 1 + value.size()));
  bytes_.append(name).append("=").append(value);
  return *this;
}

BagHeader& BagHeader::field(std::string_view name, std::uint32_t value) {
  std::string bytes;
  append_number(bytes, value);
  return field(name, std::string_view(bytes));
}

BagHeader& BagHeader::field(std::string_view name, std::uint64_t value) {
  std::string bytes;
  append_number(bytes, value);
  return field(name, std::string_view(bytes));
}

void append_bag_record(std::string& out, const BagHeader& header, std::string_view data) {
  append_number(out, static_cast<std::uint32_t>(header.bytes().size()));
  out.append(header.bytes());
  append_number(out, static_cast<std::uint32_t>(data.size()));
  out.append(data);
}

}  // namespace scanbed::hw
