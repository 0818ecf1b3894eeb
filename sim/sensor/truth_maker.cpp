// SPDX-License-Identifier: MIT
#include "sim/sensor/truth_maker.hpp"

#include "core/scan/laser_scan.hpp"

namespace scanbed::sim {

TruthMaker::TruthMaker(const std::vector<SliceObject>& objects, int num_beams) {
  truth_.beams.resize(num_beams);
  rotation_of_beam_.resize(num_beams);
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
  num_rotations_ = 0;
}

void TruthMaker::add_rotation(const RayCaster& caster, const PlanarSlice& slice, const Pose2& X_LS,
                              double max_range_m) {
  const int rotation = num_rotations_++;
  if (static_cast<int>(places_.size()) < num_rotations_) places_.emplace_back();
  std::vector<Place>& places = places_[rotation];
  places.assign(truth_.objects.size(), {});
  const Pose2 X_SL = X_LS.inverse();
  for (const SliceSegment& s : slice.segments) places[s.object] = {X_SL * s.a_m, X_SL * s.b_m};
  for (const SliceDisc& d : slice.discs) places[d.object].a_m = X_SL * d.center_m;
  for (int i = 0; i < caster.num_beams(); ++i) {
    BeamTruth& beam = truth_.beams[caster.scan_beam(i)];
    beam = {};
    beam.range_m = kNoEcho;
    rotation_of_beam_[caster.scan_beam(i)] = rotation;
    if (caster.range_m(i) > max_range_m) continue;
    beam = {caster.object(i), caster.range_m(i), caster.incidence_rad(i), false};
  }
}

void TruthMaker::finish() {
  for (ObjectTruth& object : truth_.objects) object.num_clean_beams = 0;
  for (const BeamTruth& beam : truth_.beams) {
    if (beam.object != kNoObject) ++truth_.objects[beam.object].num_clean_beams;
  }
  // Beams are met in rising order, so the middle one is the one that half of them precede.
  middle_rotation_.assign(truth_.objects.size(), 0);
  num_seen_.assign(truth_.objects.size(), 0);
  for (std::size_t i = 0; i < truth_.beams.size(); ++i) {
    const int object = truth_.beams[i].object;
    if (object == kNoObject) continue;
    if (num_seen_[object]++ == truth_.objects[object].num_clean_beams / 2) {
      middle_rotation_[object] = rotation_of_beam_[i];
    }
  }
  for (std::size_t i = 0; i < truth_.objects.size(); ++i) {
    const Place& place = places_[middle_rotation_[i]][i];
    ObjectTruth& object = truth_.objects[i];
    const bool is_line = object.primitive == Primitive::kLine;
    (is_line ? object.from_m : object.center_m) = place.a_m;
    if (is_line) object.to_m = place.b_m;
  }
}

}  // namespace scanbed::sim
