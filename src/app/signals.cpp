#include "app/signals.h"

#include <csignal>

#include "scene/error.h"

namespace restframe {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void on_signal(int) {
  interrupted = 1;
}

}  // namespace

void catch_signals() {
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
