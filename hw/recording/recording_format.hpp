// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace scanbed::hw {

enum class RecordingFormat { kCarmen, kPlayer, kBag, kMcap, kJsonLines };

/// The format that a name asks for: .log .clf (CARMEN), .player .plog (Player), .bag (ROS 1), .mcap, .jsonl
/// (ours); behind a text format .gz packs it, and .part is what an unfinished recording is called. Nothing
/// for other names.
std::optional<RecordingFormat> format_of_name(const std::filesystem::path& path);

/// Whether the name ends in .gz.
bool is_packed_name(const std::filesystem::path& path);

/// The format that a recording's first bytes, unpacked, show; nothing where they show none. Logs of text show
/// theirs by the first line that is no comment.
std::optional<RecordingFormat> format_of_content(std::string_view head);

}  // namespace scanbed::hw
