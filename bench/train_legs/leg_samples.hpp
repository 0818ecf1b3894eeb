// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "core/detect/features.hpp"
#include "core/detect/leg/leg_features.hpp"
#include "core/scan/laser_scan.hpp"

namespace scanbed::bench {

enum class LegAnswer { kUnknown = -1, kNo = 0, kYes = 1 };

/// A candidate with its features and what it is.
struct LegSample {
  int scan = 0;
  BeamSpan beams;
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();  ///< centroid, sensor frame
  LegAnswer answer = LegAnswer::kUnknown;
  std::array<float, kNumLegFeatures> features{};
};

using LegSampleSink = std::function<void(const LegSample&)>;

/// Candidates of a recording with labelled legs. Within 0.10 m of a label it is a leg. People are labelled
/// within 15 degrees and 5 m only: there, what lies farther than 0.30 m from all labels is none, and all else
/// is unknown.
void sample_labelled(const std::filesystem::path& log, const std::filesystem::path& labels,
                     const LegSampleSink& use);

/// Candidates of a recording without people: none is a leg.
void sample_empty(const std::filesystem::path& log, const LegSampleSink& use);

/// Candidates of simulated worlds (leg_worlds.hpp), one scan each, numbered by their seeds. A leg if at least
/// 75 % of its echoes come from one leg and are at least 65 % of that leg's; none if fewer than 40 % come
/// from legs and fewer than 30 % from cylinders that might be legs.
void sample_simulated(std::uint64_t first_seed, int num_worlds, const LegSampleSink& use);

/// The same of random rooms and corridors with people who walk and stand (sim::random_world), two scans each.
void sample_random_worlds(std::uint64_t first_seed, int num_worlds, const LegSampleSink& use);

}  // namespace scanbed::bench
