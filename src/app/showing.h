#pragma once

#include <filesystem>
#include <vector>

#include "app/job.h"

namespace restframe {

// What `restframe render` makes of an animation's previews: a film, a contact sheet.
struct Show {
  const RenderOptions& options;
  std::vector<std::filesystem::path> previews;  // of all pictures of this call, in order
  std::filesystem::path encoder;                // where ffmpeg is, for a film
};

inline bool wants_show(const RenderOptions& options) {
  return options.video || options.contact_sheet;
}

// Finds out before hours of rendering what would fail after them: throws InputError or OutputError
// where the files can not be made as asked.
Show planned_show(const RenderOptions& options, const Job& job);

// Makes what is wanted. Throws OutputError, InputError and Interrupted.
void make_show(const Show& show, const Scene& scene);

}  // namespace restframe
