// SPDX-License-Identifier: MIT
#include "scenarios/report/score_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "scenarios/report/append_format.hpp"
#include "scenarios/report/share_text.hpp"

namespace scanbed::scenarios {
namespace {

constexpr std::array kKinds = {FeatureKind::kLine, FeatureKind::kCircle, FeatureKind::kLeg};

void append_head(std::string& out, const RunResult& result) {
  out += result.scenario;
  if (result.seed) append_format(out, "  seed {}", *result.seed);
  append_format(out, "  laser {}", result.laser);
  if (result.engine) append_format(out, "  engine {}", *result.engine);
  append_format(out, "  preset {}  {} scans", result.preset, result.num_scans);
  if (result.scores && result.scores->num_scans < result.num_scans) {
    append_format(out, ", {} of them scored: the others have no truth", result.scores->num_scans);
  }
  out += result.interrupted ? " (interrupted)\n" : "\n";
}

void append_tallies(std::string& out, const Scores& scores) {
  append_format(out, "\n  {:<8}{:>8}{:>8}{:>8}{:>12}{:>8}{:>11}{:>12}{:>11}\n", "kind", "truths", "found",
                "recall", "detections", "right", "precision", "false/scan", "rms error");
  for (const FeatureKind kind : kKinds) {
    const KindScore& score = score_of(scores, kind);
    const Tally& tally = score.tally;
    const std::string rms_error =
        tally.num_right == 0 ? "-" : fmt::format("{:.1f} mm", 1000.0 * tally.rms_error_m());
    append_format(out, "  {:<8}{:>8}{:>8}{:>8}{:>12}{:>8}{:>11}{:>12}{:>11}\n", to_string(kind),
                  tally.num_truths, tally.num_found, share_text(tally.num_found, tally.num_truths),
                  tally.num_detections, tally.num_right, share_text(tally.num_right, tally.num_detections),
                  value_text(scores.false_per_scan(score), 3), rms_error);
  }
}

void append_bands(std::string& out, const Scores& scores) {
  append_format(out, "\n  {:<8}", "recall");
  for (const RangeBand& band : scores.line.bands) {
    const bool is_last = &band == &scores.line.bands.back();
    append_format(
        out, "{:>15}",
        is_last ? fmt::format("{:g}+ m", band.from_m) : fmt::format("{:g}-{:g} m", band.from_m, band.to_m));
  }
  out += '\n';
  for (const FeatureKind kind : kKinds) {
    append_format(out, "  {:<8}", to_string(kind));
    for (const RangeBand& band : score_of(scores, kind).bands) {
      const std::string text =
          band.num_truths == 0
              ? "-"
              : fmt::format("{} of {}", share_text(band.num_found, band.num_truths), band.num_truths);
      append_format(out, "{:>15}", text);
    }
    out += '\n';
  }
}

void append_tracks(std::string& out, const Scores& scores) {
  if (!scores.person && !scores.cylinder) return;
  append_format(out, "\n  {:<10}{:>8}{:>8}{:>8}{:>10}{:>14}{:>8}{:>8}{:>12}\n", "followed", "truths", "found",
                "false", "switches", "switches/min", "MOTA", "IDF1", "mean error");
  for (const FeatureKind kind : {FeatureKind::kPerson, FeatureKind::kCylinder}) {
    const std::optional<TrackTally>& tally = tracks_of(scores, kind);
    if (!tally || (tally->num_truths == 0 && tally->num_false == 0)) continue;
    append_format(out, "  {:<10}{:>8}{:>8}{:>8}{:>10}{:>14}{:>8}{:>8}{:>12}\n", to_string(kind),
                  tally->num_truths, tally->num_matches, tally->num_false, tally->num_switches,
                  value_text(tally->switches_per_minute(), 2), value_text(tally->mota(), 3),
                  value_text(tally->idf1(), 3),
                  tally->motp_m() ? fmt::format("{:.1f} mm", 1000.0 * *tally->motp_m()) : "-");
  }
}

std::string_view outcome(bool met, const std::optional<std::string>& known_fail) {
  if (met) return "pass";
  return known_fail ? "miss" : "MISS";
}

std::string reason(const std::optional<std::string>& known_fail) {
  return known_fail ? "  known failure: " + *known_fail : "";
}

// As few digits as show on which side of the bar the value is.
std::string measured_text(const GateResult& gate) {
  if (!gate.value) return "nothing";
  if (*gate.value == std::round(*gate.value)) return fmt::format("{:.0f}", *gate.value);  // a count
  for (int num_digits = 4; num_digits < std::numeric_limits<double>::max_digits10; ++num_digits) {
    std::string text = fmt::format("{:.{}g}", *gate.value, num_digits);
    if (is_met(gate.need, std::stod(text)) == gate.met) return text;
  }
  return fmt::format("{}", *gate.value);
}

void append_gates(std::string& out, const std::vector<GateResult>& gates) {
  if (gates.empty()) return;
  append_format(out, "\n  {:<10}{:<24}{:>12}{:>12}\n", "gate", "", "bar", "measured");
  for (const GateResult& gate : gates) {
    const Need& need = gate.need;
    const std::string bar = fmt::format("{} {:g}", need.metric.at_most ? "<=" : ">=", need.bound);
    const std::string value = measured_text(gate);
    append_format(out, "  {:<10}{:<24}{:>12}{:>12}  {}{}{}\n", to_string(need.kind), need.metric.name, bar,
                  value, outcome(gate.met, need.known_fail),
                  need.window.is_whole() ? "" : "  " + to_string(need.window), reason(need.known_fail));
  }
}

void append_expectations(std::string& out, const std::vector<ExpectResult>& expectations) {
  if (expectations.empty()) return;
  out += "\n  expected\n";
  for (const ExpectResult& result : expectations) {
    const std::optional<std::string>& known_fail = result.expectation.known_fail;
    append_format(out, "  {}: held in {} of {}  {}", result.expectation.text(), result.num_held,
                  result.num_scans, outcome(result.met, known_fail));
    if (!result.met && result.first_missed_s) append_format(out, "  first at {:g} s", *result.first_missed_s);
    out += reason(known_fail) + '\n';
  }
}

void append_counts(std::string& out, const RunResult& result) {
  append_format(out, "\n  {} lines, {} circles, {} legs detected\n", result.features.lines,
                result.features.circles, result.features.legs);
  append_format(out, "  {}\n", kNotScored);
}

template <typename Results>
std::string met_of(const Results& results, std::string_view what) {
  const auto num_met =
      std::count_if(results.begin(), results.end(), [](const auto& result) { return result.met; });
  return fmt::format("{} of {} {}", num_met, results.size(), what);
}

void append_verdict(std::string& out, const RunResult& result) {
  if (result.gates.empty() && result.expectations.empty()) return;
  append_format(out, "\n{}: ", result.scenario);
  if (!result.gates.empty()) out += met_of(result.gates, "gates passed");
  if (!result.gates.empty() && !result.expectations.empty()) out += ", ";
  if (!result.expectations.empty()) out += met_of(result.expectations, "expectations held");
  if (result.known_fail) {
    out += result.met_its_gates() ? ", although it is a known failure: " : "; known failure: ";
    out += *result.known_fail;
  }
  out += '\n';
}

}  // namespace

std::string score_table(const RunResult& result) {
  std::string out;
  append_head(out, result);
  if (!result.scores) {
    append_counts(out, result);
    append_expectations(out, result.expectations);
    append_verdict(out, result);
    return out;
  }
  append_tallies(out, *result.scores);
  append_bands(out, *result.scores);
  append_tracks(out, *result.scores);
  append_gates(out, result.gates);
  append_expectations(out, result.expectations);
  append_verdict(out, result);
  return out;
}

}  // namespace scanbed::scenarios
