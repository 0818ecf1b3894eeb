// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "bench/train_legs/leg_answers.hpp"

namespace scanbed::bench {

using LegSampleSink = std::function<void(const LegSample&)>;

/// Candidates of a recording with labelled legs, answered by the labels.
void sample_labelled(const std::filesystem::path& log, const std::filesystem::path& labels,
                     const LegSampleSink& use);

/// Candidates of a recording without people: none is a leg.
void sample_empty(const std::filesystem::path& log, const LegSampleSink& use);

/// Candidates of simulated worlds (leg_worlds.hpp), one scan each, numbered by their seeds, answered by the
/// truth.
void sample_simulated(std::uint64_t first_seed, int num_worlds, const LegSampleSink& use);

/// The same of random rooms and corridors with people who walk and stand (sim::random_world), two scans each.
void sample_random_worlds(std::uint64_t first_seed, int num_worlds, const LegSampleSink& use);

}  // namespace scanbed::bench
