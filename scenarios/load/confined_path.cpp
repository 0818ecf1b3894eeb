// SPDX-License-Identifier: MIT
#include "scenarios/load/confined_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <system_error>

#include "scenarios/load/library.hpp"

namespace scanbed::scenarios {
namespace {

namespace fs = std::filesystem;

bool is_within(const fs::path& file, const fs::path& folder) {
  const auto [end, unused] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return end == folder.end();
}

// Empty where the folder has no such file. Where links of its lead to is compared after they are followed.
std::optional<fs::path> find_in(const fs::path& folder, const std::string& name, const Place& place) {
  std::error_code error;
  const fs::path canonical_folder = fs::canonical(folder, error);
  if (error) return std::nullopt;
  const fs::path file = fs::canonical(canonical_folder / name, error);
  if (error) return std::nullopt;
  if (!is_within(file, canonical_folder)) {
    refuse(place, fmt::format("{} leads out of the folder of its file", quote(name)));
  }
  if (!fs::is_regular_file(file, error)) refuse(place, fmt::format("{} is no file", quote(name)));
  return file;
}

}  // namespace

fs::path find_confined(const Place& place, const std::string& name, const fs::path& folder) {
  const fs::path path(name);
  const bool climbs = std::find(path.begin(), path.end(), "..") != path.end();
  if (path.is_absolute() || climbs || name.find('\0') != std::string::npos) {
    refuse(place,
           fmt::format("{}: expected a file beside this one or of the library, without '..'", quote(name)));
  }
  if (!folder.empty()) {
    if (const auto found = find_in(folder, name, place)) return *found;
  }
  if (const auto found = find_in(library_folder(), name, place)) return *found;
  refuse(place, fmt::format("no file {} {}in the library", quote(name),
                            folder.empty() ? "" : "beside this one or "));
}

}  // namespace scanbed::scenarios
