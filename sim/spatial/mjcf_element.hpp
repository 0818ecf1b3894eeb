// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <pugixml.hpp>
#include <string>

#include "sim/spatial/appearance.hpp"

namespace scanbed::sim {

/// Shortest text that reads back to the same doubles, one space between them; the same in every locale.
std::string mjcf_numbers(std::initializer_list<double> values);

/// A new last child of `parent`; the calls chain: MjcfElement(body, "geom").set("type", "box").set("size",
/// {1, 1, 1}).
class MjcfElement {
 public:
  MjcfElement(pugi::xml_node parent, const char* tag) : node_(parent.append_child(tag)) {}

  MjcfElement& set(const char* key, const std::string& value);
  MjcfElement& set(const char* key, std::initializer_list<double> values);
  MjcfElement& set_color(const Rgb& color);
  pugi::xml_node node() const { return node_; }

 private:
  pugi::xml_node node_;
};

}  // namespace scanbed::sim
