// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <vector>

#include "core/detect/leg/leg_beams.hpp"
#include "core/simd/instruction_set.hpp"

namespace scanbed {

/// A run of echoes, both ends included: indices into the echoes of LegBeams.
struct EchoRun {
  int first = 0;
  int last = 0;

  int size() const { return last - first + 1; }
  friend auto operator<=>(const EchoRun&, const EchoRun&) = default;
};

/// One way to cut a scan: its runs, and of each echo the run that holds it.
struct LegSegmentation {
  std::vector<EchoRun> runs;
  std::vector<double> width_m;  ///< of each run, from end to end
  std::vector<int> run_of_echo;

  const EchoRun& run_of(int echo) const { return runs[run_of_echo[echo]]; }
  double width_of(int echo) const { return width_m[run_of_echo[echo]]; }  ///< of the run that holds it
  bool has(const EchoRun& run) const { return run_of(run.first) == run; }
};

/// What may be a leg: runs of at least 2 echoes, at most 0.55 m wide and 6 m away, of which the middle one
/// lies in a run of the middle segmentation that is no wider than 0.55 m either: a wall's parts are no legs.
/// What a scan that goes beyond a turn shows twice is one candidate.
struct LegCandidates {
  static constexpr int kNumSegmentations = 3;

  std::array<LegSegmentation, kNumSegmentations> segmentations;  ///< from fine to coarse
  std::vector<EchoRun> runs;                                     ///< in rising order, each once
};

/// Cuts a scan into candidates, thrice: where neighbours lie farther apart than 0.04, 0.10 or 0.16 m plus 1.5
/// beam spacings; and what is 0.08 to 0.9 m wide once more, at its deepest notch and at its largest step of
/// range.
class LegCandidateFinder {
 public:
  explicit LegCandidateFinder(InstructionSet instructions = widest_instruction_set())
      : instructions_(instructions) {}

  void find(const LegBeams& beams, LegCandidates& candidates);

 private:
  /// Two neighbouring echoes that may not belong together.
  struct Gap {
    int after = 0;          ///< the echo behind the gap
    double excess_m = 0.0;  ///< distance beyond what the beam spacing allows for
  };

  /// The scan at hand, and what of it is joined to what.
  struct CutScan {
    const LegBeams& beams;
    const LegSegmentation& joined;
  };

  void find_gaps(const LegBeams& beams);
  void cut(const LegBeams& beams, double gap_m, LegSegmentation& segmentation) const;
  void find_in(const CutScan& scan, const EchoRun& run, double width_m);
  void halve(const CutScan& scan, const EchoRun& run);
  int deepest_notch(const LegBeams& beams, const EchoRun& run);
  void add(const CutScan& scan, const EchoRun& run);

  InstructionSet instructions_;
  std::vector<int> suspects_;  ///< echoes that may lie behind a gap, and room
  std::vector<Gap> gaps_;
  std::vector<EchoRun> found_;  ///< in one segmentation, and room
  std::vector<EchoRun> merged_;
  std::size_t num_found_ = 0;
  std::vector<double> nearest_after_m_;  ///< of each echo of a run: least range from there on
};

}  // namespace scanbed
