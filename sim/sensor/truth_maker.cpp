// SPDX-License-Identifier: MIT
#include "sim/sensor/truth_maker.hpp"

#include <algorithm>
#include <cmath>

#include "core/scan/laser_scan.hpp"

namespace scanbed::sim {
namespace {

// std::acos to within 2.2e-8, as a polynomial that many beams at once can share (Abramowitz & Stegun,
// "Handbook of Mathematical Functions", 1964, eq. 4.4.46).
double incidence_rad(double cosine) {
  const double x = std::min(cosine, 1.0);
  const double even = -0.0012624911 * x + 0.0066700901;
  const double series =
      1.5707963050 +
      x * (-0.2145988016 +
           x * (0.0889789874 + x * (-0.0501743046 + x * (0.0308918810 + x * (-0.0170881256 + x * even)))));
  return std::sqrt(1.0 - x) * series;
}

}  // namespace

TruthMaker::TruthMaker(const std::vector<SliceObject>& objects, int num_beams) {
  truth_.beams.resize(num_beams);
  piece_of_beam_.resize(num_beams);
  for (const SliceObject& object : objects) {
    ObjectTruth& truth = truth_.objects.emplace_back();
    truth.id = object.id;
    truth.label = object.label;
    truth.primitive = object.primitive;
    truth.radius_m = object.radius_m;
  }
}

void TruthMaker::begin(const Pose2& X_WS) {
  truth_.X_WS = X_WS;
  num_pieces_ = 0;
}

void TruthMaker::add_piece(BeamSubset beams, const PlanarSlice& slice, const Pose2& X_LS) {
  const int piece = num_pieces_++;
  if (static_cast<int>(places_.size()) < num_pieces_) {
    places_.emplace_back();
    X_SL_.emplace_back();
  }
  const Pose2 X_SL = X_LS.inverse();
  X_SL_[piece] = {X_SL.p_m, X_SL.heading()};
  std::vector<Place>& places = places_[piece];
  places.assign(truth_.objects.size(), {});
  for (const SliceSegment& s : slice.segments) places[s.object] = {s.a_m, s.b_m, true};
  for (const SliceDisc& d : slice.discs) places[d.object] = {d.center_m, Eigen::Vector2d::Zero(), true};
  for (const SliceArc& a : slice.arcs) places[a.object] = {a.center_m, Eigen::Vector2d::Zero(), true};
  const int num_beams = static_cast<int>(piece_of_beam_.size());
  for (int i = 0, beam = beams.first; i < beams.count && beam < num_beams; ++i, beam += beams.stride) {
    piece_of_beam_[beam] = piece;
  }
}

void TruthMaker::take_beams(const IdealReturns& returns, double max_range_m) {
  for (std::size_t i = 0; i < truth_.beams.size(); ++i) {
    const bool is_seen = returns.object[i] != kNoObject && returns.range_m[i] <= max_range_m;
    BeamTruth& beam = truth_.beams[i];
    beam.object = is_seen ? returns.object[i] : kNoObject;
    beam.range_m = is_seen ? returns.range_m[i] : kNoEcho;
    beam.incidence_rad = is_seen ? incidence_rad(returns.cos_incidence[i]) : 0.0;
    beam.mixed = false;
  }
  for (const SplitSpot& spot : returns.split_spots) truth_.beams[spot.beam].mixed = true;
}

// Beams are met in rising order, so the middle one is the one that half of them precede.
void TruthMaker::find_middle_pieces() {
  middle_piece_.assign(truth_.objects.size(), 0);
  num_seen_.assign(truth_.objects.size(), 0);
  for (std::size_t i = 0; i < truth_.beams.size(); ++i) {
    const BeamTruth& beam = truth_.beams[i];
    if (beam.object == kNoObject || beam.mixed) continue;
    if (num_seen_[beam.object]++ == truth_.objects[beam.object].num_clean_beams / 2) {
      middle_piece_[beam.object] = piece_of_beam_[i];
    }
  }
}

void TruthMaker::finish(const IdealReturns& returns, double max_range_m) {
  take_beams(returns, max_range_m);
  for (ObjectTruth& object : truth_.objects) object.num_clean_beams = 0;
  for (const BeamTruth& beam : truth_.beams) {
    if (beam.object != kNoObject && !beam.mixed) ++truth_.objects[beam.object].num_clean_beams;
  }
  find_middle_pieces();
  for (std::size_t i = 0; i < truth_.objects.size(); ++i) {
    const int piece = middle_piece_[i];
    const Place& place = places_[piece][i];
    ObjectTruth& object = truth_.objects[i];
    const bool is_line = object.primitive == Primitive::kLine;
    const Eigen::Vector2d nowhere = Eigen::Vector2d::Zero();
    (is_line ? object.from_m : object.center_m) = place.is_cut ? X_SL_[piece] * place.a_m : nowhere;
    if (is_line) object.to_m = place.is_cut ? X_SL_[piece] * place.b_m : nowhere;
  }
}

}  // namespace scanbed::sim
