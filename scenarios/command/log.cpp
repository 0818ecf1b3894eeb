// SPDX-License-Identifier: MIT
#include "scenarios/command/log.hpp"

#include <spdlog/logger.h>
#include <spdlog/sinks/ansicolor_sink.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>

namespace scanbed::scenarios {
namespace {

// spdlog does not look at NO_COLOR itself.
spdlog::color_mode color_mode() {
  const char* no_color = std::getenv("NO_COLOR");
  const bool is_set = no_color != nullptr && *no_color != '\0';
  return is_set ? spdlog::color_mode::never : spdlog::color_mode::automatic;
}

spdlog::logger make_logger() {
  auto sink = std::make_shared<spdlog::sinks::ansicolor_stderr_sink_mt>(color_mode());
  sink->set_pattern("scanbed: %^%v%$");
  return spdlog::logger("scanbed", sink);
}

void write(spdlog::level::level_enum level, const std::string& message) {
  static spdlog::logger logger = make_logger();
  logger.log(level, spdlog::string_view_t(one_line(message)));
}

}  // namespace

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; },
      '?');
  return text;
}

void log_error(std::string_view message) {
  write(spdlog::level::err, "error: " + std::string(message));
}

void log_warning(std::string_view message) {
  write(spdlog::level::warn, "warning: " + std::string(message));
}

void log_note(std::string_view message) {
  write(spdlog::level::info, std::string(message));
}

}  // namespace scanbed::scenarios
