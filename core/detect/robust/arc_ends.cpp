// SPDX-License-Identifier: MIT
#include "core/detect/robust/arc_ends.hpp"

#include <cmath>
#include <cstdlib>

namespace scanbed {
namespace {

constexpr int kMaxMixedBeams = 2;
// What the beams beyond an end see, against the range of that end.
constexpr double kNearer_m = 0.1;
constexpr double kFarther_m = 0.15;
constexpr double kSameSurface_m = 0.03;

// The direction of a beam so many steps from that of an echo.
Witness turned(const Echoes& echoes, int echo, int num_steps) {
  Witness beam{echoes.ux[echo], echoes.uy[echo]};
  const double cosine = echoes.step.x();
  const double sine = num_steps < 0 ? -echoes.step.y() : echoes.step.y();
  for (int i = std::abs(num_steps); i > 0; --i) {
    beam = {beam.ux * cosine - beam.uy * sine, beam.uy * cosine + beam.ux * sine};
  }
  return beam;
}

}  // namespace

ArcEnd arc_end_at(const LaserScan& scan, const Echoes& echoes, const std::vector<int>& order, Stretch surface,
                  int place, int direction) {
  const int echo = order[place];
  const double end_m = echoes.range_m[echo];
  const bool goes_on = place + direction >= surface.first && place + direction <= surface.last;
  for (int i = 1; i <= kMaxMixedBeams + 1; ++i) {
    const int beam = echoes.beam[echo] + i * direction;
    if (beam < 0 || beam >= scan.num_beams()) return {ArcEndKind::kHidden, {}};
    const double beyond_m = scan.range_m[beam] - end_m;
    if (beyond_m < -kNearer_m) return {ArcEndKind::kHidden, {}};
    if (beyond_m > kFarther_m) {
      return {ArcEndKind::kFree, turned(echoes, echo, i * direction)};
    }
    if (goes_on && i == 1 && std::abs(beyond_m) < kSameSurface_m) return {ArcEndKind::kAttached, {}};
  }
  return {goes_on ? ArcEndKind::kAttached : ArcEndKind::kHidden, {}};
}

}  // namespace scanbed
