// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace scanbed::hw {

/// How a chunk of a recording is packed: one whole bzip2 stream, LZ4 frame or Zstandard frame.
enum class Packing { kNone, kBzip2, kLz4, kZstd };

/// No chunk unpacks to more: what says so is damaged or wants to fill the memory.
inline constexpr std::uint64_t kMostUnpacked = std::uint64_t{256} << 20;

/// "none" and "" (nothing), "bz2", "lz4", "zstd"; nothing for other names.
std::optional<Packing> packing_of_name(std::string_view name);

/// Unpacks to exactly `num_bytes`. Memory grows with what is really there, not with what is claimed.
/// @throws InputError "lz4 data is damaged", "... unpacks to more than the 12 bytes it claims", "... claims
/// to
///         unpack to 4294967295 bytes, more than 268435456".
std::string unpack_chunk(std::string_view packed, Packing packing, std::uint64_t num_bytes);

/// One LZ4 frame: independent blocks of 1 MiB, checksum of the content, its size not given. That is the one
/// kind that rosbag accepts.
std::string pack_lz4(std::string_view bytes);

}  // namespace scanbed::hw
