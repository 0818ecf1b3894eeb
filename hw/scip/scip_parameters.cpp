// SPDX-License-Identifier: MIT
#include "hw/scip/scip_parameters.hpp"

#include <charconv>
#include <map>

#include "hw/scip/scip_text.hpp"

namespace scanbed::hw {
namespace {

constexpr int kMostSteps = 100000;

/// "KEY" to "value" of the lines whose sum is right, with the semicolon or without it.
std::map<std::string, std::string> values_of(const std::vector<std::string>& lines) {
  std::map<std::string, std::string> values;
  for (const std::string& line : lines) {
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos || line.size() < colon + 3 || line[line.size() - 2] != ';') continue;
    const std::string body = line.substr(0, line.size() - 2);
    if (scip_sum(body) != line.back() && scip_sum(body + ";") != line.back()) continue;
    values[line.substr(0, colon)] = body.substr(colon + 1);
  }
  return values;
}

bool read(const std::map<std::string, std::string>& values, const char* key, int& number) {
  const auto found = values.find(key);
  if (found == values.end()) return false;
  const std::string& text = found->second;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

bool is_possible(const ScipParameters& p) {
  return p.steps_per_turn > 0 && p.steps_per_turn <= kMostSteps && p.first_step >= 0 &&
         p.last_step > p.first_step && p.last_step <= 9999 && p.front_step >= 0 && p.front_step <= 9999 &&
         p.turns_per_minute > 0 && p.turns_per_minute <= 60000 && p.min_range_mm >= 0 &&
         p.max_range_mm > p.min_range_mm && fault_of(p.geometry()).empty();
}

}  // namespace

ScanGeometry ScipParameters::geometry() const {
  ScanGeometry geometry;
  geometry.num_beams = num_beams();
  geometry.step_rad = 2.0 * kPi / steps_per_turn;
  geometry.first_rad = (first_step - front_step) * geometry.step_rad;
  geometry.min_range_m = min_range_mm / 1000.0;
  geometry.max_range_m = max_range_mm / 1000.0;
  geometry.timing.rotation_s = scan_period_s();
  geometry.timing.step_s = scan_period_s() / steps_per_turn;
  return geometry;
}

std::optional<ScipParameters> parse_scip_parameters(const std::vector<std::string>& lines) {
  const auto values = values_of(lines);
  ScipParameters p;
  const bool is_whole = read(values, "DMIN", p.min_range_mm) && read(values, "DMAX", p.max_range_mm) &&
                        read(values, "ARES", p.steps_per_turn) && read(values, "AMIN", p.first_step) &&
                        read(values, "AMAX", p.last_step) && read(values, "AFRT", p.front_step) &&
                        read(values, "SCAN", p.turns_per_minute);
  if (!is_whole || !is_possible(p)) return std::nullopt;
  if (const auto model = values.find("MODL"); model != values.end()) p.model = model->second;
  return p;
}

ScipParameters utm_30lx() {
  return {"UTM-30LX(Hokuyo Automatic Co.,Ltd.)", 23, 60000, 1440, 0, 1080, 540, 2400};
}

ScipParameters urg_04lx() {
  return {"URG-04LX(Hokuyo Automatic Co.,Ltd.)", 20, 5600, 1024, 44, 725, 384, 600};
}

std::string scip_info_line(const std::string& text) {
  return text + ";" + scip_sum(text) + "\n";
}

std::string to_scip_info(const ScipParameters& p) {
  const auto number = [](const char* key, int value) { return scip_info_line(key + std::to_string(value)); };
  return scip_info_line("MODL:" + p.model) + number("DMIN:", p.min_range_mm) +
         number("DMAX:", p.max_range_mm) + number("ARES:", p.steps_per_turn) + number("AMIN:", p.first_step) +
         number("AMAX:", p.last_step) + number("AFRT:", p.front_step) + number("SCAN:", p.turns_per_minute);
}

}  // namespace scanbed::hw
