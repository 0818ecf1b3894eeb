// SPDX-License-Identifier: MIT
// Any text is a scenario that keeps its promises, or an InputError of one line that says where.
#include <cmath>
#include <string>
#include <string_view>

#include "core/errors/ensure.hpp"
#include "core/errors/input_error.hpp"
#include "scenarios/load/load_scenario.hpp"
#include "tests/fuzz/fuzz_target.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const scanbed::scenarios::Scenario scenario = scanbed::scenarios::parse_scenario(text, "input");
    SCANBED_ENSURE(!scenario.name.empty());
    SCANBED_ENSURE(std::isfinite(scenario.duration_s) && scenario.duration_s > 0.0);
  } catch (const scanbed::InputError& error) {
    const std::string_view message = error.what();
    // Of the text, or of a file of the library that it includes.
    SCANBED_ENSURE(message.starts_with("input") || message.find(".yaml") != std::string_view::npos);
    SCANBED_ENSURE(message.find('\n') == std::string_view::npos);
  }
  return 0;
}
