// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "core/detect/presets.hpp"
#include "scenarios/load/nearest_name.hpp"
#include "scenarios/load/sections.hpp"
#include "scenarios/load/table.hpp"

namespace scanbed::scenarios {
namespace {

constexpr Allowed kCount{.least = 0.0, .greatest = 10'000.0};
constexpr Allowed kDistance_m{.least = 0.0, .greatest = 100.0, .open = true};

// Names that truth uses, and those of the things that they are parts of: "bench", "bench.foot_0".
std::vector<std::string> object_names(const sim::World& world) {
  std::vector<std::string> names;
  for (const sim::Solid& solid : world.solids) {
    names.push_back(solid.id);
    const std::size_t dot = solid.id.rfind('.');
    if (dot != std::string::npos) names.push_back(solid.id.substr(0, dot));
    const auto* walls = std::get_if<sim::WallChain>(&solid.shape);
    const std::size_t num_walls = walls == nullptr ? 0 : walls->corners_m.size() - (walls->closed ? 0 : 1);
    for (std::size_t i = 0; i < num_walls; ++i) names.push_back(fmt::format("{}.{}", solid.id, i));
  }
  for (const sim::Walker& walker : world.walkers) {
    for (const char* part : {"", ".left_leg", ".right_leg"}) names.push_back(walker.id + part);
    if (walker.tow) names.push_back(walker.tow->id);
  }
  return names;
}

NearObject load_near(const Value& id, Table& table, const sim::World& world) {
  NearObject near{.id = id.text(), .within_m = table.need("within").number(kDistance_m)};
  const std::vector<std::string> names = object_names(world);
  if (std::find(names.begin(), names.end(), near.id) == names.end()) {
    id.refuse(fmt::format("no object {}{}", quote(near.id), name_hint(near.id, names, "objects")));
  }
  return near;
}

ScanCondition load_condition(const Value& value, ExpectedKind kind, const sim::World& world) {
  Table table(value);
  ScanCondition condition{.kind = kind};
  if (const auto near = table.take("near")) condition.near = load_near(*near, table, world);
  const auto at_least = table.take("at_least");
  const auto at_most = table.take("at_most");
  const auto recall = table.take("recall");
  const auto precision = table.take("precision");
  table.finish();
  if (at_least) condition.at_least = static_cast<int>(at_least->count(kCount));
  if (at_most) condition.at_most = static_cast<int>(at_most->count(kCount));
  if (recall) condition.recall = recall->number(kShare);
  if (precision) condition.precision = precision->number(kShare);
  if (condition.at_least > condition.at_most) at_most->refuse("is less than at_least");
  if (condition.near && (recall || precision)) value.refuse("near goes with at_least and at_most");
  if (condition.needs_scene() && (recall || precision)) {
    value.refuse(
        "recall and precision are of line, circle and leg; a scene's objects have at_least and at_most");
  }
  if (!at_least && !at_most && !recall && !precision) condition.at_least = 1;
  return condition;
}

constexpr ExpectedKind kExpectedKinds[] = {FeatureKind::kLine, FeatureKind::kCircle, FeatureKind::kLeg,
                                           SceneKind::kWall,   SceneKind::kCorner,   SceneKind::kColumn,
                                           SceneKind::kBench,  SceneKind::kDoor,     SceneKind::kTrashCan};

// "all", "some", or a share of them.
double load_share(const Value& value) {
  if (value.is("all")) return 1.0;
  if (value.is("some")) return 0.0;
  return value.number({.least = 0.0, .greatest = 1.0, .open = true});
}

Expectation load_expectation(const Value& value, const Scenario& scenario) {
  Table table(value);
  Expectation expectation;
  std::optional<Value> found;
  for (const ExpectedKind kind : kExpectedKinds) {
    const auto section = table.take(to_string(kind));
    if (!section) continue;
    if (found) section->refuse(fmt::format("a second kind beside '{}'", found->name()));
    found = section;
    expectation.condition = load_condition(*section, kind, scenario.world);
  }
  if (const auto between = table.take("between")) {
    expectation.window = load_window(*between, scenario.duration_s);
  }
  expectation.preset = take_preset(table);
  expectation.known_fail = take_known_fail(table);
  if (const auto scans = table.take("scans")) expectation.share = load_share(*scans);
  table.finish();
  if (!found)
    value.refuse("expects nothing; one of line, circle, leg, wall, corner, column, bench, door, trash_can");
  return expectation;
}

}  // namespace

std::optional<std::string> take_preset(Table& table) {
  const std::optional<Value> preset = table.take("preset");
  if (!preset) return std::nullopt;
  return preset_names()[preset->choice(preset_names())];
}

std::optional<std::string> take_known_fail(Table& table) {
  const std::optional<Value> reason = table.take("known_fail");
  return reason ? std::optional(reason->text()) : std::nullopt;
}

TimeWindow load_window(const Value& value, double duration_s) {
  const std::vector<Value> ends = value.items(2);
  const Allowed allowed{.least = 0.0, .greatest = duration_s};
  const TimeWindow window{ends[0].number(allowed), ends[1].number(allowed)};
  if (window.from_s >= window.to_s) ends[1].refuse("the window ends before it begins");
  return window;
}

void load_expect(const Value& value, Scenario& scenario) {
  for (const Value& item : value.items()) {
    scenario.expectations.push_back(load_expectation(item, scenario));
  }
}

}  // namespace scanbed::scenarios
