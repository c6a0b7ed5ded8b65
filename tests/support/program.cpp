#include "support/program.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <stdexcept>
#include <thread>

namespace restframe {
namespace {

using Clock = std::chrono::steady_clock;

// Both ends are closed in programs that other threads start meanwhile.
class Pipe {
 public:
  Pipe() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int reader() const { return ends_[0]; }
  int writer() const { return ends_[1]; }
  void close_writer() { close_end(1); }

  // Takes what there is; returns false, and closes the reader, at the end of the stream.
  bool drain(std::string& text) {
    std::array<char, 65536> bytes;
    const ssize_t count = read(reader(), bytes.data(), bytes.size());
    if (count > 0) text.append(bytes.data(), static_cast<std::size_t>(count));
    if (count > 0 || (count < 0 && errno == EINTR)) return true;
    close_end(0);
    return false;
  }

 private:
  void close_end(std::size_t i) {
    if (ends_[i] >= 0) close(ends_[i]);
    ends_[i] = -1;
  }
  std::array<int, 2> ends_{-1, -1};
};

// In the child, between fork and exec: system calls only, since other threads' locks are copied as
// held.
[[noreturn]] void become(const char* program, char* const* arguments, char* const* environment,
                         const char* folder, const Pipe& out, const Pipe& error,
                         const RunOptions& options) {
  const auto limit = [](__rlimit_resource resource, const std::optional<std::uint64_t>& bytes) {
    const rlimit value{bytes.value_or(0), bytes.value_or(0)};
    if (bytes) setrlimit(resource, &value);
  };
  limit(RLIMIT_FSIZE, options.largest_file);
  limit(RLIMIT_AS, options.memory);
  if (options.largest_file) signal(SIGXFSZ, SIG_IGN);
  const int empty = open("/dev/null", O_RDONLY);
  dup2(empty, STDIN_FILENO);
  dup2(out.writer(), STDOUT_FILENO);
  dup2(error.writer(), STDERR_FILENO);
  if (*folder == '\0' || chdir(folder) == 0) execve(program, arguments, environment);
  _exit(127);
}

// This process's own, with the options' PATH.
std::vector<std::string> environment_of(const RunOptions& options) {
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    variables.emplace_back(*variable);
    if (options.path_variable && variables.back().rfind("PATH=", 0) == 0) variables.pop_back();
  }
  if (options.path_variable) variables.push_back("PATH=" + *options.path_variable);
  return variables;
}

std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

// Sends the options' signal when time is up, SIGKILL five seconds later.
class Deadline {
 public:
  Deadline(pid_t child, const RunOptions& options)
      : child_(child), signal_(options.signal), next_(Clock::now() + options.timeout) {}

  bool passed() const { return passed_; }
  void check() {
    if (Clock::now() < next_) return;
    kill(child_, passed_ ? SIGKILL : signal_);
    passed_ = true;
    next_ += std::chrono::seconds(5);
  }

 private:
  pid_t child_;
  int signal_;
  Clock::time_point next_;
  bool passed_ = false;
};

// Until the child has ended: it may close its outputs before, and leave them to processes of its
// own.
int wait_for(pid_t child, Pipe& out, Pipe& error, Deadline& deadline, RunResult& result) {
  int status = 0;
  bool ended = false;
  while (true) {
    std::array<pollfd, 2> streams = {pollfd{out.reader(), POLLIN, 0},
                                     pollfd{error.reader(), POLLIN, 0}};
    const int ready = poll(streams.data(), streams.size(), ended ? 0 : 5);
    if (ready > 0) {
      if (streams[0].revents) out.drain(result.out);
      if (streams[1].revents) error.drain(result.error);
    } else if (ended) {
      return status;
    }
    if (!ended) {
      ended = waitpid(child, &status, WNOHANG) == child;
      if (!ended) deadline.check();
    }
  }
}

}  // namespace

RunResult run_program(const std::filesystem::path& program,
                      const std::vector<std::string>& arguments, const RunOptions& options) {
  const std::string name = std::filesystem::absolute(program).string();
  const std::string folder = options.folder.string();
  std::vector<std::string> words = arguments;
  words.insert(words.begin(), name);
  std::vector<std::string> variables = environment_of(options);
  const std::vector<char*> argv = pointers_to(words);
  const std::vector<char*> environment = pointers_to(variables);

  Pipe out, error;
  const Clock::time_point start = Clock::now();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0)
    become(name.c_str(), argv.data(), environment.data(), folder.c_str(), out, error, options);
  out.close_writer();
  error.close_writer();

  RunResult result;
  Deadline deadline(child, options);
  const int status = wait_for(child, out, error, deadline, result);
  result.timed_out = deadline.passed();
  result.duration = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - start);
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  return result;
}

}  // namespace restframe
