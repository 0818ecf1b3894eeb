// SPDX-License-Identifier: MIT
#include "core/detect/robust/line_pieces.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "core/simd/double_lanes.hpp"

namespace scanbed {
namespace {

constexpr int kNumCuts = RayLineSums::kNumCuts;

// Of some neighbouring cuts, as many before the place as behind it: a corner may be on either piece.
int first_cut_near(int place, Stretch all_cuts) {
  return std::max(all_cuts.first, std::min(place - kNumCuts / 2, all_cuts.last + 1 - kNumCuts));
}

/// The chord between the ends of a stretch.
class EchoChord {
 public:
  static constexpr int kNumSamples = 8;

  EchoChord(const Echoes& echoes, Stretch places)
      : x_m_(echoes.x_m.data()),
        y_m_(echoes.y_m.data()),
        last_(places.last),
        along_x_m_(both_lanes(x_m_[places.last] - x_m_[places.first])),
        along_y_m_(both_lanes(y_m_[places.last] - y_m_[places.first])),
        offset_m2_(along_x_m_ * y_m_[places.first] - along_y_m_ * x_m_[places.first]) {}

  /// The farthest of some places, kNumSamples from the first on in steps.
  int farthest(int first, int step) const {
    const auto place_of = [&](int sample) { return std::min(first + sample * step, last_); };
    Doubles sample{0.0, 1.0};
    Doubles best{};
    Doubles most = both_lanes(-1.0);
    for (int i = 0; i < kNumSamples; i += 2) {
      const int a = place_of(i);
      const int b = place_of(i + 1);
      const Doubles off_m2 =
          along_x_m_ * Doubles{y_m_[a], y_m_[b]} - along_y_m_ * Doubles{x_m_[a], x_m_[b]} - offset_m2_;
      const Doubles off_m4 = off_m2 * off_m2;
      const auto is_farther = off_m4 > most;
      best = is_farther ? sample : best;
      most = is_farther ? off_m4 : most;
      sample += 2.0;
    }
    best = swapped(most) > most ? swapped(best) : best;
    return place_of(static_cast<int>(best[0]));
  }

