#pragma once

// Files in the making: hidden ones, ".restframe-HOST-PROCESS-NUMBER.tmp", beside those that they will
// become. Whoever makes one holds a lock (flock) on it, so that what a killed process left can be told
// from what another one is writing.

#include <filesystem>

namespace restframe {

struct TemporaryFile {
  std::filesystem::path path;
  int descriptor = -1;  // open for writing and locked; the owner closes it
};

// A new, empty one. A negative descriptor: it could not be made, and errno says why.
TemporaryFile create_temporary(const std::filesystem::path& folder);

// Gives it its final name, in one step; returns whether that worked, else errno says why.
bool publish_temporary(const std::filesystem::path& temporary, const std::filesystem::path& path);

void remove_temporary(const std::filesystem::path& temporary);

// Removes those of this process, and lets no file be made or named from now on: whoever tries waits for
// ever. For a process that is about to end while its threads are at work.
void abandon_temporaries();

// Removes what killed processes left in a folder. What another machine left goes after an hour: some
// networks do not carry locks.
void remove_orphans(const std::filesystem::path& folder);

}  // namespace restframe
