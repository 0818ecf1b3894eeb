// SPDX-License-Identifier: MIT
#include "core/detect/robust/arc_ends.hpp"

#include <cmath>

namespace scanbed {
namespace {

constexpr int kMaxMixedBeams = 2;
// What the beams beyond an end see, against the range of that end.
constexpr double kNearer_m = 0.1;
constexpr double kFarther_m = 0.15;
constexpr double kSameSurface_m = 0.03;

}  // namespace

ArcEnd arc_end_at(const SurfacedScan& scan, Stretch surface, int place, int direction) {
  const Echoes& echoes = scan.echoes;
  const double end_m = echoes.range_m[place];
  const bool goes_on = place + direction >= surface.first && place + direction <= surface.last;
  for (int i = 1; i <= kMaxMixedBeams + 1; ++i) {
    const int beam = echoes.beam[place] + i * direction;
    if (beam < 0 || beam >= scan.scan.num_beams()) return {ArcEndKind::kHidden, {}};
    const double beyond_m = scan.scan.range_m[beam] - end_m;
    if (beyond_m < -kNearer_m) return {ArcEndKind::kHidden, {}};
    if (beyond_m > kFarther_m) {
      return {ArcEndKind::kFree, {echoes.directions.x(beam), echoes.directions.y(beam)}};
    }
    if (goes_on && i == 1 && std::abs(beyond_m) < kSameSurface_m) return {ArcEndKind::kAttached, {}};
  }
  return {goes_on ? ArcEndKind::kAttached : ArcEndKind::kHidden, {}};
}

}  // namespace scanbed