 private:
  const double* x_m_;
  const double* y_m_;
  int last_;
  Doubles along_x_m_;
  Doubles along_y_m_;
  Doubles offset_m2_;
};

}  // namespace

void LineSplitter::begin(const Echoes& echoes, const RayLineSums& sums, const SurfaceOptions& options) {
  echoes_ = &echoes;
  sums_ = &sums;
  options_ = &options;
  // There is room for all that one scan may ask for. One more, as a part is written before it is known
  // whether it counts.
  const std::size_t room = echoes.size() + 1;
  if (parts_.size() < room) {
    parts_.resize(room);
    to_cut_.resize(room);
    cutting_.resize(room);
    first_cuts_.resize(room);
    cuts_.resize(room);
    pairs_.resize(room);
  }
  num_to_cut_ = 0;
}

void LineSplitter::add(Stretch surface) {
  add_part(surface, sums_->chi2_of(surface));
}

void LineSplitter::add_part(Stretch places, double chi2) {
  parts_[places.first] = {places.last, chi2};
  // On a wall chi squared is expected + 4 sqrt(expected) + 4 at most: some three sigma. Said without the
  // root.
  const double expected = places.size() - 2;
  const double excess = chi2 - expected - 4.0;
  const bool is_line = (places.size() <= 3) | (excess * std::max(excess, 0.0) < 16.0 * expected);
  to_cut_[num_to_cut_] = places;
  num_to_cut_ += is_line ? 0 : 1;
}

void LineSplitter::split() {
  while (num_to_cut_ > 0) cut_all();
}

// In three rounds, so that what is sought for one part need not wait for another.
void LineSplitter::cut_all() {
  const int num_parts = num_to_cut_;
  std::swap(cutting_, to_cut_);
  for (int i = 0; i < num_parts; ++i) first_cuts_[i] = first_cut_of(cutting_[i]);
  sums_->best_cuts(std::span(cutting_).first(num_parts), first_cuts_, cuts_);
  num_to_cut_ = 0;
  for (int i = 0; i < num_parts; ++i) {
    const Stretch places = cutting_[i];
    climb(places, first_cuts_[i], cuts_[i]);
    const RayLineSums::Cut& cut = cuts_[i];
    add_part({places.first, cut.place}, cut.chi2_before);
    add_part({cut.place + 1, places.last}, cut.chi2_after);
  }
}

int LineSplitter::first_cut_of(Stretch places) const {
  const Stretch all{places.first, places.last - 1};
  return all.size() > kNumCuts ? first_cut_near(far_from_chord(places), all) : all.first;
}

// Of a few samples the farthest, then around it in smaller steps.
int LineSplitter::far_from_chord(Stretch places) const {
  constexpr int kHalf = EchoChord::kNumSamples / 2;
  const EchoChord chord(*echoes_, places);
  int step = places.size() / EchoChord::kNumSamples;
  int place = chord.farthest(places.first + step / 2, step);
  while (step > kNumCuts) {
    step /= kHalf;
    place = chord.farthest(std::max(places.first, place - kHalf * step), step);
  }
  return place;
}

// Where the best is at an end of what was compared, a better one may follow.
void LineSplitter::climb(Stretch places, int first_cut, RayLineSums::Cut& best) const {
  const Stretch all{places.first, places.last - 1};
  while (((best.place == first_cut) & (first_cut > all.first)) |
         ((best.place == first_cut + kNumCuts - 1) & (best.place < all.last))) {
    first_cut = first_cut_near(best.place, all);
    const RayLineSums::Cut next = sums_->best_cut(places, first_cut);
    if (!(next.chi2() < best.chi2())) return;
    best = next;
  }
}

void LineSplitter::append_pieces(Stretch surface, std::vector<LinePiece>& pieces) {
  const std::size_t first_piece = pieces.size();
  for (int place = surface.first; place <= surface.last; place = parts_[place].last + 1) {
    const Stretch places{place, parts_[place].last};
    const double chi2 = parts_[place].chi2;
    pieces.push_back({places, chi2, cost_of(places, chi2)});
  }
  while (merge_once(first_piece, pieces)) {
  }
}

// For all at once, so that it does not matter from which side they are read.
void LineSplitter::settle_cuts(std::span<LinePiece> pieces) {
  const std::size_t num_cuts = pieces.empty() ? 0 : pieces.size() - 1;
  for (std::size_t i = 0; i < num_cuts; ++i) {
    const auto& [a, b] = std::tie(pieces[i], pieces[i + 1]);
    cuts_[i] = {a.places.last, a.chi2, b.chi2};
    if (a.is_taken || b.is_taken || std::min(a.places.size(), b.places.size()) < kNumCuts) continue;
    const Stretch both{a.places.first, b.places.last};
    const RayLineSums::Cut cut = sums_->best_cut(both, a.places.last - kNumCuts / 2);
    if (cut.chi2() < a.chi2 + b.chi2) cuts_[i] = cut;
  }
  for (std::size_t i = 0; i < num_cuts; ++i) {
    if (cuts_[i].place == pieces[i].places.last) continue;
    pieces[i].places.last = cuts_[i].place;
    pieces[i + 1].places.first = cuts_[i].place + 1;
    for (LinePiece* piece : {&pieces[i], &pieces[i + 1]}) {
      piece->chi2 = sums_->chi2_of(piece->places);
      piece->cost = cost_of(piece->places, piece->chi2);
    }
  }
}

double LineSplitter::cost_of(Stretch places, double chi2) const {
  const double as_clutter = options_->clutter_price * places.size();
  return places.size() < 2 ? as_clutter : std::min(as_clutter, options_->line_price + chi2);
}

// Neighbours that one line explains at no more cost become one piece, where neither would rather go with its
// other neighbour: so it does not matter from which side they are read.
bool LineSplitter::merge_once(std::size_t first_piece, std::vector<LinePiece>& pieces) {
  const int num_pieces = static_cast<int>(pieces.size() - first_piece);
  if (num_pieces < 2) return false;
  LinePiece* const piece = pieces.data() + first_piece;
  if (!compare_pairs({piece, static_cast<std::size_t>(num_pieces)})) return false;
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  const auto gain_of = [&](int pair) {
    return pair + 1 < num_pieces ? piece[pair].cost + piece[pair + 1].cost - pairs_[pair].cost : kNone;
  };
  // The pieces that stay move to the front.
  int num_kept = 0;
  double gain_before = kNone;
  double gain = gain_of(0);
  for (int i = 0; i < num_pieces; ++i) {
    const double gain_behind = gain_of(i + 1);
    const bool merges = gain >= 0.0 && gain >= gain_before && gain >= gain_behind;
    piece[num_kept++] = merges ? pairs_[i] : piece[i];
    gain_before = gain;
    gain = gain_behind;
    if (!merges) continue;
    ++i;
    gain_before = gain;
    gain = gain_of(i + 1);
  }
  pieces.resize(first_piece + num_kept);
  return true;
}

bool LineSplitter::compare_pairs(std::span<const LinePiece> pieces) {
  const std::size_t num_pairs = pieces.size() - 1;
  int num_worth = 0;
  for (std::size_t i = 0; i < num_pairs; ++i) {
    const Stretch places{pieces[i].places.first, pieces[i + 1].places.last};
    const double chi2 = sums_->chi2_of(places);
    pairs_[i] = {places, chi2, cost_of(places, chi2)};
    num_worth += pairs_[i].cost <= pieces[i].cost + pieces[i + 1].cost ? 1 : 0;
  }
  return num_worth > 0;
}

}  // namespace scanbed
