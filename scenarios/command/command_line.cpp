// SPDX-License-Identifier: MIT
#include "scenarios/command/command_line.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <string_view>

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
'scanbed help COMMAND' tells more.
Exit codes: 0 fine, 1 a gate was missed, 2 bad input or usage, 3 device or I/O fault,
130 interrupted (Ctrl-C), 143 terminated (SIGTERM), 129 hung up (SIGHUP); what was done until then is
written.)";

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

// Else what an empty variable of a shell leaves of `--out "$DIR"` would count as not given.
void refuse_nothing(CLI::Option& option, const Flag& flag) {
  if (std::holds_alternative<bool*>(flag.text)) return;
  const std::string type = flag.type.empty() ? "a value" : flag.type;
  option.check(
      [type](const std::string& text) { return text.empty() ? "expected " + type + ", found ''" : ""; });
}

CLI::App* add_subcommand(CLI::App& app, const Usage& usage) {
  CLI::App* command = app.add_subcommand(usage.name, usage.summary);
  for (const Flag& flag : usage.flags) {
    CLI::Option* option = add_option(*command, flag)->required(flag.is_required);
    refuse_nothing(*option, flag);
  }
  command->footer(usage.footer);
  return command;
}

// The parser would only say that a subcommand is missing.
void check_command(const std::vector<Usage>& usages, std::span<const char* const> words) {
  if (words.size() < 2 || words[1][0] == '-') return;
  std::vector<std::string> names{"help"};
  names.reserve(usages.size());
  for (const Usage& usage : usages) names.push_back(usage.name);
  if (std::find(names.begin(), names.end(), words[1]) != names.end()) return;
  throw InputError(fmt::format("unknown command {}{}; see 'scanbed --help'", quote(words[1]),
                               name_hint(words[1], names, "commands")));
}

// `help` and `help COMMAND` as `--help` and `COMMAND --help`.
std::vector<const char*> without_help_command(int argc, const char* const* argv) {
  std::vector<const char*> words(argv, argv + argc);
  if (words.size() < 2 || std::string_view(words[1]) != "help") return words;
  words.erase(words.begin() + 1);
  words.insert(words.begin() + std::min<std::ptrdiff_t>(2, std::ssize(words)), "--help");
  return words;
}

std::string describe_unknown(const CLI::App& app, const std::string& word) {
  if (!word.starts_with('-')) return fmt::format("unexpected argument {}", quote(word));
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  const std::string name = word.substr(0, word.find('='));
  return fmt::format("unknown option {}{}", quote(name), near_name_hint(name, names));
}

// The parser's messages are one line without a full stop; where the help is tells the user what to do.
[[noreturn]] void refuse_usage(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const std::string name = chosen.empty() ? "scanbed" : "scanbed " + chosen.front()->get_name();
  // What is unknown comes before what is missing: mostly that is what was meant by it.
  const std::vector<std::string> unknown = app.remaining(true);
  const std::string fault = unknown.empty()
                                ? error.what()
                                : describe_unknown(chosen.empty() ? app : *chosen.front(), unknown.front());
  throw InputError(fmt::format("{}; see '{} --help'", fault, name));
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
  const std::vector<const char*> words = without_help_command(argc, argv);
  check_command(usages, words);
  try {
    app.parse(static_cast<int>(words.size()), words.data());
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
