#include "app/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>

#include "app/option_values.h"
#include "app/options_authoring.h"
#include "app/options_submit.h"
#include "app/version.h"
#include "scene/error.h"
#include "scene/message.h"
#include "scene/suggest.h"

namespace restframe {
namespace {

constexpr const char* overview =
    R"(restframe: pictures of things that move close to the speed of light.

First steps:
  restframe lattice -o lattice.glb          make an asset, or bring your own: .glb, .gltf, .obj,
                                            .ply, .stl or .off
  restframe render lattice.glb              a picture of it at rest: out/lattice.0000.exr and .png
  restframe render scene.toml               an animation, as a scene file says
  restframe render scene.toml --contact-sheet sheet.png       all of it on one page
  restframe submit --slurm scene.toml       the same by a cluster; restframe status scene.toml
  restframe curves                          how fast clocks are seen to run: out/curves.svg

A scene file of four lines:
  [[object]]
  asset = "lattice.glb"
  position = [0, 0, -12]
  velocity = [0, 0, 0.9]                    in fractions of c; clocks, cameras, lights: see README.md

Exit codes: 0 done, 1 a defect of restframe, 2 bad input or options, 3 output or resources failed,
130 interrupted.)";

// CLI11 would say no more than that a command is missing.
void check_first_word(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    known.push_back(command->get_name());
  }
  if (std::find(known.begin(), known.end(), argv[1]) != known.end()) return;
  throw InputError(
      fmt::format("options: unknown command {}, must be one of {}; the nearest is \"{}\" (see "
                  "restframe --help)",
                  quote(argv[1]), fmt::join(known, ", "), nearest(argv[1], known)));
}

void add_limits(CLI::App& command, ImportLimits& limits) {
  const auto add = [&](const char* name, auto& limit, const char* what) {
    return command.add_option(name, limit, what)
        ->group("Limits on what files may ask for")
        ->capture_default_str()
        ->check(CLI::Range(1.0, 1e15).description(""));  // so that sums of them are numbers, too
  };
  constexpr int deepest = 1000;  // what reads JSON calls itself, level by level
  add("--max-json-bytes", limits.json_bytes, "JSON of a glTF file");
  add("--max-json-depth", limits.json_depth, "Levels of JSON")
      ->check(CLI::Range(1, deepest).description("up to 1000"));
  add("--max-nodes", limits.nodes, "Nodes and instances");
  add("--max-triangles", limits.triangles, "Stored triangles");
  add("--max-image-pixels", limits.image_pixels, "Pixels of an image");
  add("--max-bytes", limits.total_bytes,
      "All of an asset's files, what they unpack to, objects' lists");
}

struct Texts {
  std::string pictures, tile, size, view;
};

// Which pictures of what, for all commands that are about pictures.
CLI::App* add_pictures(CLI::App* command, RenderOptions& render, Texts& texts) {
  command->add_option("SCENE", render.scene, "A scene file (.toml) or an asset")->required();
  command->add_option("-o,--output", render.output,
                      "Where pictures go, # for digits of their number: out/name.####.exr");
  command->add_option("-p,--pictures", texts.pictures,
                      "Only these: 7, or 0-119, or 0-999:10, or several: 0-9,50");
  command->add_option("--size", texts.size, "Width and height in pixels: 640x360");
  command->add_option("--samples", render.samples, "Samples a pixel")->check(CLI::Range(1, 65536));
  command
      ->add_option("--noise", render.noise,
                   "Stop where pixels are this sure, as 0.02: --samples is then the most; 0: never")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--variant", render.variant,
                      "The look of this name that a glTF asset comes in (KHR_materials_variants)");
  command
      ->add_option("--exposure", render.exposure,
                   "Stops by which the .png, not the .exr, is brightened")
      ->check(CLI::Range(-most_stops, most_stops));
  command->add_option("--view", texts.view, "How the .png shows light beyond white")
      ->check(CLI::IsMember({"srgb", "filmic"}));
  return command;
}

// How files are made.
CLI::App* add_work(CLI::App* command, RenderOptions& render) {
  command->add_option("--threads", render.threads, "Threads; 0: all cores")
      ->check(CLI::Range(0, 1024));
  command->add_flag("--overwrite", render.overwrite, "Replace pictures that are there already");
  return command;
}

CLI::App* add_checkpoint(CLI::App* command, RenderOptions& render) {
  command
      ->add_option("--checkpoint", render.checkpoint,
                   "Seconds after which, again and again, a .part file keeps what is done of a "
                   "picture; 0: never")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e6).description(""));
  return command;
}

