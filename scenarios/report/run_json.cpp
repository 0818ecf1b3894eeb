// SPDX-License-Identifier: MIT
#include "scenarios/report/run_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "scenarios/report/version.hpp"

namespace scanbed::scenarios {
namespace {

using Json = nlohmann::ordered_json;

Json rounded(double value) {
  if (!std::isfinite(value)) return nullptr;
  return std::round(value * 1e9) / 1e9 + 0.0;
}

Json rounded(const std::optional<double>& value) {
  return value ? rounded(*value) : Json(nullptr);
}

Json share(int part, int whole) {
  return whole == 0 ? Json(nullptr) : rounded(static_cast<double>(part) / whole);
}

Json to_json(const RangeBand& band) {
  return {{"from_m", rounded(band.from_m)},
          {"to_m", rounded(band.to_m)},
          {"truths", band.num_truths},
          {"found", band.num_found},
          {"recall", share(band.num_found, band.num_truths)}};
}

Json to_json(const KindScore& score, const Scores& scores) {
  const Tally& tally = score.tally;
  Json bands = Json::array();
  for (const RangeBand& band : score.bands) bands.push_back(to_json(band));
  return {{"truths", tally.num_truths},
          {"found", tally.num_found},
          {"recall", share(tally.num_found, tally.num_truths)},
          {"detections", tally.num_detections},
          {"right", tally.num_right},
          {"neither", tally.num_neither},
          {"precision", share(tally.num_right, tally.num_detections)},
          {"false_per_scan", rounded(scores.false_per_scan(score))},
          {"rms_error_m", tally.num_right == 0 ? Json(nullptr) : rounded(tally.rms_error_m())},
          {"bands", bands}};
}

Json to_json(const std::optional<TrackTally>& tally, const Scores& scores) {
  if (!tally) return nullptr;
  return {{"truths", tally->num_truths},
          {"found", tally->num_matches},
          {"false", tally->num_false},
          {"false_per_scan", rounded(scores.false_per_scan(*tally))},
          {"neither", tally->num_neither},
          {"id_switches", tally->num_switches},
          {"id_switches_per_minute", rounded(tally->switches_per_minute())},
          {"mota", rounded(tally->mota())},
          {"motp_m", rounded(tally->motp_m())},
          {"idf1", rounded(tally->idf1())}};
}

Json to_json(const Scores& scores) {
  return {{"person", to_json(scores.person, scores)},
          {"cylinder", to_json(scores.cylinder, scores)},
          {"line", to_json(scores.line, scores)},
          {"circle", to_json(scores.circle, scores)},
          {"leg", to_json(scores.leg, scores)}};
}

Json to_json(const std::optional<std::string>& text) {
  return text ? Json(*text) : Json(nullptr);
}

Json to_json(const GateResult& gate) {
  const TimeWindow& window = gate.need.window;
  Json json = {{"kind", to_string(gate.need.kind)},
               {"metric", gate.need.metric.name},
               {gate.need.metric.at_most ? "at_most" : "at_least", rounded(gate.need.bound)},
               {"value", rounded(gate.value)},
               {"met", gate.met}};
  json["known_fail"] = to_json(gate.need.known_fail);
  if (!window.is_whole()) json["between_s"] = {rounded(window.from_s), rounded(window.to_s)};
  return json;
}

Json to_json(const ExpectResult& result) {
  const TimeWindow& window = result.expectation.window;
  return {
      {"expected", result.expectation.text()},
      {"kind", to_string(result.expectation.condition.kind)},
      {"between_s", window.is_whole() ? Json(nullptr) : Json{rounded(window.from_s), rounded(window.to_s)}},
      {"scans", result.num_scans},
      {"held", result.num_held},
      {"first_missed_s", rounded(result.first_missed_s)},
      {"met", result.met},
      {"known_fail", to_json(result.expectation.known_fail)}};
}

// Whether there was anything to hold the run against, and how that ended.
Json verdict(const RunResult& result) {
  const bool is_measured = result.scores || !result.expectations.empty();
  return is_measured ? Json(result.met_its_gates()) : Json(nullptr);
}

Json to_json(const sim::Collision& collision) {
  return {{"time_s", rounded(collision.time_s)}, {"ids", {collision.first, collision.second}}};
}

Json to_json(const RunResult& result) {
  Json gates = Json::array();
  for (const GateResult& gate : result.gates) gates.push_back(to_json(gate));
  Json expectations = Json::array();
  for (const ExpectResult& expectation : result.expectations) expectations.push_back(to_json(expectation));
  Json collisions = Json::array();
  for (const sim::Collision& collision : result.collisions) collisions.push_back(to_json(collision));
  return {
      {"scenario", result.scenario},
      {"seed", result.seed ? Json(*result.seed) : Json(nullptr)},
      {"laser", result.laser},
      {"engine", to_json(result.engine)},
      {"preset", result.preset},
      {"duration_s", rounded(result.duration_s)},
      {"scans", result.num_scans},
      {"scored_scans", result.scores ? result.scores->num_scans : 0},
      {"interrupted", result.interrupted},
      {"features",
       {{"line", result.features.lines}, {"circle", result.features.circles}, {"leg", result.features.legs}}},
      {"scores", result.scores ? to_json(*result.scores) : Json(nullptr)},
      {"gates", gates},
      {"expectations", expectations},
      {"collisions", collisions},
      {"gates_met", verdict(result)},
      {"unexpected_pass", result.passed_unexpectedly()},
      {"accepted", result.is_accepted()},
      {"known_fail", to_json(result.known_fail)}};
}

}  // namespace

std::string run_json(std::span<const RunResult> results) {
  Json runs = Json::array();
  for (const RunResult& result : results) runs.push_back(to_json(result));
  const Json document = {{"scanbed", kVersion}, {"runs", runs}};
  // Names from outside may hold bytes that are no UTF-8; they are replaced rather than refused.
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace scanbed::scenarios
