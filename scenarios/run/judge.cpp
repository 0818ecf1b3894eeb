// SPDX-License-Identifier: MIT
#include "scenarios/run/judge.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace scanbed::scenarios {
namespace {

bool is_met(const ExpectResult& result) {
  if (result.num_scans == 0) return false;
  const double share = result.expectation.share;
  if (share == 0.0) return result.num_held > 0;
  // Shares such as 0.9 have no exact binary form: 9 of 10 must do.
  return result.num_held >= share * result.num_scans - 1e-9 * result.num_scans;
}

void count(const DetectedScan& detected, const MatchOptions& match, ExpectResult& result) {
  const double time_s = detected.scan.time_s;
  if (!result.expectation.window.contains(time_s)) return;
  const std::optional<bool> held = holds(result.expectation.condition, detected, match);
  if (!held) return;
  ++result.num_scans;
  result.num_held += *held ? 1 : 0;
  if (!*held && !result.first_missed_s) result.first_missed_s = time_s;
}

void score(const DetectedScan& detected, Scorer& scorer) {
  scorer.add(detected.features, detected.scan, *detected.truth);
  if (detected.tracks != nullptr) scorer.add_tracks(*detected.tracks, detected.scan, *detected.truth);
}

}  // namespace

Judge::Judge(const Scenario& scenario, std::string_view preset)
    : match_(scenario.match), scorer_(scenario.match) {
  const auto is_of_preset = [&](const auto& bar) { return !bar.preset || *bar.preset == preset; };
  std::copy_if(scenario.needs.begin(), scenario.needs.end(), std::back_inserter(needs_), is_of_preset);
  for (const Need& need : needs_) {
    const auto is_same = [&](const auto& window) { return window.first == need.window; };
    if (need.window.is_whole() || std::any_of(windows_.begin(), windows_.end(), is_same)) continue;
    windows_.emplace_back(need.window, Scorer(scenario.match));
  }
  for (const Expectation& expectation : scenario.expectations) {
    if (!is_of_preset(expectation)) continue;
    expectations_.push_back({.expectation = expectation, .first_missed_s = std::nullopt});
  }
}

void Judge::add(const DetectedScan& detected) {
  if (detected.truth != nullptr) {
    score(detected, scorer_);
    for (auto& [window, scorer] : windows_) {
      if (window.contains(detected.scan.time_s)) score(detected, scorer);
    }
  }
  for (ExpectResult& result : expectations_) count(detected, match_, result);
}

std::optional<Scores> Judge::scores() const {
  Scores scores = scorer_.scores();
  if (scores.num_scans == 0) return std::nullopt;
  return scores;
}

std::vector<GateResult> Judge::gates() const {
  std::vector<GateResult> gates;
  const std::optional<Scores> whole = scores();
  if (!whole) return gates;
  std::vector<std::pair<TimeWindow, Scores>> parts;
  for (const auto& [window, scorer] : windows_) parts.emplace_back(window, scorer.scores());
  for (const Need& need : needs_) {
    const auto part = std::find_if(parts.begin(), parts.end(),
                                   [&](const auto& candidate) { return candidate.first == need.window; });
    gates.push_back(evaluate(need, part == parts.end() ? *whole : part->second));
  }
  return gates;
}

std::vector<ExpectResult> Judge::expectations() const {
  std::vector<ExpectResult> results;
  const bool has_truth = scores().has_value();
  for (const ExpectResult& result : expectations_) {
    if (!has_truth && result.expectation.condition.needs_truth()) continue;
    results.push_back(result);
    results.back().met = is_met(result);
  }
  return results;
}

}  // namespace scanbed::scenarios
