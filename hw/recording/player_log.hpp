// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "hw/recording/byte_stream.hpp"
#include "hw/recording/scan_source.hpp"

namespace scanbed::hw {

/// A device's index has up to three digits.
inline constexpr int kMostPlayerLasers = 1000;

/// Which device of a Player log is read.
struct PlayerOptions {
  std::string only;  ///< "laser:1", or the name that the log gives it; empty reads all lasers
};

/// Scans of a text log of Player's writelog, plain or gzip: laser scans (1:1) and scans with pose (1:2, which
/// becomes the odometry). Source is the laser's name, where our own writer has left it, else empty for the
/// first laser and "laser:1", ... for others. A reading from max_range on is kNoEcho, 0 kTooClose, a negative
/// one and NaN kInvalid; angles, which have 4 digits, are evened out (see even_angles.hpp). A damaged line is
/// reported with its number and skipped.
std::unique_ptr<ScanSource> read_player_log(std::unique_ptr<ByteStream> bytes, std::string name,
                                            const PlayerOptions& options, DamageReport report);

}  // namespace scanbed::hw
