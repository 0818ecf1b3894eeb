// SPDX-License-Identifier: MIT
#include "scenarios/load/library.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "core/errors/input_error.hpp"
#include "scenarios/load/nearest_name.hpp"
#include "scenarios/load/place.hpp"

namespace scanbed::scenarios {
namespace {

namespace fs = std::filesystem;

bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

// Empty where the system does not say which file runs.
fs::path folder_beside_program() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path() : program.parent_path().parent_path() / "share/scanbed/library";
}

bool is_path(std::string_view text) {
  return text.find('/') != std::string_view::npos || text.ends_with(".yaml") || text.ends_with(".yml");
}

}  // namespace

fs::path library_folder() {
  if (const char* set = std::getenv("SCANBED_LIBRARY"); set != nullptr && *set != '\0') {
    if (!is_folder(set)) throw InputError(fmt::format("SCANBED_LIBRARY: {} is no folder", quote(set)));
    return set;
  }
  fs::path installed = folder_beside_program();
  if (is_folder(installed)) return installed;
  fs::path source = SCANBED_LIBRARY_FOLDER;
  if (is_folder(source)) return source;
  throw InputError(fmt::format("scenario library not found in {} or {}; set SCANBED_LIBRARY to its folder",
                               installed.string(), source.string()));
}

std::vector<std::string> library_names(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().extension() == ".yaml") names.push_back(entry->path().stem().string());
  }
  if (error) throw InputError(fmt::format("{}: {}", folder.string(), error.message()));
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> names_that_fit(const std::string& name_or_pattern) {
  if (is_path(name_or_pattern) || name_or_pattern.find_first_of("*?[") == std::string::npos) {
    return {name_or_pattern};
  }
  std::vector<std::string> names = library_names(library_folder());
  std::erase_if(names, [&](const std::string& name) {
    return ::fnmatch(name_or_pattern.c_str(), name.c_str(), 0) != 0;
  });
  if (names.empty()) {
    throw InputError(fmt::format("no scenario fits {}; 'scanbed list' shows all", quote(name_or_pattern)));
  }
  return names;
}

fs::path find_scenario(std::string_view name_or_path) {
  if (is_path(name_or_path)) return name_or_path;
  const fs::path folder = library_folder();
  const std::vector<std::string> names = library_names(folder);
  if (!std::binary_search(names.begin(), names.end(), name_or_path)) {
    std::error_code error;
    if (fs::exists(name_or_path, error)) {
      throw InputError(fmt::format("unknown scenario {}; a file's name ends in .yaml or .yml, or write ./{}",
                                   quote(name_or_path), name_or_path));
    }
    throw InputError(fmt::format("unknown scenario {}{}; 'scanbed list' shows all", quote(name_or_path),
                                 name_hint(name_or_path, names, "scenarios")));
  }
  return folder / (std::string(name_or_path) + ".yaml");
}

}  // namespace scanbed::scenarios
