#include "importers/draco_mesh.h"
#include "importers/gltf_buffers.h"
#include "importers/gltf_check_compressed.h"
#include "importers/gltf_layout.h"
#include "scene/parallel.h"

namespace restframe {
namespace {

std::size_t padded(std::size_t size) {
  return (size + 3) / 4 * 4;
}

// One compressed primitive: indices, then its attributes, in a buffer of its own.
struct Job {
  std::string pointer;
  Json* primitive = nullptr;
  DracoStream stream;
  std::vector<std::pair<std::string, std::uint32_t>> ids;  // of its attributes
  Bytes bytes;
  std::string fault;
};

std::vector<Job> find_jobs(Json& document, const std::vector<Bytes>& buffers) {
  std::vector<Job> jobs;
  if (!document.contains("meshes")) return jobs;
  std::size_t mesh_index = 0;
  for (Json& mesh : document["meshes"]) {
    std::size_t index = 0;
    const std::string pointer = "/meshes/" + std::to_string(mesh_index++) + "/primitives/";
    for (Json& primitive : mesh["primitives"]) {
      const std::string here = pointer + std::to_string(index++);
      const Json* extension = extension_of(primitive, draco_name);
      if (extension == nullptr) continue;
      const Json& view = document["bufferViews"][(*extension)["bufferView"].get<std::size_t>()];
      Job job;
      job.pointer = here + "/extensions/" + draco_name;
      job.primitive = &primitive;
      job.stream = {buffers[view["buffer"].get<std::size_t>()].data() +
                        view.value("byteOffset", std::size_t{0}),
                    view["byteLength"].get<std::size_t>()};
      for (const auto& [name, id] : (*extension)["attributes"].items()) {
        job.ids.emplace_back(name, id.get<std::uint32_t>());
      }
      jobs.push_back(std::move(job));
    }
  }
  return jobs;
}

const Json& accessor_of(const Json& document, const Json& index) {
  return document["accessors"][index.get<std::size_t>()];
}

std::size_t size_in_bytes(const Json& accessor) {
  return accessor["count"].get<std::size_t>() *
         element_size(accessor["componentType"].get<std::uint64_t>(),
                      accessor["type"].get_ref<const std::string&>());
}

int components_of(const Json& accessor) {
  const std::string& type = accessor["type"].get_ref<const std::string&>();
  return type == "SCALAR" ? 1 : type[3] - '0';
}

void decode(const Json& document, std::size_t most_bytes, Job& job) {
  const Json& attributes = (*job.primitive)["attributes"];
  const auto corners =
      accessor_of(document, (*job.primitive)["indices"])["count"].get<std::size_t>();
  const auto vertices = accessor_of(document, attributes["POSITION"])["count"].get<std::size_t>();
  if (corners % 3 != 0) {
    job.fault = "is of triangles, but the count of the indices is " + std::to_string(corners);
    return;
  }
  DracoWanted wanted{corners / 3, vertices, {}, corners * sizeof(std::uint32_t), most_bytes};
  for (const auto& [name, id] : job.ids) {
    const Json& accessor = accessor_of(document, attributes[name]);
    wanted.attributes.push_back(
        {id, accessor["componentType"].get<int>(), components_of(accessor), wanted.size});
    wanted.size += padded(size_in_bytes(accessor));
  }
  job.fault = decode_draco_mesh(job.stream, wanted, job.bytes);
}

// An accessor like the one given, over `offset` bytes on in a buffer; returns its index.
std::size_t add_accessor(Json& document, Json accessor, std::size_t buffer, std::size_t offset) {
  Json& views = document["bufferViews"];
  accessor["bufferView"] = views.size();
  accessor.erase("byteOffset");
  accessor.erase("sparse");
  views.push_back(
      {{"buffer", buffer}, {"byteOffset", offset}, {"byteLength", size_in_bytes(accessor)}});
  document["accessors"].push_back(std::move(accessor));
  return document["accessors"].size() - 1;
}

void connect(Json& document, std::size_t buffer, const Job& job) {
  Json& primitive = *job.primitive;
  Json indices = accessor_of(document, primitive["indices"]);
  indices["componentType"] = static_cast<std::uint64_t>(component_u32);
  std::size_t offset = size_in_bytes(indices);
  primitive["indices"] = add_accessor(document, std::move(indices), buffer, 0);
  for (const auto& [name, id] : job.ids) {
    Json accessor = accessor_of(document, primitive["attributes"][name]);
    const std::size_t size = padded(size_in_bytes(accessor));
    primitive["attributes"][name] = add_accessor(document, std::move(accessor), buffer, offset);
    offset += size;
  }
  primitive["mode"] = 4;
  primitive["extensions"].erase(draco_name);
}

}  // namespace

void decode_draco(const GltfContext& context, Json& document, std::vector<Bytes>& buffers) {
  std::vector<Job> jobs = find_jobs(document, buffers);
  parallel_for(jobs.size(),
               [&](std::size_t i) { decode(document, context.limits.total_bytes, jobs[i]); });
  for (Job& job : jobs) {
    if (!job.fault.empty()) context.fault(job.pointer, job.fault);
    connect(document, buffers.size(), job);
    buffers.push_back(std::move(job.bytes));
  }
}

}  // namespace restframe
