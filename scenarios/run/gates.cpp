// SPDX-License-Identifier: MIT
#include "scenarios/run/gates.hpp"

#include <stdexcept>

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

std::optional<double> measure_tracks(const TrackTally& tally, const Scores& scores, const Metric& metric) {
  switch (metric.measure) {
    case Measure::kMota:
      return tally.mota();
    case Measure::kMotp:
      return tally.motp_m();
    case Measure::kSwitchesPerMinute:
      return tally.switches_per_minute();
    case Measure::kIdf1:
      return tally.idf1();
    case Measure::kFalsePerScan:
      return scores.false_per_scan(tally);
    case Measure::kNumTruths:
      return tally.num_truths;
    case Measure::kPrecision:
    case Measure::kRecall:
    case Measure::kRecallInBand:
    case Measure::kRmsError:
      break;
  }
  return std::nullopt;
}

std::optional<double> measure_features(const KindScore& score, const Scores& scores, const Metric& metric) {
  const Tally& tally = score.tally;
  switch (metric.measure) {
    case Measure::kPrecision:
      return tally.num_detections == 0 ? std::nullopt : std::optional(tally.precision());
    case Measure::kRecall:
      return tally.num_truths == 0 ? std::nullopt : std::optional(tally.recall());
    case Measure::kRecallInBand:
      return recall_in_band(score, metric);
    case Measure::kFalsePerScan:
      return scores.false_per_scan(score);
    case Measure::kRmsError:
      return tally.num_right == 0 ? std::nullopt : std::optional(tally.rms_error_m());
    case Measure::kNumTruths:
      return tally.num_truths;
    case Measure::kMota:
    case Measure::kMotp:
    case Measure::kSwitchesPerMinute:
    case Measure::kIdf1:
      break;
  }
  return std::nullopt;
}

}  // namespace

const KindScore& score_of(const Scores& scores, FeatureKind kind) {
  switch (kind) {
    case FeatureKind::kLine:
      return scores.line;
    case FeatureKind::kCircle:
      return scores.circle;
    case FeatureKind::kLeg:
      return scores.leg;
    case FeatureKind::kPerson:
    case FeatureKind::kCylinder:
      break;
  }
  throw std::logic_error("followed over scans, not scored in each");
}

const std::optional<TrackTally>& tracks_of(const Scores& scores, FeatureKind kind) {
  return kind == FeatureKind::kPerson ? scores.person : scores.cylinder;
}

std::optional<double> measure(const Scores& scores, FeatureKind kind, const Metric& metric) {
  if (!is_followed(kind)) return measure_features(score_of(scores, kind), scores, metric);
  const std::optional<TrackTally>& tally = tracks_of(scores, kind);
  return tally ? measure_tracks(*tally, scores, metric) : std::nullopt;
}

bool is_met(const Need& need, double value) {
  return need.metric.at_most ? value <= need.bound : value >= need.bound;
}

GateResult evaluate(const Need& need, const Scores& scores) {
  const std::optional<double> value = measure(scores, need.kind, need.metric);
  return {need, value, value && is_met(need, *value)};
}

}  // namespace scanbed::scenarios
