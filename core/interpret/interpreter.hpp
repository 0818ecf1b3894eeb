// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/features.hpp"
#include "core/interpret/corners.hpp"
#include "core/interpret/interpret_options.hpp"
#include "core/interpret/round_groups.hpp"
#include "core/interpret/scene.hpp"
#include "core/interpret/wall_groups.hpp"
#include "core/scan/laser_scan.hpp"
#include "core/track/track.hpp"

namespace scanbed {

/// Reads features as architecture: walls, corners, doors, columns, benches, trash cans. Keeps its buffers.
///
/// @par Source  The paper, IV-B and V. Departs: its benches took in the pulled cylinder whenever that was at
/// a
///              bench's distance from another one; here what tracking has seen moving is no part of the
///              scene, and a bench is said only of feet that were seen to stand.
class Interpreter {
 public:
  /// @throws InputError where the options do not validate.
  explicit Interpreter(const InterpretOptions& options = {});

  /// Takes effect from the next scan on. @throws InputError where the options do not validate.
  void set_options(const InterpretOptions& options);

  /// @param features  of this scan.
  /// @param tracks    of this scan, as Tracker::update gives them: they say what moves. Without them nothing
  /// is known
  ///                  to stand, and no bench is found.
  /// @returns the scene, valid until the next call.
  const Scene& interpret(const LaserScan& scan, const Features& features, const std::vector<Track>& tracks);

 private:
  void judge_motions(const Features& features, const std::vector<Track>& tracks);

  InterpretOptions options_;
  WallGroups walls_;
  RoundGroups rounds_;
  std::vector<CircleMotion> motions_;  ///< of each circle
  Scene scene_;
};

}  // namespace scanbed
