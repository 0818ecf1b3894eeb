// SPDX-License-Identifier: MIT
#include "scenarios/run/gates.hpp"

namespace scanbed::scenarios {
namespace {

std::optional<double> recall_in_band(const KindScore& score, const Metric& metric) {
  int num_truths = 0;
  int num_found = 0;
  for (const RangeBand& band : score.bands) {
    if (band.from_m < metric.from_m || band.to_m > metric.to_m) continue;
    num_truths += band.num_truths;
    num_found += band.num_found;
  }
  if (num_truths == 0) return std::nullopt;
  return static_cast<double>(num_found) / num_truths;
}

}  // namespace

const KindScore& score_of(const Scores& scores, FeatureKind kind) {
  switch (kind) {
    case FeatureKind::kLine:
      return scores.line;
    case FeatureKind::kCircle:
      return scores.circle;
    case FeatureKind::kLeg:
      break;
  }
  return scores.leg;
}

std::optional<double> measure(const Scores& scores, FeatureKind kind, const Metric& metric) {
  const KindScore& score = score_of(scores, kind);
  const Tally& tally = score.tally;
  switch (metric.measure) {
    case Measure::kPrecision:
      return tally.num_detections == 0 ? std::nullopt : std::optional(tally.precision());
    case Measure::kRecall:
      return tally.num_truths == 0 ? std::nullopt : std::optional(tally.recall());
    case Measure::kRecallInBand:
      return recall_in_band(score, metric);
    case Measure::kFalsePerScan:
      return scores.num_scans == 0 ? std::nullopt : std::optional(scores.false_per_scan(score));
    case Measure::kRmsError:
      return tally.num_right == 0 ? std::nullopt : std::optional(tally.rms_error_m());
    case Measure::kNumTruths:
      return tally.num_truths;
  }
  return std::nullopt;
}

std::vector<GateResult> evaluate(std::span<const Need> needs, const Scores& scores) {
  std::vector<GateResult> results;
  for (const Need& need : needs) {
    const std::optional<double> value = measure(scores, need.kind, need.metric);
    const bool met = value && (need.metric.at_most ? *value <= need.bound : *value >= need.bound);
    results.push_back({need, value, met});
  }
  return results;
}

}  // namespace scanbed::scenarios
