// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/interpret/scene.hpp"
#include "scenarios/load/need.hpp"

namespace scanbed::scenarios {

/// Features near one true object, wherever it is in a scan, seen or not.
struct NearObject {
  std::string id;         ///< of an object, or of a thing of several: a walker's legs, a bench's feet
  double within_m = 0.0;  ///< between the feature and the object: centres, or the nearest point of a line,
                          ///< wall, bench or door
};

/// Features, or what interpretation makes of them.
using ExpectedKind = std::variant<FeatureKind, SceneKind>;

std::string_view to_string(ExpectedKind kind);

/// What one scan must show. Conditions that are left out hold.
struct ScanCondition {
  ExpectedKind kind = FeatureKind::kLine;
  std::optional<NearObject> near;  ///< only features near it count
  int at_least = 0;                ///< features, or objects of the scene
  int at_most = std::numeric_limits<int>::max();
  std::optional<double> recall;  ///< of this scan alone, at least; scans with nothing to find do not count
  std::optional<double>
      precision;  ///< of this scan alone, at least; scans with nothing detected do not count

  /// Whether it cannot be told from what was detected alone.
  bool needs_truth() const { return near || recall || precision; }
  bool needs_scene() const { return std::holds_alternative<SceneKind>(kind); }
};

/// A condition that must hold in the scans of a time window.
struct Expectation {
  ScanCondition condition;
  TimeWindow window;
  double share = 1.0;                      ///< of the window's scans in which it must hold; 0: in one of them
  std::optional<std::string> preset = {};  ///< of the detector that is held to it; empty: any
  std::optional<std::string> known_fail = {};  ///< why it is not met yet; a miss is then reported only

  /// "circle, at least 1 within 0.2 m of cyl, in all scans of 5 to 12 s".
  std::string text() const;
};

}  // namespace scanbed::scenarios
