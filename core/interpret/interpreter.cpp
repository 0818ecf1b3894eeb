// SPDX-License-Identifier: MIT
#include "core/interpret/interpreter.hpp"

#include <algorithm>

#include "core/track/leg_circle.hpp"

namespace scanbed {
namespace {

const InterpretOptions& validated(const InterpretOptions& options) {
  options.validate();
  return options;
}

}  // namespace

Interpreter::Interpreter(const InterpretOptions& options) : options_(validated(options)) {}

void Interpreter::set_options(const InterpretOptions& options) {
  options_ = validated(options);
}

const Scene& Interpreter::interpret(const LaserScan& scan, const Features& features,
                                    const std::vector<Track>& tracks) {
  scene_.clear();
  walls_.find(scan, features.lines, options_, scene_);
  find_corners(features.lines, scan, options_, scene_);
  judge_motions(features, tracks);
  rounds_.find({scan, features.circles, motions_}, options_, scene_);
  return scene_;
}

void Interpreter::judge_motions(const Features& features, const std::vector<Track>& tracks) {
  motions_.clear();
  for (const Circle& circle : features.circles) {
    motions_.push_back(is_leg_too(circle, features.legs) ? CircleMotion::kMobile : CircleMotion::kUnknown);
  }
  for (const Track& track : tracks) {
    if (track.kind != TrackKind::kCylinder || track.feature < 0 ||
        track.feature >= static_cast<int>(motions_.size())) {
      continue;
    }
    if (track.is_settled) motions_[track.feature] = CircleMotion::kSettled;
    if (track.is_mobile) motions_[track.feature] = CircleMotion::kMobile;
  }
}

}  // namespace scanbed
