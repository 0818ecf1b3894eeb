// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scenarios/command/commands.hpp"

namespace scanbed::scenarios {

/// Where the text of a flag goes: one value, the values of all its repetitions, or whether it is there.
using FlagText = std::variant<std::string*, std::vector<std::string>*, bool*>;

/// A flag ("--seed", "-o,--out") or, without dashes, an argument by its place.
struct Flag {
  std::string name;
  std::string type;  ///< what its value is called in the help; empty where it has none, or needs no word
  std::string help;
  FlagText text;
  bool is_required = false;
  std::optional<int> count;  ///< of values that an argument takes; empty: any number from 1 on
};

/// What a subcommand takes at the command line. Values stay text until `command` checks and converts them, so
/// that all errors read alike.
struct Usage {
  std::string name;
  std::string summary;
  std::vector<Flag> flags;
  std::string footer;                ///< of the help: examples
  std::function<Command()> command;  ///< what the flags ask for; throws InputError. Owns the flags' texts
};

// One a subcommand, each beside what it does.
Usage run_usage();
Usage detect_usage();
Usage render_usage();
Usage convert_usage();
Usage export_usage();
Usage emulate_usage();
Usage devices_usage();
Usage options_usage();
Usage list_usage();
Usage validate_usage();
Usage schema_usage();

}  // namespace scanbed::scenarios
