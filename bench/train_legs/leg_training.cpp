// SPDX-License-Identifier: MIT
#include "bench/train_legs/leg_training.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "bench/train_legs/leg_calibration.hpp"
#include "core/detect/leg/keep_best_legs.hpp"

namespace scanbed::bench {
namespace {

// A recorded candidate counts as much as so many simulated ones: few scans stand for all that is real. Half
// as much loses one labelled leg in thirty, twice as much one simulated leg in ten.
constexpr double kRecordedWeight = 40.0;
constexpr std::uint64_t kUnseenSeed = 1000001;
constexpr std::uint64_t kRandomSeed = 777000001;  // not those that scenarios and results ask for
constexpr std::uint64_t kUnseenRandomSeed = 778000001;

constexpr std::array kCheckpoints = {30, 100};
constexpr double kLeastProbability = 0.05;  // what ends below may be given up early
constexpr double kLostShare = 0.002;        // of what ends above
constexpr float kMargin = 0.3F;             // log-odds

std::vector<LegSample> gather(const std::function<void(const LegSampleSink&)>& source) {
  std::vector<LegSample> samples;
  source([&](const LegSample& sample) { samples.push_back(sample); });
  return samples;
}

void add(const std::vector<LegSample>& samples, double weight, LegTrainingRows& rows) {
  for (const LegSample& sample : samples) {
    if (sample.answer == LegAnswer::kUnknown) continue;
    rows.add(sample.features, sample.answer == LegAnswer::kYes, weight);
  }
}

// Legs and others shall weigh the same.
void balance(LegTrainingRows& rows) {
  double legs = 0.0;
  double others = 0.0;
  for (int i = 0; i < rows.size(); ++i) (rows.is_leg[i] != 0 ? legs : others) += rows.weight[i];
  for (int i = 0; i < rows.size(); ++i) {
    if (rows.is_leg[i] != 0) rows.weight[i] *= others / legs;
  }
}

// Sums of the first trees, of all samples.
std::vector<float> sums_of(std::span<const LegTree> trees, std::span<const LegSample> samples) {
  LegFeatureTable table;
  table.resize(static_cast<int>(samples.size()));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (int f = 0; f < kNumLegFeatures; ++f) table.at(f, static_cast<int>(i)) = samples[i].features[f];
  }
  std::vector<float> sums;
  LegForestScorer().score({.trees = trees}, table, sums);
  return sums;
}

// What non-maximum suppression leaves of one scan's candidates.
void judge_scan(std::span<const LegSample> samples, std::span<const float> sums,
                std::vector<JudgedSum>& judged) {
  std::vector<Leg> legs;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    legs.push_back({samples[i].beams, samples[i].center_m, sums[i]});
  }
  keep_best_legs(legs);
  for (const Leg& leg : legs) {
    const auto sample = std::find_if(samples.begin(), samples.end(), [&](const LegSample& s) {
      return s.beams.first == leg.beams.first && s.beams.last == leg.beams.last;
    });
    if (sample->answer == LegAnswer::kUnknown) continue;
    judged.push_back({leg.score, sample->answer == LegAnswer::kYes});
  }
}

void judge(std::span<const LegTree> trees, std::span<const LegSample> samples,
           std::vector<JudgedSum>& judged) {
  const std::vector<float> sums = sums_of(trees, samples);
  for (std::size_t begin = 0; begin < samples.size();) {
    std::size_t end = begin;
    while (end < samples.size() && samples[end].scan == samples[begin].scan) ++end;
    judge_scan(samples.subspan(begin, end - begin), std::span(sums).subspan(begin, end - begin), judged);
    begin = end;
  }
}

// Bounds that give up next to nothing of what would be reported in the end.
void set_checkpoints(const LegCorpus& corpus, OwnedLegForest& forest) {
  std::vector<LegSample> likely;
  for (const auto* samples : {&corpus.pos1, &corpus.pos2, &corpus.nobody, &corpus.unseen}) {
    const std::vector<float> sums = sums_of(forest.trees, *samples);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      if (forest.view().probability(sums[i]) >= kLeastProbability) likely.push_back((*samples)[i]);
    }
  }
  for (const int count : kCheckpoints) {
    const std::vector<float> sums = sums_of(std::span(forest.trees).first(count), likely);
    forest.checkpoints.push_back({count, bound_that_loses(kLostShare, sums) - kMargin});
  }
}

}  // namespace

LegCorpus read_leg_corpus(const std::filesystem::path& recordings) {
  const auto labelled = [&](const std::string& name) {
    return gather([&](const LegSampleSink& use) {
      sample_labelled(recordings / (name + ".log"), recordings / (name + ".legs.jsonl"), use);
    });
  };
  LegCorpus corpus;
  corpus.pos1 = labelled("legs_pos1");
  corpus.pos2 = labelled("legs_pos2");
  corpus.nobody = gather([&](const LegSampleSink& use) { sample_empty(recordings / "nobody.log", use); });
  corpus.simulated = gather([](const LegSampleSink& use) {
    sample_simulated(1, kNumTrainingWorlds, use);
    sample_random_worlds(kRandomSeed, kNumRandomWorlds, use);
  });
  corpus.unseen = gather([](const LegSampleSink& use) {
    sample_simulated(kUnseenSeed, kNumUnseenWorlds, use);
    sample_random_worlds(kUnseenRandomSeed, kNumUnseenRandomWorlds, use);
  });
  return corpus;
}

int nobody_part(const LegCorpus& corpus, const LegSample& sample) {
  return sample.scan * kNumNobodyParts / (corpus.nobody.back().scan + 1);
}

OwnedLegForest train_legs(const LegCorpus& corpus, const HeldOut& held_out) {
  LegTrainingRows rows;
  if (!held_out.pos1) add(corpus.pos1, kRecordedWeight, rows);
  if (!held_out.pos2) add(corpus.pos2, kRecordedWeight, rows);
  std::vector<LegSample> nobody;
  std::copy_if(corpus.nobody.begin(), corpus.nobody.end(), std::back_inserter(nobody),
               [&](const LegSample& s) { return nobody_part(corpus, s) != held_out.nobody_part; });
  add(nobody, kRecordedWeight, rows);
  add(corpus.simulated, 1.0, rows);
  balance(rows);
  return {.trees = boost(rows, {})};
}

OwnedLegForest train_detector(const LegCorpus& corpus) {
  std::vector<JudgedSum> judged;
  for (int part = 0; part < kNumNobodyParts; ++part) {
    for (const bool first : {true, false}) {
      const auto trees = train_legs(corpus, {.pos1 = first, .pos2 = !first, .nobody_part = part}).trees;
      judge(trees, first ? corpus.pos1 : corpus.pos2, judged);
      std::vector<LegSample> nobody;
      std::copy_if(corpus.nobody.begin(), corpus.nobody.end(), std::back_inserter(nobody),
                   [&](const LegSample& s) { return nobody_part(corpus, s) == part; });
      judge(trees, nobody, judged);
      judge(trees, corpus.unseen, judged);
    }
  }
  OwnedLegForest forest = train_legs(corpus, {});
  const Logistic logistic = fit_logistic(judged);
  forest.slope = logistic.slope;
  forest.offset = logistic.offset;
  set_checkpoints(corpus, forest);
  return forest;
}

}  // namespace scanbed::bench
