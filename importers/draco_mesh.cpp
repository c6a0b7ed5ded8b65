#include "importers/draco_mesh.h"

#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>

#include <cstring>
#include <exception>

#include "importers/gltf_layout.h"
#include "scene/message.h"

namespace restframe {
namespace {

constexpr std::uint16_t gltf_bitstream = DRACO_BITSTREAM_VERSION(2, 2);
constexpr std::size_t most_vertex_bytes = 1024;  // of all attributes: far more than glTF has

std::string differ(const char* what, std::size_t there, std::size_t expected) {
  return "has " + std::to_string(there) + " " + what + ", its accessors " +
         std::to_string(expected);
}

// What a stream says of itself before its triangles: an edgebreaker's...
std::string counts_fault(const draco::MeshEdgebreakerDecoder&, draco::DecoderBuffer rest,
                         const DracoWanted& wanted) {
  std::uint32_t corners = 0, faces = 0;
  std::uint8_t seams = 0;  // attributes with edges of their own
  if (!draco::DecodeVarint(&corners, &rest) || !draco::DecodeVarint(&faces, &rest) ||
      !rest.Decode(&seams)) {
    return "ends within its header";
  }
  if (faces != wanted.triangles) return differ("triangles", faces, wanted.triangles);
  if (corners > 3 * wanted.triangles) return differ("vertices", corners, wanted.vertices);
  constexpr std::size_t face_bytes = 100, seam_bytes = 16;  // a triangle, roughly
  return faces * (face_bytes + seam_bytes * seams) > wanted.most_bytes ? "needs too much memory"
                                                                       : "";
}

// ... and a list of triangles.
std::string counts_fault(const draco::MeshSequentialDecoder&, draco::DecoderBuffer rest,
                         const DracoWanted& wanted) {
  std::uint32_t faces = 0, points = 0;
  if (!draco::DecodeVarint(&faces, &rest) || !draco::DecodeVarint(&points, &rest)) {
    return "ends within its header";
  }
  if (faces != wanted.triangles) return differ("triangles", faces, wanted.triangles);
  return points != wanted.vertices ? differ("vertices", points, wanted.vertices) : "";
}

std::string attributes_fault(const draco::PointCloud& cloud, const DracoWanted& wanted) {
  if (cloud.num_points() != wanted.vertices) {
    return differ("vertices", cloud.num_points(), wanted.vertices);
  }
  std::size_t vertex_bytes = 0;
  for (std::int32_t i = 0; i < cloud.num_attributes(); ++i) {
    vertex_bytes += static_cast<std::size_t>(cloud.attribute(i)->byte_stride());
  }
  if (vertex_bytes > most_vertex_bytes || vertex_bytes * wanted.vertices > wanted.most_bytes) {
    return "has " + std::to_string(vertex_bytes) + " bytes a vertex, too many";
  }
  return "";
}

// Draco's decoder calls these steps after it has read how much there is, before it makes room.
template <class Decoder>
class Guarded : public Decoder {
 public:
  explicit Guarded(const DracoWanted& wanted) : wanted_(wanted) {}
  const std::string& fault() const { return fault_; }

 protected:
  bool DecodeConnectivity() override {
    if (this->bitstream_version() != gltf_bitstream) {
      fault_ = "is of a bitstream version that is not 2.2";
    } else {
      fault_ = counts_fault(*this, *this->buffer(), wanted_);
    }
    return fault_.empty() && Decoder::DecodeConnectivity();
  }

  bool DecodeAllAttributes() override {
    fault_ = attributes_fault(*this->point_cloud(), wanted_);
    return fault_.empty() && Decoder::DecodeAllAttributes();
  }

 private:
  const DracoWanted& wanted_;
  std::string fault_;
};

template <class Decoder>
std::string decode_with(const DracoStream& stream, const DracoWanted& wanted, draco::Mesh& mesh) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(stream.bytes), stream.length);
  Guarded<Decoder> decoder(wanted);
  const draco::Status status = decoder.Decode(draco::DecoderOptions(), &buffer, &mesh);
  if (!decoder.fault().empty()) return decoder.fault();
  if (!status.ok()) return "can not be decompressed: " + quote(status.error_msg_string());
  return "";
}

