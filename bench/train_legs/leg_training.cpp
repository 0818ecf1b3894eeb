// SPDX-License-Identifier: MIT
#include "bench/train_legs/leg_training.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>
#include <thread>
#include <utility>

#include "bench/train_legs/leg_calibration.hpp"
#include "core/detect/leg/keep_best_legs.hpp"
#include "core/detect/leg/leg_partners.hpp"
#include "scenarios/run/in_order.hpp"

namespace scanbed::bench {
namespace {

// A recorded candidate counts as much as so many simulated ones: few scans stand for all that is real. Less
// loses labelled legs, more loses simulated ones; `./dev results` shows both.
constexpr double kRecordedWeight = 130.0;
constexpr std::uint64_t kUnseenSeed = 1000001;
constexpr std::uint64_t kRandomSeed = 777000001;  // not those that scenarios and results ask for
constexpr std::uint64_t kUnseenRandomSeed = 778000001;

constexpr std::uint64_t kAloneSeed = 11;  // of the draws of boosting
constexpr std::uint64_t kTogetherSeed = 12;
constexpr int kNumTrees = 600;
constexpr int kNumAlone = 60;
constexpr double kTogetherRate = 0.15;  // slow, for many trees: what they learn depends less on their draws
constexpr std::array kCheckpoints = {60, 90, 150};
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
  LegForestScorer().score({.trees = trees}, table, {}, sums);
  return sums;
}

// Calls use(first, last) with the samples of each scan; those of one stand together.
template <typename Use>
void for_each_scan(std::span<const LegSample> samples, const Use& use) {
  for (std::size_t begin = 0; begin < samples.size();) {
    std::size_t end = begin;
    while (end < samples.size() && samples[end].scan == samples[begin].scan) ++end;
    use(begin, end);
    begin = end;
  }
}

// The samples with what they say of each other, as these trees judge each by itself.
std::vector<LegSample> with_partners(std::span<const LegTree> trees, std::vector<LegSample> samples) {
  const std::vector<float> sums = sums_of(trees, samples);
  LegPartnerReader reader;
  LegFeatureTable table;
  std::vector<LegPlace> places;
  for_each_scan(samples, [&](std::size_t begin, std::size_t end) {
    places.clear();
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector2f p_m = samples[i].center_m.cast<float>();
      places.push_back({samples[i].beams, p_m.x(), p_m.y()});
    }
    table.resize(static_cast<int>(places.size()));
    reader.read(places, std::span(sums).subspan(begin, places.size()), table);
    for (std::size_t i = begin; i < end; ++i) {
      for (int f = kNumOwnLegFeatures; f < kNumLegFeatures; ++f)
        samples[i].features[f] = table.at(f, static_cast<int>(i - begin));
    }
  });
  return samples;
}

// Sums of all the forest's trees.
std::vector<float> sums_of(const OwnedLegForest& forest, const std::vector<LegSample>& samples) {
  return sums_of(forest.trees, with_partners(std::span(forest.trees).first(forest.num_alone), samples));
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

void judge(const OwnedLegForest& forest, std::span<const LegSample> samples, std::vector<JudgedSum>& judged) {
  const std::vector<float> sums = sums_of(forest, {samples.begin(), samples.end()});
  for_each_scan(samples, [&](std::size_t begin, std::size_t end) {
    judge_scan(samples.subspan(begin, end - begin), std::span(sums).subspan(begin, end - begin), judged);
  });
}

// Bounds that give up next to nothing of what would be reported in the end.
void set_checkpoints(const LegCorpus& corpus, OwnedLegForest& forest) {
  std::vector<LegSample> likely;
  for (const auto* samples : {&corpus.pos1, &corpus.pos2, &corpus.nobody, &corpus.unseen}) {
    const auto told = with_partners(std::span(forest.trees).first(forest.num_alone), *samples);
    const std::vector<float> sums = sums_of(forest.trees, told);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      if (forest.view().probability(sums[i]) >= kLeastProbability) likely.push_back(told[i]);
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
  std::vector<LegSample> nobody;
  std::copy_if(corpus.nobody.begin(), corpus.nobody.end(), std::back_inserter(nobody),
               [&](const LegSample& s) { return nobody_part(corpus, s) != held_out.nobody_part; });
  OwnedLegForest forest;
  const auto learn = [&](const BoostingOptions& options) {
    const auto told = [&](const std::vector<LegSample>& samples) {
      return with_partners(forest.trees, samples);
    };
    LegTrainingRows rows;
    if (!held_out.pos1) add(told(corpus.pos1), kRecordedWeight, rows);
    if (!held_out.pos2) add(told(corpus.pos2), kRecordedWeight, rows);
    add(told(nobody), kRecordedWeight, rows);
    add(told(corpus.simulated), 1.0, rows);
    balance(rows);
    forest.trees = boost(rows, options, forest.trees);
  };
  learn({.num_trees = kNumAlone, .num_features = kNumOwnLegFeatures, .seed = kAloneSeed});
  learn({.num_trees = kNumTrees - kNumAlone, .rate = kTogetherRate, .seed = kTogetherSeed});
  forest.num_alone = kNumAlone;
  return forest;
}

std::vector<OwnedLegForest> train_legs(const LegCorpus& corpus, std::span<const HeldOut> held_out) {
  std::vector<OwnedLegForest> forests(held_out.size());
  const auto finish = [&](int number) {
    std::fprintf(stderr, "forest %d of %zu grown\n", number + 1, held_out.size());
    return true;
  };
  scenarios::do_in_order({.num_jobs = static_cast<int>(held_out.size()),
                          .num_workers = std::max(1, static_cast<int>(std::thread::hardware_concurrency())),
                          .work = [&](int i) { forests[i] = train_legs(corpus, held_out[i]); },
                          .finish = finish});
  return forests;
}

std::vector<HeldOut> held_out_in_turn() {
  std::vector<HeldOut> held_out;
  for (int part = 0; part < kNumNobodyParts; ++part) {
    for (const bool first : {true, false}) {
      held_out.push_back({.pos1 = first, .pos2 = !first, .nobody_part = part});
    }
  }
  return held_out;
}

OwnedLegForest train_detector(const LegCorpus& corpus) {
  std::vector<HeldOut> held_out = held_out_in_turn();
  held_out.push_back({});
  std::vector<OwnedLegForest> forests = train_legs(corpus, held_out);
  OwnedLegForest forest = std::move(forests.back());
  forests.pop_back();
  std::vector<JudgedSum> judged;
  for (std::size_t i = 0; i < forests.size(); ++i) {
    judge(forests[i], held_out[i].pos1 ? corpus.pos1 : corpus.pos2, judged);
    std::vector<LegSample> nobody;
    std::copy_if(corpus.nobody.begin(), corpus.nobody.end(), std::back_inserter(nobody),
                 [&](const LegSample& s) { return nobody_part(corpus, s) == held_out[i].nobody_part; });
    judge(forests[i], nobody, judged);
  }
  const Logistic logistic = fit_logistic(judged);
  forest.slope = logistic.slope;
  forest.offset = logistic.offset;
  set_checkpoints(corpus, forest);
  return forest;
}

}  // namespace scanbed::bench
