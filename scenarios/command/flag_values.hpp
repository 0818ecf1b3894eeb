// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/run/laser_spec.hpp"

namespace scanbed::scenarios {

// Texts of flags as values. What is wrong is an InputError that names the flag, the text and what is
// expected.

/// A whole number, `least` or more.
std::int64_t to_count(std::string_view flag, const std::string& text, std::int64_t least,
                      std::optional<std::int64_t> greatest = {});

double to_time_s(std::string_view flag, const std::string& text);

/// The place of `text` among the known names; `what` is their plural in the message.
std::size_t to_choice(std::string_view flag, const std::string& text, std::span<const std::string> known,
                      std::string_view what);

/// Empty where the flag was not given.
std::optional<std::filesystem::path> to_path(const std::string& text);

/// As to_path(), for what cannot go to standard output.
std::optional<std::filesystem::path> to_file(std::string_view flag, const std::string& text);

/// A file, and the flag that names it.
struct FlagFile {
  std::string_view flag;
  std::optional<std::filesystem::path> path;  ///< empty: the flag was not given
};

/// Refuses one file for two flags, under whatever names, where one of them writes it: a result or what was
/// read would be lost. Devices and pipes take both.
void check_files(std::span<const FlagFile> written, std::span<const FlagFile> read);

/// What a laser reads, if that is a file.
FlagFile laser_file(const LaserSpec& spec);

/// The scenarios that are named by a file, not as one of the library.
std::vector<FlagFile> scenario_files(std::span<const std::string> scenarios);

}  // namespace scanbed::scenarios
