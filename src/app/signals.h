#pragma once

namespace restframe {

// From now on SIGINT and SIGTERM only raise a flag; what works long looks at it often.
void catch_signals();
bool interrupt_requested();

// Throws OutputError on a processor without the instructions that the program was compiled for.
void require_processor();

}  // namespace restframe
