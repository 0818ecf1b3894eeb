// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

namespace scanbed {

inline constexpr int kNoLeg = -1;

/// One way in which a track may explain legs of a scan: two of them, or one.
struct LegClaim {
  int track = 0;
  int first = kNoLeg;
  int second = kNoLeg;
  double gain = 0.0;  ///< > 0: by how much it is better than to leave these legs unexplained
};

/// Chooses at most one claim of each track, and no leg twice: the ways to do so with the largest sums of
/// gains. Exact branch and bound in each group of tracks that compete for legs. Keeps its storage, so that it
/// allocates nothing once it has seen its largest problem.
///
/// @par Source  The k best joint assignments of multiple hypothesis tracking: Cox & Hingorani, "An efficient
///              implementation of Reid's multiple hypothesis tracking algorithm", 1996. Departs: a track may
///              take two columns at once, so Murty's ranking gives way to a search, which stops at kMaxNodes
///              with the best so far.
class LegClaims {
 public:
  static constexpr int kMaxNodes = 1000;  ///< for each group

  /// A choice for all tracks.
  struct Answer {
    double gain = 0.0;
    std::vector<int> claim;  ///< of each track, index into the claims; kNoClaim where it has none
  };
  static constexpr int kNoClaim = -1;

  void reset(int num_tracks, int num_legs);

  /// Claims without gain are ignored. @pre indices are in range, first != second, gain is finite.
  void add(const LegClaim& claim);

  /// The best answers, the best one first: at most `max_answers` >= 1, none worse than the best by more than
  /// `max_loss` >= 0. There always is one. Valid until the next reset().
  std::span<const Answer> solve(int max_answers, double max_loss);

  /// What an answer gives a track; without legs where it gives none.
  LegClaim claim_of(const Answer& answer, int track) const;

 private:
  struct Range {
    int begin = 0, end = 0;
  };
  struct Sum {
    double gain = 0.0;
    int first = 0, second = 0;
  };
  /// Answers that keep their storage when there are fewer of them.
  struct Answers {
    std::vector<Answer> store;
    int size = 0;

    Answer& add(int num_tracks);
    std::span<const Answer> all() const { return std::span(store).first(size); }
  };

  void sort_claims();
  void group_tracks();
  int group_of(int track);
  void solve_group(std::span<const int> tracks);
  void branch(std::span<const int> tracks, std::size_t depth, double gain);
  void keep_answer(double gain);
  void join_group(std::span<const int> tracks);
  bool is_free(const LegClaim& claim) const;
  void mark(const LegClaim& claim, char taken);

  int num_tracks_ = 0;
  int max_answers_ = 1;
  double max_loss_ = 0.0;
  std::vector<LegClaim> claims_;  ///< in solve(): by track, the largest gain first
  std::vector<Range> range_;      ///< of each track in claims_
  std::vector<int> parent_;       ///< of each track, in its group's tree
  std::vector<int> claimant_;     ///< of each leg, one of them
  std::vector<int> order_;        ///< tracks that claim something, group by group
  std::vector<double> bound_;     ///< of the gain from a depth on
  std::vector<char> is_taken_;    ///< of each leg
  std::vector<int> pick_;         ///< of each track, on the branch
  double least_gain_ = 0.0;       ///< of an answer that is kept
  int num_nodes_ = 0;
  Answers of_group_, of_all_, joined_;
  std::vector<Sum> sums_;
};

}  // namespace scanbed