// What is made of pictures.
CLI::App* add_show(CLI::App* command, RenderOptions& render) {
  command->add_option("--video", render.video,
                      "Then a film of the pictures at the scene's rate: FILE.mp4; needs ffmpeg");
  command->add_option("--contact-sheet", render.contact_sheet,
                      "Then all the pictures, small, on one: FILE.png");
  command->add_flag("-q,--quiet", render.quiet, "No progress bar, no closing line");
  return command;
}

CLI::App* add_render(CLI::App& app, RenderOptions& render, Texts& texts) {
  CLI::App* command = app.add_subcommand(
      "render", "Render a scene file or an asset to EXR pictures; again: those that are missing");
  add_work(add_pictures(command, render, texts), render);
  command->add_option("--tile", texts.tile,
                      "Only one share of each picture, 3/16: a .part file for `restframe merge`");
  return add_show(add_checkpoint(command, render), render);
}

CLI::App* add_merge(CLI::App& app, MergeOptions& merge, RenderOptions& render, Texts& texts) {
  CLI::App* command = app.add_subcommand(
      "merge", "Join what `restframe render --tile` made; takes the same options");
  add_work(add_pictures(command, render, texts), render);
  command->add_flag("--keep", merge.keep, "Keep the .part files");
  return add_show(command, render);
}

RenderOptions completed(RenderOptions render, const Texts& texts) {
  if (!texts.pictures.empty()) render.pictures = parse_pictures(texts.pictures);
  if (!texts.tile.empty()) render.tile = parse_share(texts.tile);
  if (!texts.size.empty()) {
    int width = 0;
    int height = 0;
    parse_sizes("--size", texts.size, {&width, &height});
    render.width = width;
    render.height = height;
  }
  if (!texts.view.empty())
    render.view = texts.view == "filmic" ? ViewTransform::filmic : ViewTransform::srgb;
  return render;
}

CLI::App* add_info(CLI::App& app, InfoOptions& info) {
  CLI::App* command = app.add_subcommand("info",
                                         "Say what a scene or an asset holds: rest frames, "
                                         "objects; the asset as a tree, sizes, memory");
  command->add_option("FILE", info.file, "A scene file or an asset")->required();
  command->add_flag("--json", info.json, "As JSON, for programs; see scenes/reference.md");
  return command;
}

CLI::App* add_check(CLI::App& app, CheckOptions& check) {
  CLI::App* command =
      app.add_subcommand("check", "List every fault of a scene or an asset, render nothing");
  command->add_option("FILE", check.file, "A scene file or an asset")->required();
  return command;
}

void parse(CLI::App& app, int argc, char** argv) {
  check_first_word(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    throw HelpShown{app.exit(asked)};
  } catch (const CLI::ParseError& error) {
    throw InputError(fmt::format("options: {} (see restframe --help)", error.what()));
  }
}

}  // namespace

Options parse_options(int argc, char** argv) {
  CLI::App app(overview, "restframe");
  app.set_version_flag("--version", std::string("restframe ") + program_version);
  app.require_subcommand(1);
  Options options;
  RenderOptions render;
  MergeOptions merge;
  LatticeOptions lattice;
  InfoOptions info;
  CheckOptions check;
  CurvesOptions curves;
  SubmitOptions submit;
  StatusOptions status;
  Texts texts;
  AuthoringTexts authoring;
  struct Command {
    CLI::App* parsed;
    bool reads_files;
    std::function<decltype(Options::command)()> options;
  };
  CLI::App* render_command = add_render(app, render, texts);
  CLI::App* submit_command = add_checkpoint(
      add_work(add_pictures(add_submit(app, submit), render, texts), render), render);
  CLI::App* status_command = add_pictures(add_status(app, status), render, texts);
  const Command commands[] = {
      {render_command, true, [&] { return completed(render, texts); }},
      {add_merge(app, merge, render, texts), true,
       [&] {
         return MergeOptions{completed(render, texts), merge.keep};
       }},
      {submit_command, true,
       [&] { return completed(submit, completed(render, texts), *submit_command); }},
      {status_command, true, [&] { return completed(status, completed(render, texts)); }},
      {add_lattice(app, lattice, authoring), false, [&] { return completed(lattice, authoring); }},
      {add_curves(app, curves, authoring), false, [&] { return completed(curves, authoring); }},
      {add_info(app, info), true, [&] { return info; }},
      {add_check(app, check), true, [&] { return check; }},
  };
  for (const Command& command : commands) {
    if (command.reads_files) add_limits(*command.parsed, options.limits);
  }
  parse(app, argc, argv);
  for (const Command& command : commands) {
    if (app.got_subcommand(command.parsed)) options.command = command.options();
  }
  return options;
}

}  // namespace restframe
