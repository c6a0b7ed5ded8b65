#pragma once

namespace restframe {

// From now on SIGINT and SIGTERM raise a flag, which whatever works long looks at often: it throws
// Interrupted. What can not look (reading an asset, building Embree's scenes, encoding a picture) is cut
// off after most of a second: files in the making are removed and the process ends with exit code 130.
void catch_signals();
bool interrupt_requested();

// The program's last line and exit code after Interrupted.
int report_interruption();

// Throws OutputError on a processor without the instructions that the program was compiled for.
void require_processor();

}  // namespace restframe
