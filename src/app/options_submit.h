#pragma once

// The options of the commands that have pictures made elsewhere, besides those of the pictures.

#include <CLI/CLI.hpp>

#include "app/options.h"

namespace restframe {

CLI::App* add_submit(CLI::App& app, SubmitOptions& submit);
CLI::App* add_status(CLI::App& app, StatusOptions& status);

// With the pictures' options, and what of the words that `command` was given goes on to each task.
// Throws InputError where Slurm could misread something.
SubmitOptions completed(SubmitOptions options, const RenderOptions& render,
                        const CLI::App& command);
StatusOptions completed(StatusOptions options, const RenderOptions& render);

}  // namespace restframe
