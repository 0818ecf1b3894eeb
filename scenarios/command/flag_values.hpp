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

}  // namespace scanbed::scenarios
