// SPDX-License-Identifier: MIT
#include "scenarios/command/flag_values.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/errors/input_error.hpp"
#include "scenarios/load/nearest_name.hpp"
#include "scenarios/load/number.hpp"
#include "scenarios/load/place.hpp"

namespace scanbed::scenarios {
namespace {

namespace fs = std::filesystem;

bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  const fs::file_status status = fs::status(a, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) return false;
  return fs::weakly_canonical(fs::absolute(a, error), error) ==
         fs::weakly_canonical(fs::absolute(b, error), error);
}

}  // namespace

std::int64_t to_count(std::string_view flag, const std::string& text, std::int64_t least) {
  const std::optional<std::int64_t> count = parse_count(text);
  if (!count) throw InputError(fmt::format("{}: expected a whole number, found {}", flag, quote(text)));
  require(*count >= least, flag, static_cast<double>(*count), fmt::format(">= {}", least));
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

void check_all_differ(std::span<const FileToWrite> files) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (!files[i].path || !files[k].path || !is_same_file(*files[i].path, *files[k].path)) continue;
      throw InputError(fmt::format("{}: {}: is the file of {}, too; name another one", files[i].flag,
                                   files[i].path->string(), files[k].flag));
    }
  }
}

}  // namespace scanbed::scenarios
