// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <pugixml.hpp>
#include <string>

#include "sim/spatial/appearance.hpp"

namespace scanbed::sim {

/// Shortest text that reads back to the same doubles, one space between them; the same in every locale.
std::string mjcf_numbers(std::initializer_list<double> values);

/// Who sees a geom, and what it collides with. Scripted things only collide with what is pulled.
struct GeomRole {
  int group;        ///< 0: pictures and laser; 1: pictures; 3: laser
  int contype;      ///< 0: nothing; 1: scripted; 2: pulled
  int conaffinity;  ///< types that it collides with, added up
};
inline constexpr GeomRole kSeenScripted{0, 1, 0};
inline constexpr GeomRole kSeenOnly{0, 0, 0};
inline constexpr GeomRole kSeenPulled{0, 2, 3};
inline constexpr GeomRole kPictureScripted{1, 1, 0};
inline constexpr GeomRole kPictureOnly{1, 0, 0};
inline constexpr GeomRole kLaserOnly{3, 0, 0};

/// A new last child of `parent`; the calls chain: MjcfElement(body, "geom").set("type", "box").set("size",
/// {1, 1, 1}).
class MjcfElement {
 public:
  MjcfElement(pugi::xml_node parent, const char* tag) : node_(parent.append_child(tag)) {}

  MjcfElement& set(const char* key, const std::string& value);
  MjcfElement& set(const char* key, std::initializer_list<double> values);
  MjcfElement& set_color(const Rgb& color);
  MjcfElement& set_role(const GeomRole& role);
  pugi::xml_node node() const { return node_; }

 private:
  pugi::xml_node node_;
};

}  // namespace scanbed::sim
