// SPDX-License-Identifier: MIT
#include "scenarios/run/laser_spec.hpp"

#include <fmt/format.h>

#include <array>

#include "core/errors/input_error.hpp"
#include "scenarios/load/nearest_name.hpp"
#include "scenarios/load/number.hpp"
#include "scenarios/load/place.hpp"

namespace scanbed::scenarios {
namespace {

constexpr std::string_view kAvailable = "use sim or log:FILE";

[[noreturn]] void refuse_spec(std::string_view text, std::string_view message) {
  throw InputError(fmt::format("--laser {}: {}", quote(text), message));
}

double option_number(const LaserSpec& spec, std::string_view name, std::string_view value) {
  const std::optional<double> number = parse_number(value);
  if (number) return *number;
  refuse_spec(spec.text, fmt::format("{}: expected a number, found {}", name, quote(value)));
}

/// Whether the option is one of replay, and then it is set.
bool set_replay_option(LaserSpec& spec, std::string_view name, std::string_view value) {
  if (name == "speed") {
    spec.replay.speed = option_number(spec, name, value);
  } else if (name == "from") {
    spec.replay.from_s = option_number(spec, name, value);
  } else if (name == "to") {
    spec.replay.to_s = option_number(spec, name, value);
  } else {
    return false;
  }
  return true;
}

void set_log_option(LaserSpec& spec, std::string_view option) {
  static const std::array<std::string, 5> kOptions = {"only", "no_return", "speed", "from", "to"};
  const std::size_t equals = std::min(option.find('='), option.size());
  const std::string_view name = option.substr(0, equals);
  const std::string_view value = option.substr(std::min(equals + 1, option.size()));
  if (set_replay_option(spec, name, value)) return;
  if (name == "only" && !value.empty()) {
    spec.log.only = value;
  } else if (name == "no_return") {
    const std::optional<double> range_m = parse_number(value);
    if (!range_m || *range_m <= 0.0) {
      refuse_spec(spec.text, fmt::format("no_return: expected metres > 0, found {}", quote(value)));
    }
    spec.log.no_return_m = *range_m;
  } else if (name == "only") {
    refuse_spec(spec.text, "only: expected a message such as FLASER");
  } else {
    refuse_spec(spec.text,
                fmt::format("unknown option {}{}", quote(name), name_hint(name, kOptions, "options")));
  }
}

void parse_log(LaserSpec& spec, std::string_view rest) {
  // The last one: a file's name may hold a question mark, an option cannot.
  const std::size_t mark = std::min(rest.rfind('?'), rest.size());
  spec.target = rest.substr(0, mark);
  if (spec.target.empty()) refuse_spec(spec.text, "no file; write log:FILE");
  std::string_view options = rest.substr(std::min(mark + 1, rest.size()));
  while (!options.empty()) {
    const std::size_t end = std::min(options.find('&'), options.size());
    set_log_option(spec, options.substr(0, end));
    options.remove_prefix(std::min(end + 1, options.size()));
  }
}

}  // namespace

LaserSpec parse_laser_spec(std::string_view text) {
  static const std::array<std::string, 4> kKinds = {"sim", "log", "sick", "player"};
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string_view kind = text.substr(0, colon);
  const std::string_view rest = text.substr(std::min(colon + 1, text.size()));
  LaserSpec spec{.kind = LaserKind::kSimulated, .text = std::string(text), .target = {}, .log = {}};
  if (kind == "sim") {
    spec.target = rest;
  } else if (kind == "log") {
    spec.kind = LaserKind::kLog;
    parse_log(spec, rest);
  } else if (kind == "sick" || kind == "player") {
    refuse_spec(text, fmt::format("{} is not available yet; {}", kind, kAvailable));
  } else {
    refuse_spec(text,
                fmt::format("unknown kind of laser{}; {}", name_hint(kind, kKinds, "kinds"), kAvailable));
  }
  return spec;
}

}  // namespace scanbed::scenarios
