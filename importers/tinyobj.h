#pragma once

// tinyobjloader's header, free of the warnings that it has under this project's flags.

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wpedantic"
#include <tiny_obj_loader.h>
#pragma GCC diagnostic pop
