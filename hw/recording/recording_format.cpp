// SPDX-License-Identifier: MIT
#include "hw/recording/recording_format.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

#include "hw/recording/bag_reader.hpp"
#include "hw/recording/field_reader.hpp"
#include "hw/recording/json_lines.hpp"
#include "hw/recording/line_reader.hpp"
#include "hw/recording/mcap_record.hpp"

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

/// "FLASER 361 ...": names of messages are in capitals.
bool is_carmen_line(std::string_view line) {
  const std::string_view name = FieldReader(line).word();
  return !name.empty() && std::isupper(static_cast<unsigned char>(name.front())) != 0 &&
         is_number(name, "ABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789");
}

/// By the first line that is whole and neither empty nor a comment.
std::optional<RecordingFormat> format_of_lines(std::string_view head) {
  for (std::size_t end = head.find('\n'); end != std::string_view::npos; end = head.find('\n')) {
    const std::string_view line = head.substr(0, end);
    head.remove_prefix(end + 1);
    if (line.empty() || line == "\r" || line.front() == '#') continue;
    if (is_player_line(line)) return RecordingFormat::kPlayer;
    if (is_carmen_line(line)) return RecordingFormat::kCarmen;
    break;
  }
  return std::nullopt;
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
  if (head.starts_with(kByteOrderMark)) head.remove_prefix(kByteOrderMark.size());
  if (is_json_lines(head)) return RecordingFormat::kJsonLines;
  return format_of_lines(head);
}

}  // namespace scanbed::hw
