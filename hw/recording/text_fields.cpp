// SPDX-License-Identifier: MIT
#include "hw/recording/text_fields.hpp"

#include "hw/recording/json_text.hpp"

namespace scanbed::hw {

void append_fixed(std::string& out, double value, int num_digits) {
  // Room for the greatest double, 309 digits before its point.
  std::array<char, 512> digits;
  const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                     std::chars_format::fixed, num_digits);
  out.push_back(' ');
  out.append(digits.data(), written.ptr);
}

std::string metadata_text(const std::map<std::string, std::string>& metadata) {
  std::string out;
  JsonText json(out);
  json.begin_object();
  for (const auto& [key, value] : metadata) json.key(key).text(value);
  json.end_object();
  return out;
}

}  // namespace scanbed::hw
