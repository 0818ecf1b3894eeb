// SPDX-License-Identifier: MIT
#include "sim/spatial/mjcf_element.hpp"

#include <array>
#include <charconv>

namespace scanbed::sim {

std::string mjcf_numbers(std::initializer_list<double> values) {
  std::string text;
  std::array<char, 32> digits{};
  for (const double value : values) {
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    if (!text.empty()) text += ' ';
    text.append(digits.data(), end);
  }
  return text;
}

MjcfElement& MjcfElement::set(const char* key, const std::string& value) {
  node_.append_attribute(key).set_value(value.c_str());
  return *this;
}

MjcfElement& MjcfElement::set(const char* key, std::initializer_list<double> values) {
  return set(key, mjcf_numbers(values));
}

MjcfElement& MjcfElement::set_color(const Rgb& color) {
  return set("rgba", {color.x(), color.y(), color.z(), 1.0});
}

MjcfElement& MjcfElement::set_role(const GeomRole& role) {
  set("group", {static_cast<double>(role.group)});
  set("contype", {static_cast<double>(role.contype)});
  // Of two geoms MuJoCo takes the greater friction: that of the towed cylinder.
  if (role.contype == 1) set("friction", {0.0, 0.0, 0.0});
  return set("conaffinity", {static_cast<double>(role.conaffinity)});
}

}  // namespace scanbed::sim
