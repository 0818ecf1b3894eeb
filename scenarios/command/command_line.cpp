// SPDX-License-Identifier: MIT
#include "scenarios/command/command_line.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>

#include "core/errors/input_error.hpp"
#include "scenarios/command/usage.hpp"
#include "scenarios/load/nearest_name.hpp"
#include "scenarios/load/place.hpp"
#include "scenarios/report/version.hpp"

namespace scanbed::scenarios {
namespace {

constexpr const char* kMainHelp = R"(Examples:
  scanbed list
  scanbed run static_hallway --out pictures
  scanbed detect --laser log:FILE.log > features.jsonl
'scanbed COMMAND --help' tells more.
Exit codes: 0 fine, 1 a gate was missed, 2 bad input or usage, 3 device or I/O fault,
130 interrupted (Ctrl-C), 143 terminated (SIGTERM); what was done until then is written.)";

// In the order of the help.
std::vector<Usage> all_usages() {
  return {run_usage(),     detect_usage(),  render_usage(), convert_usage(),  export_usage(), emulate_usage(),
          devices_usage(), options_usage(), list_usage(),   validate_usage(), schema_usage()};
}

CLI::Option* add_option(CLI::App& app, const Flag& flag) {
  if (bool* const* is_there = std::get_if<bool*>(&flag.text)) {
    return app.add_flag(flag.name, **is_there, flag.help);
  }
  if (std::string* const* text = std::get_if<std::string*>(&flag.text)) {
    CLI::Option* option = app.add_option(flag.name, **text, flag.help)->type_name(flag.type);
    if (!(*text)->empty()) option->capture_default_str();
    return option;
  }
  CLI::Option* option = app.add_option(flag.name, *std::get<std::vector<std::string>*>(flag.text), flag.help)
                            ->type_name(flag.type);
  // A flag takes one value each time, so that arguments may follow it.
  if (flag.name.starts_with('-')) option->allow_extra_args(false);
  if (flag.count) option->expected(*flag.count);
  return option;
}

CLI::App* add_subcommand(CLI::App& app, const Usage& usage) {
  CLI::App* command = app.add_subcommand(usage.name, usage.summary);
  for (const Flag& flag : usage.flags) add_option(*command, flag)->required(flag.is_required);
  command->footer(usage.footer);
  return command;
}

// The parser would only say that a subcommand is missing.
void check_command(const std::vector<Usage>& usages, int argc, const char* const* argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  names.reserve(usages.size());
  for (const Usage& usage : usages) names.push_back(usage.name);
  if (std::find(names.begin(), names.end(), argv[1]) != names.end()) return;
  throw InputError(fmt::format("unknown command {}{}; see 'scanbed --help'", quote(argv[1]),
                               name_hint(argv[1], names, "commands")));
}

// The parser's messages are one line without a full stop; where the help is tells the user what to do.
[[noreturn]] void refuse_usage(const CLI::App& app, const CLI::ParseError& error) {
  std::string name = "scanbed";
  for (const CLI::App* chosen : app.get_subcommands()) name += " " + chosen->get_name();
  throw InputError(fmt::format("{}; see '{} --help'", error.what(), name));
}

}  // namespace

Command parse_command_line(int argc, const char* const* argv) {
  CLI::App app("A testbed for feature detectors on 2D laser scans.", "scanbed");
  app.set_version_flag("--version", fmt::format("scanbed {}", kVersion));
  app.require_subcommand(1);
  app.footer(kMainHelp);
  const std::vector<Usage> usages = all_usages();
  std::vector<const CLI::App*> commands;
  commands.reserve(usages.size());
  for (const Usage& usage : usages) commands.push_back(add_subcommand(app, usage));
  check_command(usages, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion& version) {
    return TextCommand{std::string(version.what()) + "\n"};
  } catch (const CLI::CallForHelp&) {
    return TextCommand{app.help()};
  } catch (const CLI::ParseError& error) {
    refuse_usage(app, error);
  }
  const auto chosen = std::find_if(commands.begin(), commands.end(),
                                   [](const CLI::App* command) { return command->parsed(); });
  return usages[static_cast<std::size_t>(chosen - commands.begin())].command();
}

}  // namespace scanbed::scenarios
