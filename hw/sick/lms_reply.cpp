// SPDX-License-Identifier: MIT
#include "hw/sick/lms_reply.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "hw/sick/telegram.hpp"

namespace scanbed::hw {
namespace {

constexpr std::size_t kStatusBytes = 0x9A;  // of B1h, with command and status byte
constexpr std::size_t kTypeChars = 21;
constexpr std::size_t kFirmwareChars = 7;

// Offsets in B1h, the command byte being 0.
constexpr std::size_t kFirmwareAt = 1;
constexpr std::size_t kModeAt = 8;
constexpr std::size_t kDefectAt = 9;
constexpr std::size_t kSensorVariantAt = 18;
constexpr std::size_t kMotorAt = 67;
constexpr std::size_t kMeasuringModeAt = 102;
constexpr std::size_t kFovAt = 107;
constexpr std::size_t kResolutionAt = 109;
constexpr std::size_t kBaudAt = 116;
constexpr std::size_t kPermanentBaudAt = 119;
constexpr std::size_t kAddressAt = 120;
constexpr std::size_t kUnitAt = 122;
constexpr std::size_t kPromAt = 124;

constexpr std::array<std::pair<unsigned, int>, 4> kBauds = {
    {{0x8067, 9600}, {0x8033, 19200}, {0x8019, 38400}, {0x8001, 500000}}};

void put_word(Bytes& bytes, std::size_t at, int word) {
  bytes[at] = static_cast<std::uint8_t>(word & 0xFF);
  bytes[at + 1] = static_cast<std::uint8_t>((word >> 8) & 0xFF);
}

void put_text(Bytes& bytes, std::size_t at, std::string text) {
  text.resize(kFirmwareChars, ' ');
  std::copy(text.begin(), text.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
}

void append(Bytes& bytes, ByteView more) {
  bytes.insert(bytes.end(), more.begin(), more.end());
}

Bytes encode_status(const StatusReply& reply) {
  Bytes body(kStatusBytes - 1, 0);
  body[0] = 0xB1;
  put_text(body, kFirmwareAt, reply.firmware);
  body[kModeAt] = static_cast<std::uint8_t>(reply.mode);
  body[kDefectAt] = reply.is_defect ? 1 : 0;
  body[kSensorVariantAt] = reply.sensor_variant;
  put_word(body, kMotorAt, reply.motor);
  body[kMeasuringModeAt] = reply.measuring_mode;
  put_word(body, kFovAt, reply.variant.fov_deg);
  put_word(body, kResolutionAt, reply.variant.resolution_cdeg);
  put_word(body, kBaudAt, static_cast<int>(baud_code(reply.baud)));
  body[kPermanentBaudAt] = reply.has_permanent_baud ? 1 : 0;
  body[kAddressAt] = reply.address;
  body[kUnitAt] = reply.unit == RangeUnit::kMillimetre ? 1 : 0;
  put_text(body, kPromAt, reply.firmware);
  return body;
}

struct ReplyEncoder {
  Bytes operator()(const ResetReply&) const { return {0x91}; }

  Bytes operator()(const TypeReply& reply) const {
    Bytes body{static_cast<std::uint8_t>(reply.is_power_on ? 0x90 : 0xBA)};
    std::string text = reply.text;
    text.resize(kTypeChars, ' ');
    body.insert(body.end(), text.begin(), text.end());
    return body;
  }

  Bytes operator()(const RefusedReply&) const { return {0x92}; }
  Bytes operator()(const ModeReply& reply) const { return {0xA0, reply.result}; }
  Bytes operator()(const StatusReply& reply) const { return encode_status(reply); }

  Bytes operator()(const ErrorsReply& reply) const {
    Bytes body{0xB2};
    for (const ErrorsReply::Entry& entry : reply.entries) {
      body.push_back(entry.type);
      body.push_back(entry.number);
    }
    return body;
  }

  Bytes operator()(const VariantReply& reply) const {
    Bytes body{0xBB, static_cast<std::uint8_t>(reply.is_done ? 1 : 0)};
    append_word(body, static_cast<unsigned>(reply.variant.fov_deg));
    append_word(body, static_cast<unsigned>(reply.variant.resolution_cdeg));
    return body;
  }

  Bytes operator()(const PermanentBaudReply&) const { return {0xE6}; }

  Bytes operator()(const ConfigurationReply& reply) const {
    Bytes body{0xF4};
    append(body, reply.configuration.bytes());
    return body;
  }

  Bytes operator()(const WrittenReply& reply) const {
    Bytes body{0xF7, static_cast<std::uint8_t>(reply.is_done ? 1 : 0)};
    append(body, reply.configuration.bytes());
    return body;
  }
};

std::string text_of(ByteView bytes) {
  return {bytes.begin(), bytes.end()};
}

std::optional<LmsReply> parse_status(ByteView body) {
  if (body.size() + 1 < kPromAt) return std::nullopt;
  StatusReply reply;
  reply.firmware = text_of(body.subspan(kFirmwareAt, kFirmwareChars));
  reply.mode = static_cast<LmsMode>(body[kModeAt]);
  reply.is_defect = body[kDefectAt] != 0;
  reply.sensor_variant = body[kSensorVariantAt];
  reply.motor = static_cast<int>(read_word(body, kMotorAt));
  reply.measuring_mode = body[kMeasuringModeAt];
  reply.variant.fov_deg = static_cast<int>(read_word(body, kFovAt));
  reply.variant.resolution_cdeg = static_cast<int>(read_word(body, kResolutionAt));
  reply.baud = baud_of_code(read_word(body, kBaudAt));
  reply.has_permanent_baud = body[kPermanentBaudAt] != 0;
  reply.address = body[kAddressAt];
  reply.unit = body[kUnitAt] == 0 ? RangeUnit::kCentimetre : RangeUnit::kMillimetre;
  return reply;
}

std::optional<LmsReply> parse_errors(ByteView data) {
  if (data.size() % 2 != 0) return std::nullopt;
  ErrorsReply reply;
  for (std::size_t i = 0; i < data.size(); i += 2) reply.entries.push_back({data[i], data[i + 1]});
  return reply;
}

std::optional<LmsReply> parse_variant(ByteView data) {
  if (data.size() != 5) return std::nullopt;
  return VariantReply{data[0] == 1,
                      {static_cast<int>(read_word(data, 1)), static_cast<int>(read_word(data, 3))}};
}

std::optional<LmsReply> parse_written(ByteView data) {
  if (data.empty()) return std::nullopt;
  const auto configuration = LmsConfiguration::from_bytes(data.subspan(1));
  if (!configuration) return std::nullopt;
  return WrittenReply{data[0] == 1, *configuration};
}

std::optional<LmsReply> parse_configuration(ByteView data) {
  const auto configuration = LmsConfiguration::from_bytes(data);
  if (!configuration) return std::nullopt;
  return ConfigurationReply{*configuration};
}

/// @param body  command and data, without the status byte.
std::optional<LmsReply> parse_content(ByteView body) {
  const ByteView data = body.subspan(1);
  switch (body[0]) {
    case 0x90:
    case 0xBA:
      return TypeReply{text_of(data), body[0] == 0x90};
    case 0x91:
      return ResetReply{};
    case 0x92:
      return RefusedReply{};
    case 0xA0:
      if (data.size() != 1) return std::nullopt;
      return ModeReply{data[0]};
    case 0xB1:
      return parse_status(body);
    case 0xB2:
      return parse_errors(data);
    case 0xBB:
      return parse_variant(data);
    case 0xE6:
      return PermanentBaudReply{};
    case 0xF4:
      return parse_configuration(data);
    case 0xF7:
      return parse_written(data);
    default:
      return std::nullopt;
  }
}

}  // namespace

unsigned baud_code(int baud) {
  for (const auto& [code, value] : kBauds) {
    if (value == baud) return code;
  }
  return 0;
}

int baud_of_code(unsigned code) {
  for (const auto& [known, value] : kBauds) {
    if (known == code) return value;
  }
  return 0;
}

Bytes encode(const LmsReply& reply, LmsStatusByte status) {
  Bytes body = std::visit(ReplyEncoder{}, reply);
  body.push_back(status.bits);
  return body;
}

std::optional<StatedReply> parse_reply(ByteView body) {
  if (body.size() < 2) return std::nullopt;
  std::optional<LmsReply> reply = parse_content(body.first(body.size() - 1));
  if (!reply) return std::nullopt;
  return StatedReply{std::move(*reply), LmsStatusByte{body.back()}};
}

}  // namespace scanbed::hw
