// SPDX-License-Identifier: MIT
#include "sim/spatial/posed_mjcf.hpp"

#include <cstddef>
#include <pugixml.hpp>
#include <sstream>

#include "core/errors/ensure.hpp"
#include "sim/spatial/mjcf.hpp"
#include "sim/spatial/mjcf_element.hpp"
#include "sim/spatial/mujoco_model.hpp"
#include "sim/spatial/pose_actors.hpp"

namespace scanbed::sim {
namespace {

void set(pugi::xml_node body, const char* key, std::initializer_list<double> values) {
  pugi::xml_attribute attribute = body.attribute(key);
  if (!attribute) attribute = body.append_attribute(key);
  attribute.set_value(mjcf_numbers(values).c_str());
}

}  // namespace

std::string posed_mjcf(const World& world, const WorldState& state) {
  const std::string text = mjcf_of(world);
  const ModelPtr model = load_model(text);
  const DataPtr data = make_data(*model);
  pose_actors(world, state, *model, *data);
  pugi::xml_document document;
  SCANBED_ENSURE(document.load_string(text.c_str()));
  for (pugi::xml_node body : document.child("mujoco").child("worldbody").children("body")) {
    const int id = mj_name2id(model.get(), mjOBJ_BODY, body.attribute("name").value());
    SCANBED_ENSURE(id > 0);
    const auto place = static_cast<std::ptrdiff_t>(id);
    const mjtNum* const p_WB = data->xpos + 3 * place;
    const mjtNum* const q_WB = data->xquat + 4 * place;
    set(body, "pos", {p_WB[0], p_WB[1], p_WB[2]});
    set(body, "quat", {q_WB[0], q_WB[1], q_WB[2], q_WB[3]});
  }
  std::ostringstream posed;
  document.save(posed, "  ");
  return posed.str();
}

}  // namespace scanbed::sim
