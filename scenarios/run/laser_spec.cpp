// SPDX-License-Identifier: MIT
#include "scenarios/run/laser_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>

#include "core/errors/input_error.hpp"
#include "scenarios/load/nearest_name.hpp"
#include "scenarios/load/number.hpp"
#include "scenarios/load/place.hpp"

namespace scanbed::scenarios {
namespace {

constexpr std::string_view kAvailable = "use sim, log:FILE, sick:PORT, scip:PORT or cola:HOST";

[[noreturn]] void refuse_spec(std::string_view text, std::string_view message) {
  throw InputError(fmt::format("--laser {}: {}", quote(text), message));
}

/// One "name=value" of a specification.
struct SpecOption {
  std::string_view name;
  std::string_view value;
};

template <std::size_t N>
[[noreturn]] void refuse_option(const LaserSpec& spec, const SpecOption& option,
                                const std::array<std::string, N>& known) {
  refuse_spec(spec.text, fmt::format("unknown option {}{}", quote(option.name),
                                     name_hint(option.name, known, "options")));
}

double option_number(const LaserSpec& spec, const SpecOption& option) {
  const std::optional<double> number = parse_number(option.value);
  if (number) return *number;
  refuse_spec(spec.text, fmt::format("{}: expected a number, found {}", option.name, quote(option.value)));
}

/// Whether the option is one of replay, and then it is set.
bool set_replay_option(LaserSpec& spec, const SpecOption& option) {
  if (option.name == "speed") {
    spec.replay.speed = option_number(spec, option);
  } else if (option.name == "from") {
    spec.replay.from_s = option_number(spec, option);
  } else if (option.name == "to") {
    spec.replay.to_s = option_number(spec, option);
  } else {
    return false;
  }
  return true;
}

void set_log_option(LaserSpec& spec, const SpecOption& option) {
  static const std::array<std::string, 5> kOptions = {"only", "no_return", "speed", "from", "to"};
  if (set_replay_option(spec, option)) return;
  if (option.name == "only") {
    if (option.value.empty()) refuse_spec(spec.text, "only: expected a message such as FLASER");
    spec.log.only = option.value;
  } else if (option.name == "no_return") {
    const std::optional<double> range_m = parse_number(option.value);
    if (!range_m || *range_m <= 0.0) {
      refuse_spec(spec.text, fmt::format("no_return: expected metres > 0, found {}", quote(option.value)));
    }
    spec.log.no_return_m = *range_m;
  } else {
    refuse_option(spec, option, kOptions);
  }
}

int to_int(const LaserSpec& spec, const SpecOption& option) {
  const std::optional<std::int64_t> count = parse_count(option.value);
  if (count && *count <= 10'000'000) return static_cast<int>(*count);
  refuse_spec(spec.text,
              fmt::format("{}: expected a whole number, found {}", option.name, quote(option.value)));
}

int to_hundredths(const LaserSpec& spec, const SpecOption& option) {
  const std::optional<double> number = parse_number(option.value);
  const double hundredths = number.value_or(0.0) * 100.0;
  const bool is_whole = std::abs(hundredths - std::round(hundredths)) < 1e-6;
  if (number && is_whole && std::abs(*number) <= 360.0) return static_cast<int>(std::lround(hundredths));
  refuse_spec(spec.text, fmt::format("{}: expected degrees in steps of 0.01, found {}", option.name,
                                     quote(option.value)));
}

void set_unit(LaserSpec& spec, const SpecOption& option) {
  if (option.value != "mm" && option.value != "cm") {
    refuse_spec(spec.text, fmt::format("unit: expected mm or cm, found {}", quote(option.value)));
  }
  spec.sick.unit = option.value == "mm" ? RangeUnit::kMillimetre : RangeUnit::kCentimetre;
}

void set_sick_option(LaserSpec& spec, const SpecOption& option) {
  static const std::array<std::string, 6> kOptions = {"baud", "fov_deg", "resolution_deg",
                                                      "unit", "mode",    "lossless"};
  if (option.name == kOptions[0]) {
    spec.sick.baud = to_int(spec, option);
  } else if (option.name == kOptions[1]) {
    spec.sick.fov_deg = to_int(spec, option);
  } else if (option.name == kOptions[2]) {
    spec.sick.resolution_cdeg = to_hundredths(spec, option);
  } else if (option.name == kOptions[3]) {
    set_unit(spec, option);
  } else if (option.name == kOptions[4]) {
    spec.sick.measuring_mode = to_int(spec, option);
  } else if (option.name == kOptions[5]) {
    spec.sick.is_lossless = to_int(spec, option) != 0;
  } else {
    refuse_option(spec, option, kOptions);
  }
}

using SetOption = void (*)(LaserSpec&, const SpecOption&);

/// Cuts "TARGET?name=value&name=value".
void parse_target(LaserSpec& spec, std::string_view rest, SetOption set_option) {
  // The last one: a name may hold a question mark, an option cannot. That of a file that is there is one.
  std::error_code error;
  const bool is_name = std::filesystem::is_regular_file(rest, error);
  const std::size_t mark = is_name ? rest.size() : std::min(rest.rfind('?'), rest.size());
  spec.target = rest.substr(0, mark);
  std::string_view options = rest.substr(std::min(mark + 1, rest.size()));
  std::set<std::string_view> names;
  while (!options.empty()) {
    const std::size_t end = std::min(options.find('&'), options.size());
    const std::string_view option = options.substr(0, end);
    const std::size_t equals = std::min(option.find('='), option.size());
    const std::string_view name = option.substr(0, equals);
    if (!names.insert(name).second) refuse_spec(spec.text, fmt::format("{}: is given twice", name));
    set_option(spec, {name, option.substr(std::min(equals + 1, option.size()))});
    options.remove_prefix(std::min(end + 1, options.size()));
  }
}

void parse_log(LaserSpec& spec, std::string_view rest) {
  spec.kind = LaserKind::kLog;
  if (rest.empty() || rest.front() == '?') refuse_spec(spec.text, "no file; write log:FILE");
  parse_target(spec, rest, set_log_option);
}

void set_scip_option(LaserSpec& spec, const SpecOption& option) {
  static const std::array<std::string, 1> kOptions = {"baud"};
  if (option.name != kOptions[0]) refuse_option(spec, option, kOptions);
  spec.scip.baud = to_int(spec, option);
}

void set_cola_option(LaserSpec& spec, const SpecOption& option) {
  refuse_spec(spec.text, fmt::format("unknown option {}; there are none", quote(option.name)));
}

/// "HOST" or "HOST:PORT"; an address of IPv6 goes without a port.
void parse_host(LaserSpec& spec, std::string& host, int& port) {
  host = spec.target;
  const std::size_t colon = spec.target.find(':');
  if (colon == std::string::npos || colon != spec.target.rfind(':')) return;
  host = spec.target.substr(0, colon);
  port = to_int(spec, {"port", std::string_view(spec.target).substr(colon + 1)});
}

template <typename Options>
void check(const LaserSpec& spec, const Options& options) {
  try {
    options.validate();
  } catch (const InputError& error) {
    refuse_spec(spec.text, error.what());
  }
}

void parse_scip(LaserSpec& spec, std::string_view rest) {
  spec.kind = LaserKind::kScip;
  parse_target(spec, rest, set_scip_option);
  std::error_code error;
  if (spec.target.find('/') != std::string::npos || std::filesystem::is_character_file(spec.target, error)) {
    spec.scip.path = spec.target;
  } else {
    parse_host(spec, spec.scip.host, spec.scip.port);
  }
  check(spec, spec.scip);
}

void parse_cola(LaserSpec& spec, std::string_view rest) {
  spec.kind = LaserKind::kCola;
  parse_target(spec, rest, set_cola_option);
  parse_host(spec, spec.cola.host, spec.cola.port);
  check(spec, spec.cola);
}

void parse_sick(LaserSpec& spec, std::string_view rest) {
  spec.kind = LaserKind::kSick;
  parse_target(spec, rest, set_sick_option);
  spec.sick.path = spec.target;
  check(spec, spec.sick);
}

}  // namespace

LaserSpec parse_laser_spec(std::string_view text) {
  static const std::array<std::string, 5> kKinds = {"sim", "log", "sick", "scip", "cola"};
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string_view kind = text.substr(0, colon);
  const std::string_view rest = text.substr(std::min(colon + 1, text.size()));
  LaserSpec spec;
  spec.text = text;
  if (kind == "sim") {
    spec.target = rest;
  } else if (kind == "log") {
    parse_log(spec, rest);
  } else if (kind == "sick") {
    parse_sick(spec, rest);
  } else if (kind == "scip") {
    parse_scip(spec, rest);
  } else if (kind == "cola") {
    parse_cola(spec, rest);
  } else if (kind == "player") {
    refuse_spec(text, fmt::format("{} is not available yet; {}", kind, kAvailable));
  } else {
    refuse_spec(text,
                fmt::format("unknown kind of laser{}; {}", name_hint(kind, kKinds, "kinds"), kAvailable));
  }
  return spec;
}

}  // namespace scanbed::scenarios
