// SPDX-License-Identifier: MIT
#pragma once

#include "core/detect/detector_options.hpp"
#include "core/interpret/interpret_options.hpp"
#include "core/track/track_options.hpp"

namespace scanbed {

/// All that detection, interpretation and tracking can be told.
struct AnalysisOptions {
  DetectorOptions detector;
  InterpretOptions interpret;
  TrackOptions track;
  void validate() const;  ///< @throws InputError naming the first field out of range
};

}  // namespace scanbed
