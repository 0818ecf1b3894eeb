// SPDX-License-Identifier: MIT
#include "bench/results/held_out_legs.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "bench/results/labels.hpp"
#include "bench/results/recorded_results.hpp"
#include "bench/results/tracked_results.hpp"
#include "bench/train_legs/leg_training.hpp"

namespace scanbed::bench {
namespace {

constexpr double kRates[] = {0.3, 0.5, 1.0, 2.0};

/// A recording with people, and the forests trained without it, one for each part of nobody.log.
struct Trial {
  std::filesystem::path log;
  Labels labels;
  std::vector<OwnedLegForest> forests;
};

DetectorOptions detector_of(double min_score) {
  DetectorOptions options = robust_options();
  options.leg.min_score = min_score;
  return options;
}

// Scores of false legs, over all parts.
std::vector<double> false_scores(const std::filesystem::path& nobody, const Trial& trial, int num_scans) {
  std::vector<double> scores;
  for (int part = 0; part < kNumNobodyParts; ++part) {
    const LegForest forest = trial.forests[part].view();
    for (const ScoredLeg& leg : scored_legs(nobody, detector_of(0.0), forest)) {
      if (leg.scan * kNumNobodyParts / num_scans == part) scores.push_back(leg.score);
    }
  }
  std::sort(scores.rbegin(), scores.rend());
  return scores;
}

double recall_at(const Trial& trial, double min_score) {
  double recall = 0.0;
  for (const OwnedLegForest& forest : trial.forests) {
    const LegResult legs = legs_in_recording(trial.log, trial.labels, detector_of(min_score), forest.view());
    recall +=
        static_cast<double>(legs.num_found) / legs.num_labels / static_cast<double>(trial.forests.size());
  }
  return recall;
}

LegRate tracked_at(const std::filesystem::path& nobody, const Trial& trial, double track_score,
                   int num_scans) {
  TrackedSetup setup{robust_options(), {}};
  setup.tracker.min_score = track_score;
  LegRate rate;
  for (int part = 0; part < kNumNobodyParts; ++part) {
    const LegForest forest = trial.forests[part].view();
    const TrackedLegResult people = tracked_legs_in_recording(trial.log, trial.labels, setup, forest);
    rate.recall += static_cast<double>(people.num_found) / people.num_labels / kNumNobodyParts;
    const TrackedLegResult none = tracked_legs_in_recording(nobody, {}, setup, forest);
    for (std::size_t i = 0; i < none.num_tracks_of_scan.size(); ++i) {
      if (static_cast<int>(i) * kNumNobodyParts / num_scans == part) {
        rate.false_a_scan += static_cast<double>(none.num_tracks_of_scan[i]) / num_scans;
      }
    }
  }
  return rate;
}

// Legs that are reported by their scores: people, and what is false in one part of nobody.log, by the forest
// that saw neither.
ScoreBins score_bins(const std::filesystem::path& nobody, const Trial& trial, int part, int num_scans) {
  // Labels of fewer than 3 points need not be found, but who finds one is right.
  std::filesystem::path labels = trial.log;
  labels.replace_extension(".legs.jsonl");
  const LegForest forest = trial.forests[part].view();
  ScoreBins bins = binned_legs(trial.log, read_leg_labels(labels, 1), forest);
  const double min_score = robust_options().leg.min_score;
  for (const ScoredLeg& leg : scored_legs(nobody, detector_of(min_score), forest)) {
    if (leg.scan * kNumNobodyParts / num_scans == part) bins.add(leg.score, false);
  }
  return bins;
}

HeldOutLegs measure(const std::filesystem::path& nobody, const Trial& trial,
                    const std::vector<double>& track_scores) {
  const int num_scans = legs_in_recording(nobody, {}, robust_options(), trained_leg_forest()).num_scans;
  const std::vector<double> scores = false_scores(nobody, trial, num_scans);
  HeldOutLegs result{.num_empty_scans = num_scans};
  for (const double rate : kRates) {
    const auto allowed = static_cast<std::size_t>(rate * num_scans);
    // Just above the score that would be one too many.
    const double min_score = allowed < scores.size() ? std::nextafter(scores[allowed], 1.0) : 0.0;
    result.single_scan.push_back({rate, recall_at(trial, min_score)});
  }
  const double min_score = robust_options().leg.min_score;
  const auto num_false =
      std::count_if(scores.begin(), scores.end(), [&](double score) { return score >= min_score; });
  result.at_default = {static_cast<double>(num_false) / num_scans, recall_at(trial, min_score)};
  for (const double track_score : track_scores) {
    result.tracked.push_back(tracked_at(nobody, trial, track_score, num_scans));
  }
  return result;
}

}  // namespace

std::vector<HeldOutLegs> held_out_legs(const std::filesystem::path& data,
                                       const std::vector<double>& track_scores) {
  const LegCorpus corpus = read_leg_corpus(data);
  const std::vector<HeldOut> held_out = held_out_in_turn();
  std::vector<OwnedLegForest> forests = train_legs(corpus, held_out);
  // Calibration and early exit as in the detector's forest.
  for (OwnedLegForest& forest : forests) {
    forest.slope = trained_leg_forest().slope;
    forest.offset = trained_leg_forest().offset;
  }
  std::vector<HeldOutLegs> results;
  for (const bool first : {true, false}) {
    const std::string name = first ? "legs_pos1" : "legs_pos2";
    Trial trial{data / (name + ".log"), read_leg_labels(data / (name + ".legs.jsonl")), {}};
    for (std::size_t i = 0; i < forests.size(); ++i) {
      if (held_out[i].pos1 == first) trial.forests.push_back(forests[i]);
    }
    results.push_back(measure(data / "nobody.log", trial, track_scores));
    // Each part of nobody.log counts once over both recordings.
    const int num_scans = results.back().num_empty_scans;
    results.back().scores = score_bins(data / "nobody.log", trial, first ? 0 : 1, num_scans);
  }
  return results;
}

}  // namespace scanbed::bench
