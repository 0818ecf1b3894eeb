// SPDX-License-Identifier: MIT
#include "hw/sick/lms_command.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/errors/ensure.hpp"
#include "hw/sick/telegram.hpp"

namespace scanbed::hw {
namespace {

constexpr std::array<std::uint8_t, 8> kPassword = {'S', 'I', 'C', 'K', '_', 'L', 'M', 'S'};

constexpr std::array<std::pair<std::uint8_t, int>, 4> kBaudCodes = {
    {{0x42, 9600}, {0x41, 19200}, {0x40, 38400}, {0x48, 500000}}};

struct CommandEncoder {
  Bytes operator()(const ResetCommand&) const { return {0x10}; }

  Bytes operator()(const SetModeCommand& command) const {
    Bytes body{0x20, static_cast<std::uint8_t>(command.mode)};
    if (command.has_password) body.insert(body.end(), kPassword.begin(), kPassword.end());
    return body;
  }

  Bytes operator()(const SetBaudCommand& command) const {
    const auto* entry = std::find_if(kBaudCodes.begin(), kBaudCodes.end(),
                                     [&](const auto& code) { return code.second == command.baud; });
    SCANBED_ENSURE(entry != kBaudCodes.end());
    return {0x20, entry->first};
  }

  Bytes operator()(const StreamSubrangeCommand& command) const {
    Bytes body{0x20, 0x27};
    append_word(body, static_cast<unsigned>(command.first));
    append_word(body, static_cast<unsigned>(command.last));
    return body;
  }

  Bytes operator()(const RequestScanCommand& command) const {
    return {0x30, static_cast<std::uint8_t>(command.what)};
  }

  Bytes operator()(const RequestCommand& command) const { return {static_cast<std::uint8_t>(command.what)}; }

  Bytes operator()(const SetVariantCommand& command) const {
    Bytes body{0x3B};
    append_word(body, static_cast<unsigned>(command.variant.fov_deg));
    append_word(body, static_cast<unsigned>(command.variant.resolution_cdeg));
    return body;
  }

  Bytes operator()(const SetPermanentBaudCommand& command) const {
    return {0x66, static_cast<std::uint8_t>(command.is_permanent ? 1 : 0)};
  }

  Bytes operator()(const WriteConfigurationCommand& command) const {
    Bytes body{0x77};
    const ByteView bytes = command.configuration.bytes();
    body.insert(body.end(), bytes.begin(), bytes.end());
    return body;
  }
};

std::optional<LmsCommand> parse_mode(ByteView data) {
  const bool has_password = std::equal(data.begin() + 1, data.end(), kPassword.begin(), kPassword.end());
  switch (data[0]) {
    case 0x00:
    case 0x30:
      return SetModeCommand{static_cast<LmsMode>(data[0]), has_password};
    case 0x27:
      if (data.size() != 5) return std::nullopt;
      return StreamSubrangeCommand{static_cast<int>(read_word(data, 1)),
                                   static_cast<int>(read_word(data, 3))};
    default:
      break;
  }
  if (data.size() != 1) return std::nullopt;
  if (data[0] == 0x10 || data[0] == 0x24 || data[0] == 0x25 || data[0] == 0x2A) {
    return SetModeCommand{static_cast<LmsMode>(data[0]), false};
  }
  for (const auto& [code, baud] : kBaudCodes) {
    if (code == data[0]) return SetBaudCommand{baud};
  }
  return std::nullopt;
}

std::optional<LmsCommand> parse_with_data(std::uint8_t code, ByteView data) {
  if (code == 0x20 && !data.empty()) return parse_mode(data);
  if (code == 0x30 && data.size() == 1 && (data[0] == 0x01 || data[0] == 0x08)) {
    return RequestScanCommand{static_cast<RequestScanCommand::What>(data[0])};
  }
  if (code == 0x3B && data.size() == 4) {
    return SetVariantCommand{{static_cast<int>(read_word(data, 0)), static_cast<int>(read_word(data, 2))}};
  }
  if (code == 0x66 && data.size() == 1 && data[0] <= 1) return SetPermanentBaudCommand{data[0] == 1};
  if (code == 0x77) {
    if (const auto configuration = LmsConfiguration::from_bytes(data)) {
      return WriteConfigurationCommand{*configuration};
    }
  }
  return std::nullopt;
}

}  // namespace

Bytes encode(const LmsCommand& command) {
  return std::visit(CommandEncoder{}, command);
}

std::optional<LmsCommand> parse_command(ByteView body) {
  if (body.empty()) return std::nullopt;
  if (body.size() > 1) return parse_with_data(body[0], body.subspan(1));
  switch (body[0]) {
    case 0x10:
      return ResetCommand{};
    case 0x31:
    case 0x32:
    case 0x3A:
    case 0x74:
    case 0x7B:
      return RequestCommand{static_cast<RequestCommand::What>(body[0])};
    default:
      return std::nullopt;
  }
}

}  // namespace scanbed::hw
