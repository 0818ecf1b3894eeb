// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/score/scorer.hpp"
#include "scenarios/load/scenario.hpp"
#include "scenarios/run/gates.hpp"
#include "scenarios/run/scan_condition.hpp"

namespace scanbed::scenarios {

/// How an expectation fared.
struct ExpectResult {
  Expectation expectation;
  int num_scans = 0;                     ///< of its window that could tell
  int num_held = 0;                      ///< of them
  std::optional<double> first_missed_s;  ///< time of the first scan in which the condition did not hold
  bool met = false;                      ///< never where no scan could tell
};

/// Watches a run scan by scan and says in the end what it reached: scores, needs, expectations.
class Judge {
 public:
  /// @param preset    of the detector: needs and expectations of another one are left out.
  Judge(const Scenario& scenario, std::string_view preset);

  void add(const DetectedScan& detected);

  /// Of the whole run; empty where no scan had truth.
  std::optional<Scores> scores() const;
  /// Of all needs, each over its window; empty where no scan had truth.
  std::vector<GateResult> gates() const;
  /// Of the expectations that this laser can be held to: without truth, of those that need none.
  std::vector<ExpectResult> expectations() const;

 private:
  MatchOptions match_;
  std::vector<Need> needs_;
  Scorer scorer_;
  std::vector<std::pair<TimeWindow, Scorer>> windows_;  // of needs, each window once
  std::vector<ExpectResult> expectations_;
};

}  // namespace scanbed::scenarios
