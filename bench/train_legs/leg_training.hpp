// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "bench/train_legs/leg_boosting.hpp"
#include "bench/train_legs/leg_samples.hpp"
#include "core/detect/leg/leg_forest.hpp"

namespace scanbed::bench {

/// All candidates to learn from. Recordings calibrate, too: how frequent legs are in simulated worlds says
/// nothing about other places.
struct LegCorpus {
  std::vector<LegSample> pos1, pos2;  ///< people in an unchanging place
  std::vector<LegSample> nobody;      ///< a drive past furniture
  std::vector<LegSample> simulated;
  std::vector<LegSample> unseen;  ///< simulated too; says what may be given up early
};

inline constexpr int kNumTrainingWorlds = 12000;
inline constexpr int kNumRandomWorlds = 30000;
inline constexpr int kNumUnseenWorlds = 400;
inline constexpr int kNumUnseenRandomWorlds = 160;

/// @param recordings  folder of legs_pos1.log and the others.
LegCorpus read_leg_corpus(const std::filesystem::path& recordings);

/// What a forest must not learn from.
struct HeldOut {
  bool pos1 = false;
  bool pos2 = false;
  int nobody_part = -1;  ///< of kNumNobodyParts stretches of time; -1: learns from all
};

inline constexpr int kNumNobodyParts = 2;

/// Each recording with people, with each part of the one without: who sees neither can be asked about both.
std::vector<HeldOut> held_out_in_turn();

/// Which stretch of the recording a candidate of `nobody` belongs to.
int nobody_part(const LegCorpus& corpus, const LegSample& sample);

/// A forest with the storage of its parts.
struct OwnedLegForest {
  std::vector<LegTree> trees;
  std::vector<LegForest::Checkpoint> checkpoints;
  int num_alone = 0;
  double slope = 1.0;
  double offset = 0.0;

  LegForest view() const { return {trees, checkpoints, num_alone, slope, offset}; }
};

/// Trains a forest on all that is not held out; always the same for the same corpus. Uncalibrated and without
/// checkpoints.
OwnedLegForest train_legs(const LegCorpus& corpus, const HeldOut& held_out);

/// The same for each of them, several at a time.
std::vector<OwnedLegForest> train_legs(const LegCorpus& corpus, std::span<const HeldOut> held_out);

/// The forest of the detector: trained on everything, calibrated by forests that had not seen what they were
/// asked.
OwnedLegForest train_detector(const LegCorpus& corpus);

}  // namespace scanbed::bench
