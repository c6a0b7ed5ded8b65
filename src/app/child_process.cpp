#include "app/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <system_error>
#include <thread>

#include "app/signals.h"
#include "scene/error.h"
#include "scene/message.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto patience = 20ms;  // between two looks at the child and at signals
constexpr auto grace = 200ms;    // from SIGTERM to SIGKILL

std::atomic<pid_t> running{0};

[[noreturn]] void fail_to_start(const fs::path& program, int error_number) {
  throw OutputError(program.string() +
                    ": can not be started: " + std::generic_category().message(error_number));
}

class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

using Log = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

std::string end_of(std::FILE* log, std::size_t kept) {
  std::fseek(log, 0, SEEK_END);
  const long size = std::ftell(log);
  std::string text(std::min(static_cast<std::size_t>(std::max(size, 0L)), kept), '\0');
  std::fseek(log, -static_cast<long>(text.size()), SEEK_END);
  text.resize(std::fread(text.data(), 1, text.size(), log));
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  return text;
}

// A program of ours, in a process group of its own, so that a signal reaches what it starts too.
class Child {
 public:
  Child(const fs::path& program, const std::vector<std::string>& arguments, int input, int output) {
    std::string name = program.string();
    std::vector<std::string> words = arguments;
    std::vector<char*> argv = {name.data()};
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);

    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, output, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t not_ignored;  // we ignore these, and it would inherit that
    sigemptyset(&not_ignored);
    sigaddset(&not_ignored, SIGPIPE);
    sigaddset(&not_ignored, SIGXFSZ);
    posix_spawnattr_setsigdefault(&attributes, &not_ignored);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    const int error = posix_spawn(&id_, name.c_str(), &files, &attributes, argv.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    if (error != 0) fail_to_start(program, error);
    running = id_;
  }
  ~Child() {
    if (!has_ended()) end();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  bool has_ended() {
    if (!ended_ && waitpid(id_, &status_, WNOHANG) == id_) set_ended();
    return ended_;
  }
  bool succeeded() const { return ended_ && WIFEXITED(status_) && WEXITSTATUS(status_) == 0; }

 private:
  void set_ended() {
    running = 0;
    ended_ = true;
  }
  void end() {
    kill(-id_, SIGTERM);
    const auto deadline = Clock::now() + grace;
    while (!has_ended() && Clock::now() < deadline) std::this_thread::sleep_for(patience);
    kill(-id_, SIGKILL);
    if (!ended_ && waitpid(id_, &status_, 0) == id_) set_ended();
  }

  pid_t id_ = -1;
  int status_ = 0;
  bool ended_ = false;
};

void look_at_signals() {
  if (interrupt_requested()) throw Interrupted();
}

// Returns false if the reader has gone.
bool feed(const std::string& piece, int to, Child& child) {
  for (std::size_t given = 0; given < piece.size();) {
    look_at_signals();
    const ssize_t count = ::write(to, piece.data() + given, piece.size() - given);
    if (count > 0) given += static_cast<std::size_t>(count);
    if (count >= 0 || errno == EINTR) continue;
    if (errno != EAGAIN || child.has_ended()) return false;
    pollfd writable{to, POLLOUT, 0};
    poll(&writable, 1, static_cast<int>(patience.count()));
  }
  return true;
}

}  // namespace

std::optional<fs::path> program_on_path(std::string_view name) {
  const char* variable = std::getenv("PATH");
  std::string_view folders = variable ? variable : "";
  while (!folders.empty()) {
    const std::size_t length = std::min(folders.find(':'), folders.size());
    const fs::path file = fs::path(folders.substr(0, length)) / name;
    std::error_code error;
    if (length > 0 && fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0) {
      return file;
    }
    folders.remove_prefix(std::min(length + 1, folders.size()));
  }
  return std::nullopt;
}

std::string words_of(const ChildResult& result) {
  if (result.last_lines.empty()) return "it said nothing";
  std::string text = result.last_lines;
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos;) {
    text.replace(at, 1, "; ");
  }
  return on_one_line(text);
}

ChildResult run_child(const fs::path& program, const std::vector<std::string>& arguments,
                      const NextInput& next_input, std::size_t kept) {
  const Log log(std::tmpfile(), std::fclose);
  std::array<int, 2> ends{-1, -1};
  if (!log || pipe2(ends.data(), O_CLOEXEC) != 0) fail_to_start(program, errno);
  Descriptor reader(ends[0]);
  Descriptor writer(ends[1]);
  Child child(program, arguments, reader.number(), fileno(log.get()));
  reader.close();
  fcntl(writer.number(), F_SETFL, O_NONBLOCK);

  bool taken = true;
  for (std::string piece = next_input(); taken && !piece.empty(); piece = next_input()) {
    taken = feed(piece, writer.number(), child);
  }
  writer.close();
  while (!child.has_ended()) {
    look_at_signals();
    std::this_thread::sleep_for(patience);
  }
  return {taken && child.succeeded(), end_of(log.get(), kept)};
}

void kill_running_child() {
  if (const pid_t child = running) kill(-child, SIGKILL);
}

}  // namespace restframe
