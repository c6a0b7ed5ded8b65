#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/program.h"

namespace restframe {

// One line on standard error that begins with "error: " and holds every part.
inline void expect_error(const RunResult& result, int code, const std::vector<std::string>& parts) {
  EXPECT_EQ(result.exit_code, code) << result.error;
  EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
  EXPECT_EQ(result.error.rfind("error: ", 0), 0U) << result.error;
  for (const std::string& part : parts) EXPECT_THAT(result.error, testing::HasSubstr(part));
}

// As what the user got wrong.
inline void expect_refused(const RunResult& result, const std::vector<std::string>& parts) {
  expect_error(result, 2, parts);
}

}  // namespace restframe
