// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/scenarios/run_program.hpp"

namespace scanbed::scenarios {
namespace {

using testing::Outcome;
using testing::run_program;

TEST(SchemaTest, PrintsASchemaOfAllSections) {
  const Outcome outcome = run_program({"schema"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  const nlohmann::json schema = nlohmann::json::parse(outcome.out);
  const nlohmann::json& keys = schema["$defs"]["whole"]["properties"];
  for (const char* key : {"schema", "name", "description", "seed", "duration", "vars", "include", "sensor",
                          "robot", "world", "actors", "score", "expect", "outputs", "known_fail"}) {
    EXPECT_TRUE(keys.contains(key)) << key;
  }
  EXPECT_EQ(schema["$defs"]["whole"]["required"], nlohmann::json({"schema", "name", "duration"}));
}

}  // namespace
}  // namespace scanbed::scenarios
