// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace scanbed::scenarios {

// Texts of flags as values. What is wrong is an InputError that names the flag, the text and what is
// expected.

/// A whole number, `least` or more.
std::int64_t to_count(std::string_view flag, const std::string& text, std::int64_t least);

double to_time_s(std::string_view flag, const std::string& text);

/// The place of `text` among the known names; `what` is their plural in the message.
std::size_t to_choice(std::string_view flag, const std::string& text, std::span<const std::string> known,
                      std::string_view what);

/// Empty where the flag was not given.
std::optional<std::filesystem::path> to_path(const std::string& text);

/// A file to write, and the flag that asks for it.
struct FileToWrite {
  std::string_view flag;
  std::optional<std::filesystem::path> path;  ///< empty: the flag was not given
};

/// Refuses one file for two flags, under whatever names: one of the two results would be lost. Devices and
/// pipes take both.
void check_all_differ(std::span<const FileToWrite> files);

}  // namespace scanbed::scenarios
