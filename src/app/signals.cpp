#include "app/signals.h"

#include <semaphore.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <string>
#include <thread>

#include "app/child_process.h"
#include "scene/error.h"
#include "scene/temporary_files.h"

namespace restframe {
namespace {

using namespace std::chrono_literals;

constexpr int exit_code = 130;
constexpr auto patience = 400ms;  // from a signal to the end by force

volatile std::sig_atomic_t interrupted = 0;
sem_t came;  // a semaphore is what a signal handler may raise

void on_signal(int) {
  interrupted = 1;
  sem_post(&came);
}

// Without the log and its locks: a thread may hold them. Once, whoever comes first.
void say_last_words() {
  static std::atomic<bool> said{false};
  if (said.exchange(true)) return;
  std::string line =
      "error: interrupted; finished pictures are kept, and the same command goes on from there\n";
  if (::isatty(STDERR_FILENO) != 0) line.insert(0, "\r\033[K");  // over the progress bar
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, line.data(), line.size());
}

void end_what_does_not_look() {
  while (sem_wait(&came) != 0) continue;
  std::this_thread::sleep_for(patience);
  kill_running_child();
  abandon_temporaries();
  say_last_words();
  ::_exit(exit_code);
}

}  // namespace

void catch_signals() {
  sem_init(&came, 0, 0);
  std::thread(end_what_does_not_look).detach();
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A reader that goes away (`restframe info scene | head`) is an error of writing, not a signal.
  std::signal(SIGPIPE, SIG_IGN);
  // A file over the shell's size limit likewise.
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupt_requested() {
  return interrupted != 0;
}

int report_interruption() {
  say_last_words();
  return exit_code;
}

void require_processor() {
#if defined(__x86_64__) && defined(__AVX2__)
  __builtin_cpu_init();
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
    throw OutputError(
        "this processor lacks AVX2; build restframe with -DRESTFRAME_ARCH=x86-64 for it");
  }
#endif
}

}  // namespace restframe
