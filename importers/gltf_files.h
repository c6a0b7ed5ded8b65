#pragma once

// The bytes that a glTF file refers to: data URIs, and files beside it. Nothing outside the asset's
// folder is ever opened, whatever the URI's spelling, and only regular files are read.

#include <cstdint>
#include <string>
#include <vector>

#include "importers/gltf_context.h"

namespace restframe {

using Bytes = std::vector<std::uint8_t>;

// An open regular file. Opening never blocks, whatever the path names. Faults are reported at
// `pointer`.
class RegularFile {
 public:
  RegularFile(const GltfContext& context, const Path& path, const std::string& pointer);
  ~RegularFile();
  RegularFile(const RegularFile&) = delete;
  RegularFile& operator=(const RegularFile&) = delete;

  std::size_t size() const { return size_; }
  // The next bytes of the file; a fault if it ends before.
  void read(void* bytes, std::size_t count);

 private:
  const GltfContext& context_;
  std::string pointer_;
  int descriptor_ = -1;
  std::size_t size_ = 0;
};

// What `uri` stands for, at most `limit` bytes. `pointer` is the URI's place, for faults.
Bytes read_uri(const GltfContext& context, const std::string& pointer, const std::string& uri,
               std::size_t limit);

}  // namespace restframe
