// SPDX-License-Identifier: MIT
#include "scenarios/command/commands.hpp"
#include "scenarios/command/usage.hpp"
#include "scenarios/load/load_scenario.hpp"
#include "scenarios/run/output.hpp"
#include "scenarios/schema/json_schema.hpp"
#include "scenarios/schema/learn_keys.hpp"

namespace scanbed::scenarios {

ExitCode execute(const SchemaCommand&) {
  write_whole(std::nullopt, json_schema(learn_keys(read_scenario)));
  return kExitFine;
}

Usage schema_usage() {
  Usage usage{.name = "schema", .summary = "Print the JSON Schema of scenario files"};
  usage.footer =
      R"(For editors that complete and check YAML. 'scanbed validate' checks more: what must fit together.
Example:
  scanbed schema > scanbed.schema.json)";
  usage.command = [] { return SchemaCommand{}; };
  return usage;
}

}  // namespace scanbed::scenarios
