// SPDX-License-Identifier: MIT
#include "scenarios/report/video_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>
#include <vector>

#include "core/errors/ensure.hpp"
#include "scenarios/run/output.hpp"

namespace scanbed::scenarios {
namespace {

// A palette made for the film keeps the colours of features apart; libx264 wants even sizes.
constexpr const char* kGifFilter = "split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=none";
constexpr const char* kMp4Filter = "pad=ceil(iw/2)*2:ceil(ih/2)*2";

std::vector<std::string> arguments(const VideoOptions& options, const std::string& file) {
  std::vector<std::string> words = {"ffmpeg",    "-y",
                                    "-loglevel", "error",
                                    "-f",        "rawvideo",
                                    "-pix_fmt",  "rgb24",
                                    "-s",        fmt::format("{}x{}", options.width_px, options.height_px),
                                    "-r",        fmt::format("{}", options.frames_per_s),
                                    "-i",        "-"};
  const bool is_gif = options.format == VideoFormat::kGif;
  for (const char* word : {"-vf", is_gif ? kGifFilter : kMp4Filter}) words.emplace_back(word);
  if (is_gif) {
    for (const char* word : {"-f", "gif"}) words.emplace_back(word);
  } else {
    for (const char* word :
         {"-c:v", "libx264", "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f", "mp4"}) {
      words.emplace_back(word);
    }
  }
  words.push_back(file);
  return words;
}

// The child must not hold our end of the pipe, or it would never see the end of the film.
pid_t spawn(std::vector<std::string> words, int child_end) {
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, child_end, STDIN_FILENO);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t process = -1;
  const int error = ::posix_spawnp(&process, argv[0], &actions, nullptr, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT) {
    throw OutputFault("ffmpeg: not found; install Debian's package ffmpeg, or write a PNG with -o");
  }
  if (error != 0) throw OutputFault(fmt::format("ffmpeg: cannot be started: {}", std::strerror(error)));
  return process;
}

}  // namespace

VideoFile::VideoFile(const std::filesystem::path& path, const VideoOptions& options)
    : file_(path, hw::NewFile::Unfinished::kRemoved), options_(options) {
  // A socket in place of a pipe: writing to it can be told to raise no SIGPIPE.
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw OutputFault(fmt::format("ffmpeg: no pipe to it: {}", std::strerror(errno)));
  }
  try {
    process_ = spawn(arguments(options_, file_.growing().string()), ends[1]);
  } catch (...) {
    ::close(ends[0]);
    ::close(ends[1]);
    throw;
  }
  ::close(ends[1]);
  pipe_ = ends[0];
}

VideoFile::~VideoFile() {
  if (pipe_ >= 0) ::close(pipe_);
  if (process_ < 0) return;
  ::kill(process_, SIGTERM);
  wait();
}

void VideoFile::fail() const {
  throw OutputFault(fmt::format("{}: ffmpeg could not write it", file_.path().string()));
}

void VideoFile::write(const sim::Image& image) {
  SCANBED_ENSURE(image.width_px == options_.width_px && image.height_px == options_.height_px);
  std::size_t written = 0;
  while (written < image.rgb.size()) {
    const ssize_t count = ::send(pipe_, image.rgb.data() + written, image.rgb.size() - written, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail();
    written += static_cast<std::size_t>(count);
  }
}

int VideoFile::wait() {
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return status;
}

void VideoFile::finish() {
  ::close(std::exchange(pipe_, -1));
  const int status = wait();
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) fail();
  file_.finish();
}

}  // namespace scanbed::scenarios