std::string decode(const DracoStream& stream, const DracoWanted& wanted, draco::Mesh& mesh) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(stream.bytes), stream.length);
  draco::DracoHeader header;
  if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok()) return "is not of Draco";
  if (header.encoder_type != draco::TRIANGULAR_MESH) return "is not a mesh";
  if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING) {
    return decode_with<draco::MeshEdgebreakerDecoder>(stream, wanted, mesh);
  }
  return decode_with<draco::MeshSequentialDecoder>(stream, wanted, mesh);
}

template <class Component>
bool copy_values(const draco::PointAttribute& from, std::size_t vertices,
                 const DracoAttribute& wanted, std::uint8_t* to) {
  const std::size_t stride = sizeof(Component) * static_cast<std::size_t>(wanted.components);
  std::vector<Component> value(static_cast<std::size_t>(wanted.components));
  for (std::size_t i = 0; i < vertices; ++i) {
    const auto index = from.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(i)));
    if (index.value() >= from.size()) return false;
    if (!from.ConvertValue(index, static_cast<std::int8_t>(wanted.components), value.data())) {
      return false;
    }
    std::memcpy(to + i * stride, value.data(), stride);
  }
  return true;
}

bool copy_attribute(const draco::PointAttribute& from, std::size_t vertices,
                    const DracoAttribute& wanted, std::uint8_t* to) {
  switch (wanted.component_type) {
    case component_i8:
      return copy_values<std::int8_t>(from, vertices, wanted, to);
    case component_u8:
      return copy_values<std::uint8_t>(from, vertices, wanted, to);
    case component_i16:
      return copy_values<std::int16_t>(from, vertices, wanted, to);
    case component_u16:
      return copy_values<std::uint16_t>(from, vertices, wanted, to);
    case component_u32:
      return copy_values<std::uint32_t>(from, vertices, wanted, to);
    default:
      return copy_values<float>(from, vertices, wanted, to);
  }
}

// Whether all values that it may be asked for are there.
bool is_whole(const draco::PointAttribute& attribute) {
  if (attribute.buffer() == nullptr || attribute.byte_offset() < 0) return false;
  const auto stride = static_cast<std::size_t>(attribute.byte_stride());
  const auto offset = static_cast<std::size_t>(attribute.byte_offset());
  return offset + stride * attribute.size() <= attribute.buffer()->data_size();
}

std::string read_attribute(const draco::Mesh& mesh, const DracoAttribute& wanted,
                           std::uint8_t* to) {
  const std::string name = "attribute " + std::to_string(wanted.id);
  const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(wanted.id);
  if (attribute == nullptr) return "has no " + name;
  if (attribute->num_components() != wanted.components) {
    return "has " + name + " of " + std::to_string(attribute->num_components()) +
           " components, its accessor " + std::to_string(wanted.components);
  }
  const bool holds_floats =
      attribute->data_type() == draco::DT_FLOAT32 || attribute->data_type() == draco::DT_FLOAT64;
  if (holds_floats && wanted.component_type != component_f32) {
    return "has " + name + " of floats, its accessor is of integers";
  }
  const std::size_t vertices = mesh.num_points();
  if (!is_whole(*attribute) || !copy_attribute(*attribute, vertices, wanted, to)) {
    return "has " + name + " that can not be read";
  }
  return "";
}

void read_indices(const draco::Mesh& mesh, std::uint8_t* to) {
  for (std::uint32_t i = 0; i < mesh.num_faces(); ++i) {
    for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(i))) {
      const std::uint32_t index = corner.value();
      std::memcpy(to, &index, sizeof index);
      to += sizeof index;
    }
  }
}

}  // namespace

std::string decode_draco_mesh(const DracoStream& stream, const DracoWanted& wanted,
                              std::vector<std::uint8_t>& bytes) try {
  draco::Mesh mesh;
  std::string fault = decode(stream, wanted, mesh);
  if (!fault.empty()) return fault;
  if (mesh.num_faces() != wanted.triangles) {
    return differ("triangles", mesh.num_faces(), wanted.triangles);
  }
  if (mesh.num_points() != wanted.vertices) {
    return differ("vertices", mesh.num_points(), wanted.vertices);
  }
  bytes.resize(wanted.size);
  read_indices(mesh, bytes.data());
  for (const DracoAttribute& attribute : wanted.attributes) {
    fault = read_attribute(mesh, attribute, bytes.data() + attribute.offset);
    if (!fault.empty()) break;
  }
  return fault;
} catch (const std::exception&) {  // such as std::length_error: a count that makes no sense
  return "can not be decompressed";
}

}  // namespace restframe
