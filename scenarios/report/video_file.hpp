// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

#include "hw/recording/new_file.hpp"
#include "sim/render/scene_picture.hpp"

namespace scanbed::scenarios {

enum class VideoFormat { kGif, kMp4 };

struct VideoOptions {
  VideoFormat format = VideoFormat::kMp4;
  int width_px = 960;
  int height_px = 720;
  double frames_per_s = 5.0;
};

/// A film, written by a child process ffmpeg that takes the pictures from a pipe. It appears under its name
/// only when it is complete (see hw::NewFile).
class VideoFile {
 public:
  /// @throws OutputFault where the file cannot be made, or ffmpeg cannot be started: it says which package
  ///         has it.
  VideoFile(const std::filesystem::path& path, const VideoOptions& options);

  /// Without finish(): ends ffmpeg, and removes what it wrote.
  ~VideoFile();
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  /// @pre the image has the size of the options. @throws OutputFault where ffmpeg gave up.
  void write(const sim::Image& image);

  /// Waits for ffmpeg and gives the file its name. @throws OutputFault where ffmpeg failed.
  void finish();

 private:
  [[noreturn]] void fail() const;
  int wait();

  hw::NewFile file_;
  VideoOptions options_;
  int pipe_ = -1;
  pid_t process_ = -1;
};

}  // namespace scanbed::scenarios
