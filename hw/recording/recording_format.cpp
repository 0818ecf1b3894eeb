// SPDX-License-Identifier: MIT
#include "hw/recording/recording_format.hpp"

#include <algorithm>
#include <cstddef>

#include "hw/recording/bag_reader.hpp"
#include "hw/recording/field_reader.hpp"
#include "hw/recording/json_lines.hpp"
#include "hw/recording/mcap_reader.hpp"

namespace scanbed::hw {
namespace {

bool is_number(std::string_view word, std::string_view allowed) {
  return !word.empty() && word.find_first_not_of(allowed) == std::string_view::npos;
}

/// "time host robot interface index type subtype ..."
bool is_player_line(std::string_view line) {
  constexpr std::string_view kDigits = "0123456789";
  FieldReader fields(line);
  const std::string_view time = fields.word();
  if (!is_number(time, "0123456789.") || time.find('.') == std::string_view::npos) return false;
  if (!is_number(fields.word(), kDigits) || !is_number(fields.word(), kDigits)) return false;
  if (!is_number(fields.word(), "abcdefghijklmnopqrstuvwxyz0123456789_")) return false;
  return is_number(fields.word(), kDigits) && is_number(fields.word(), kDigits) &&
         is_number(fields.word(), kDigits);
}

/// Does not parse: the first line holds the text of a scenario, and may be longer than the head.
bool is_json_lines(std::string_view head) {
  head.remove_prefix(std::min(head.find_first_not_of(" \t\r"), head.size()));
  const std::string_view line = head.substr(0, head.find('\n'));
  return line.starts_with('{') && line.find(kJsonLinesFormat) != std::string_view::npos;
}

bool is_player(std::string_view head) {
  while (!head.empty()) {
    const std::size_t end = std::min(head.find('\n'), head.size());
    const std::string_view line = head.substr(0, end);
    if (!line.empty() && line != "\r" && line.front() != '#') return is_player_line(line);
    head.remove_prefix(std::min(end + 1, head.size()));
  }
  return false;
}

}  // namespace

std::optional<RecordingFormat> format_of_name(const std::filesystem::path& path) {
  std::filesystem::path name = path.filename();
  if (name.extension() == ".part") name = name.stem();
  const bool is_packed = name.extension() == ".gz";
  if (is_packed) name = name.stem();
  const std::filesystem::path extension = name.extension();
  if (extension == ".log" || extension == ".clf") return RecordingFormat::kCarmen;
  if (extension == ".player" || extension == ".plog") return RecordingFormat::kPlayer;
  if (extension == ".jsonl") return RecordingFormat::kJsonLines;
  if (is_packed) return std::nullopt;
  if (extension == ".bag") return RecordingFormat::kBag;
  if (extension == ".mcap") return RecordingFormat::kMcap;
  return std::nullopt;
}

bool is_packed_name(const std::filesystem::path& path) {
  return path.extension() == ".gz";
}

std::optional<RecordingFormat> format_of_content(std::string_view head) {
  if (head.starts_with(kBagMagic)) return RecordingFormat::kBag;
  if (head.starts_with(kMcapMagic)) return RecordingFormat::kMcap;
  if (is_json_lines(head)) return RecordingFormat::kJsonLines;
  if (is_player(head)) return RecordingFormat::kPlayer;
  return std::nullopt;
}

}  // namespace scanbed::hw
