// The scenes and the texts for readers: what they show renders, what they say to write is accepted.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/exr_writer.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;

const fs::path top = RESTFRAME_SOURCE_DIR;
const std::vector<std::string> texts = {"README.md", "scenes/README.md", "scenes/reference.md",
                                        "scenes/layers.md"};

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  return content.str();
}

// All but the figures that are no scenes but drawings.
std::vector<fs::path> scene_folders() {
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(top / "scenes")) {
    const bool drawing = fs::exists(entry.path() / "picture.svg");
    if (entry.is_directory() && !drawing) folders.push_back(entry.path());
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

RunResult restframe_program(const std::vector<std::string>& arguments, const fs::path& folder) {
  RunOptions options;
  options.folder = folder;
  return run_program(RESTFRAME_PROGRAM, arguments, options);
}

// The blocks between ```LANGUAGE and ```.
std::vector<std::string> fenced_blocks(const std::string& text, const std::string& language) {
  std::vector<std::string> blocks;
  const std::string opening = "\n```" + language + "\n";
  for (std::size_t at = text.find(opening); at != std::string::npos;) {
    const std::size_t begin = at + opening.size();
    const std::size_t end = text.find("\n```", begin - 1);
    blocks.push_back(text.substr(begin, end + 1 - begin));
    at = text.find(opening, end);
  }
  return blocks;
}

// An example that shows only settings or materials is one of a scene with a lattice.
std::string completed(const std::string& example) {
  if (example.find("[[object]]") != std::string::npos) return example;
  return example + "\n[[object]]\nlattice = {cells = [2, 2, 2]}\n";
}

// The anchors of a text's headings, as GitHub makes them.
std::set<std::string> anchors_of(const std::string& text) {
  std::set<std::string> anchors;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t level = std::min(line.find_first_not_of('#'), line.size());
    if (level < 2 || level >= line.size() || line[level] != ' ') continue;
    std::string anchor;
    for (const char c : line.substr(level + 1)) {
      const auto byte = static_cast<unsigned char>(c);
      if (std::isalnum(byte) || c == '-' || c == '_')
        anchor += static_cast<char>(std::tolower(byte));
      if (c == ' ') anchor += '-';
    }
    anchors.insert(anchor);
  }
  return anchors;
}

struct Link {
  std::string target, anchor;
};

std::vector<Link> links_of(const std::string& text) {
  static const std::regex pattern(R"(\]\(([^)#]*)(?:#([^)]*))?\))");
  std::vector<Link> links;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
    links.push_back({(*it)[1], (*it)[2]});
  }
  return links;
}

TEST(Scenes, EachIsWithoutFault) {
  ASSERT_GE(scene_folders().size(), 7U);
  for (const fs::path& folder : scene_folders()) {
    const RunResult result = restframe_program({"check", folder / "scene.toml"}, top);
    EXPECT_EQ(result.exit_code, 0) << folder << result.error;
  }
}

TEST(Scenes, EachRendersItsFirstPicture) {
  const TemporaryFolder out;
  for (const fs::path& folder : scene_folders()) {
    const std::string name = folder.filename();
    const RunResult result =
        restframe_program({"render", folder / "scene.toml", "--size", "64x36", "--samples", "1",
                           "--pictures", "0", "--output", name + ".####.exr"},
                          out.path());
    EXPECT_EQ(result.exit_code, 0) << name << result.error;
    EXPECT_TRUE(fs::exists(out.path() / (name + ".0000.exr"))) << name;
  }
}

TEST(Scenes, EachWritesToAFolderOfItsName) {
  for (const fs::path& folder : scene_folders()) {
    const std::string path = "path = \"out/" + folder.filename().string() + "/picture.####.exr\"";
    EXPECT_THAT(content_of(folder / "scene.toml"), testing::HasSubstr(path));
  }
}

TEST(Scenes, EachHasASmallPictureInTheGallery) {
  const std::string gallery = content_of(top / "scenes/README.md");
  for (const fs::path& folder : scene_folders()) {
    const std::string name = folder.filename();
    ASSERT_TRUE(fs::exists(folder / "picture.png")) << name;
    EXPECT_LT(fs::file_size(folder / "picture.png"), 300'000U) << name;
    EXPECT_THAT(gallery, testing::HasSubstr("(" + name + "/picture.png)"));
    EXPECT_THAT(gallery, testing::HasSubstr("render scenes/" + name + "/scene.toml"));
  }
}

TEST(Texts, LinksLeadSomewhere) {
  for (const std::string& name : texts) {
    const std::string text = content_of(top / name);
    for (const Link& link : links_of(text)) {
      if (link.target.rfind("http", 0) == 0) continue;
      const fs::path file =
          link.target.empty() ? top / name : (top / name).parent_path() / link.target;
      EXPECT_TRUE(fs::exists(file)) << name << ": " << link.target;
      if (link.anchor.empty()) continue;
      EXPECT_EQ(anchors_of(content_of(file)).count(link.anchor), 1U)
          << name << ": #" << link.anchor;
    }
  }
}

TEST(Texts, ExamplesAreScenesWithoutFault) {
  const TemporaryFolder folder;
  for (const char* asset : {"lattice.glb", "lattice.obj"}) {
    const RunResult made =
        restframe_program({"lattice", "-o", asset, "--cells", "2x2x2"}, folder.path());
    ASSERT_EQ(made.exit_code, 0) << made.error;
  }
  folder.write("scan.ply",
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
               "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
               "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  folder.write("skies/evening.exr", sky_exr(8, 4, [](int, int) { return Vec3f(1); }));
  std::size_t count = 0;
  for (const std::string& name : texts) {
    for (const std::string& example : fenced_blocks(content_of(top / name), "toml")) {
      folder.write("scene.toml", completed(example));
      const RunResult result = restframe_program({"check", "scene.toml"}, folder.path());
      EXPECT_EQ(result.exit_code, 0) << name << ":\n" << example << result.error;
      ++count;
    }
  }
  EXPECT_GE(count, 10U);
}

}  // namespace
}  // namespace restframe
