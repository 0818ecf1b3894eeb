// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/scan/laser_scan.hpp"

namespace scanbed::hw {

/// How a CARMEN log is read.
struct CarmenLogOptions {
  std::string only;  ///< read this message alone ("FLASER", "RAWLASER2", ...); empty reads all laser messages
  /// Readings from here on mean "no return". Empty: from the LMS's codes on (reading_limit.hpp), but for
  /// messages whose own maximum range lies beyond these.
  std::optional<double> no_return_m;
  bool is_guess = false;  ///< nothing says that it is a CARMEN log at all; for messages

  void validate() const;  ///< @throws InputError naming the first field that is not allowed
};

/// Whether a message of this name carries a scan.
bool is_carmen_message(std::string_view name);

/// Where the beams of an FLASER or RLASER of so many readings point; see parse_carmen_line.
ScanGeometry guess_carmen_geometry(int num_beams);

/// What a line of a CARMEN log turned out to be.
struct CarmenLine {
  enum class Kind {
    kBlank,
    kOther,    ///< a comment, or a message that carries no scan or none that was asked for
    kScan,     ///< a scan
    kDamaged,  ///< meant to be a scan, or anything else with zero bytes in it
  };
  Kind kind = Kind::kBlank;
  bool has_time = false;  ///< of a scan: whether the line says when it was taken
  std::string damage;     ///< of a damaged line: what is wrong with it
};

/// Reads one line, without its end, of a CARMEN log.
///
/// `FLASER` and `RLASER` say how many readings there are, but not where they point. As CARMEN does, a SICK
/// LMS is assumed: 180 or 181 readings are 1 degree apart and 360 or 361 half a degree, from -90 degrees on
/// (of 180 and 360 the last beam was left out); 400 or 401 are a quarter of a degree apart, from -50 degrees
/// on; any other number spreads evenly over -90..90 degrees. `RAWLASERn` and `ROBOTLASERn` say it themselves.
///
/// The time is the message's own (ipc_timestamp). A message may lack the tail "ipc_timestamp host
/// logger_timestamp"; a `ROBOTLASERn` that has it may lack the remissions and the turn axis, as in older
/// logs.
///
/// Readings (metres) become as REP 117 has it: from `no_return_m` or the message's own maximum range on, and
/// "inf", kNoEcho; 0 and "-inf" kTooClose; less than 0 and "nan" kInvalid.
///
/// @param options  validated by the caller.
/// @param scan  where the line holds a scan: its time (left alone where the line has none), geometry, ranges,
///              odometry X_OR (where the message has it and it is finite) and source, the message's name. Not
///              its index. Where the line holds none: unspecified; its storage is used.
/// @par Source  The header of CARMEN's own logs, carmen.sourceforge.net/logger_playback.html. Departs: CARMEN
/// lets
///              scans of 400 readings start at -90 degrees, but the LMS's 100 degree field is centred on 0.
CarmenLine parse_carmen_line(std::string_view line, const CarmenLogOptions& options, LaserScan& scan);

}  // namespace scanbed::hw
