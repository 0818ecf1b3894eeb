// SPDX-License-Identifier: MIT
#include "scenarios/command/flag_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/errors/input_error.hpp"
#include "hw/recording/new_file.hpp"
#include "scenarios/load/is_digit.hpp"
#include "scenarios/load/nearest_name.hpp"
#include "scenarios/load/number.hpp"
#include "scenarios/load/place.hpp"

namespace scanbed::scenarios {
namespace {

namespace fs = std::filesystem;

fs::path resolved(const fs::path& path) {
  std::error_code error;
  return fs::weakly_canonical(hw::behind_links(fs::absolute(path, error)), error);
}

bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  const fs::file_status status = fs::status(a, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) return false;
  return resolved(a) == resolved(b);
}

bool is_same_file(const FlagFile& a, const FlagFile& b) {
  return a.path && b.path && is_same_file(*a.path, *b.path);
}

}  // namespace

std::int64_t to_count(std::string_view flag, const std::string& text, std::int64_t least,
                      std::optional<std::int64_t> greatest) {
  const bool is_negative = text.starts_with('-') && parse_count(text.substr(1)).has_value();
  const std::optional<std::int64_t> count = is_negative ? -1 : parse_count(text);
  if (!count && !text.empty() && std::all_of(text.begin(), text.end(), is_digit)) {
    constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
    throw InputError(fmt::format("{}: value {} is out of range; allowed: [{}, {}]", flag, text, least,
                                 greatest.value_or(kMost)));
  }
  if (!count) throw InputError(fmt::format("{}: expected a whole number, found {}", flag, quote(text)));
  require(*count >= least && (!greatest || *count <= *greatest), flag, parse_number(text).value_or(0.0),
          greatest ? fmt::format("[{}, {}]", least, *greatest) : fmt::format(">= {}", least));
  return *count;
}

double to_time_s(std::string_view flag, const std::string& text) {
  const std::optional<double> time_s = parse_number(text);
  if (!time_s) throw InputError(fmt::format("{}: expected seconds, found {}", flag, quote(text)));
  return *time_s;
}

std::size_t to_choice(std::string_view flag, const std::string& text, std::span<const std::string> known,
                      std::string_view what) {
  const auto found = std::find(known.begin(), known.end(), text);
  if (found == known.end()) {
    throw InputError(fmt::format("{}: unknown value {}{}", flag, quote(text), name_hint(text, known, what)));
  }
  return static_cast<std::size_t>(found - known.begin());
}

std::optional<std::filesystem::path> to_path(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional<std::filesystem::path>(text);
}

std::optional<std::filesystem::path> to_file(std::string_view flag, const std::string& text) {
  if (text == "-") throw InputError(fmt::format("{}: cannot be standard output; name a file", flag));
  return to_path(text);
}

void check_files(std::span<const FlagFile> written, std::span<const FlagFile> read) {
  const auto refuse = [](const FlagFile& file, std::string_view why) {
    throw InputError(fmt::format("{}: {}: {}; name another one", file.flag, file.path->string(), why));
  };
  for (std::size_t i = 0; i < written.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (!is_same_file(written[i], written[k])) continue;
      refuse(written[i], fmt::format("is the file of {}, too", written[k].flag));
    }
    for (const FlagFile& source : read) {
      if (!is_same_file(written[i], source)) continue;
      refuse(written[i], fmt::format("is what {} reads", source.flag));
    }
  }
}

FlagFile laser_file(const LaserSpec& spec) {
  std::error_code error;
  const bool reads_file = spec.kind == LaserKind::kLog || fs::is_regular_file(spec.target, error);
  return {"--laser", reads_file && !spec.is_device() ? to_path(spec.target) : std::nullopt};
}

std::vector<FlagFile> scenario_files(std::span<const std::string> scenarios) {
  std::vector<FlagFile> files;
  std::error_code error;
  for (const std::string& scenario : scenarios) {
    if (fs::is_regular_file(scenario, error)) files.push_back({"SCENARIO", scenario});
  }
  return files;
}

}  // namespace scanbed::scenarios
