#include "app/messages.h"

#include <fmt/format.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "scene/error.h"
#include "scene/message.h"

namespace restframe {
namespace {

spdlog::logger& log() {
  static const std::shared_ptr<spdlog::logger> logger = [] {
    auto made = spdlog::stderr_logger_mt("restframe");
    made->set_pattern("%l: %v");
    return made;
  }();
  return *logger;
}

}  // namespace

void report_error(const std::string& message) {
  log().error("{}", on_one_line(message));
}
void report_warning(const std::string& message) {
  log().warn("{}", on_one_line(message));
}

void report_faults(const std::vector<std::string>& faults) {
  const std::string more =
      faults.size() > 1
          ? fmt::format(" (and {} more: `restframe check` lists them)", faults.size() - 1)
          : "";
  report_error(faults.front() + more);
}

void close_standard_output() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  throw OutputError("standard output: " + std::generic_category().message(errno));
}

}  // namespace restframe
