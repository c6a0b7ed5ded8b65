#include <algorithm>
#include <cmath>

#include "importers/gltf_accessor.h"
#include "importers/gltf_node_transform.h"
#include "importers/gltf_pose.h"

namespace restframe {
namespace {

constexpr std::size_t most_joints = 65536;  // that indices of 16 bits can name

// node_from_bind of a joint; its last row must be that of an affine transform.
Mat4 affine(const GltfContext& context, const std::string& pointer, std::size_t index,
            const Mat4& matrix) {
  for (int column = 0; column < 4; ++column) {
    const double last = column == 3 ? 1 : 0;
    const bool good =
        is_within(matrix[column], largest_coordinate) && std::abs(matrix[column].w - last) < 1e-3;
    if (good) continue;
    context.fault(pointer,
                  "matrix " + std::to_string(index) + " is not finite, beyond 1e15 or not affine");
  }
  Mat4 result = matrix;
  for (int column = 0; column < 4; ++column) result[column].w = column == 3 ? 1 : 0;
  return result;
}

// A vertex's share of each joint: one set of JOINTS_n and WEIGHTS_n.
struct Influences {
  std::vector<Vec4f> joints, weights;
};

Influences read_influences(const PrimitivePlace& place, const tinygltf::Model& model,
                           const tinygltf::Primitive& primitive, const std::string& set,
                           std::size_t joints) {
  Influences read{read_vec4(place.context, model, primitive.attributes.at("JOINTS_" + set)),
                  read_vec4(place.context, model, primitive.attributes.at("WEIGHTS_" + set))};
  for (std::size_t i = 0; i < read.joints.size(); ++i) {
    for (int c = 0; c < 4; ++c) {
      const auto joint = static_cast<std::size_t>(read.joints[i][c]);
      const float weight = read.weights[i][c];
      const std::string vertex = "vertex " + std::to_string(i);
      if (joint >= joints) {
        place.context.fault(place.pointer + "/attributes/JOINTS_" + set,
                            vertex + " hangs on joint " + std::to_string(joint) +
                                ", the skin has " + std::to_string(joints));
      }
      if (weight >= 0 && weight <= 1e15F) continue;
      place.context.fault(
          place.pointer + "/attributes/WEIGHTS_" + set,
          vertex + " has weight " + std::to_string(weight) + ", must be finite and not negative");
    }
  }
  return read;
}

std::vector<Influences> read_all_influences(const PrimitivePlace& place,
                                            const tinygltf::Model& model,
                                            const tinygltf::Primitive& primitive,
                                            std::size_t joints) {
  std::vector<Influences> sets;
  while (primitive.attributes.count("JOINTS_" + std::to_string(sets.size())) > 0) {
    sets.push_back(read_influences(place, model, primitive, std::to_string(sets.size()), joints));
  }
  return sets;
}

double sum_of_weights(const std::vector<Influences>& sets, std::size_t vertex) {
  double sum = 0;
  for (const Influences& set : sets) {
    for (int c = 0; c < 4; ++c) sum += set.weights[vertex][c];
  }
  return sum;
}

// asset_from_bind at a vertex: the mean of its joints'. All of the first joint where no weight is.
Mat4 blended(const std::vector<Influences>& sets, std::size_t vertex,
             const std::vector<Mat4>& matrices, double sum) {
  if (!(sum > 0)) return matrices[static_cast<std::size_t>(sets[0].joints[vertex].x)];
  Mat4 result(0);
  for (const Influences& set : sets) {
    for (int c = 0; c < 4; ++c) {
      const double weight = set.weights[vertex][c] / sum;
      if (weight != 0) result += weight * matrices[static_cast<std::size_t>(set.joints[vertex][c])];
    }
  }
  return result;
}

// Directions of a surface keep to it under the matrix, normals under its cofactors; both lose
// their length. What a singular matrix squeezes to nothing stays as it was.
Vec3f direction(const Vec3& moved, const Vec3f& before) {
  const double length = glm::length(moved);
  return length > 0 && std::isfinite(length) ? Vec3f(moved / length) : before;
}

void move_vertex(const Mat4& matrix, std::size_t i, Mesh& mesh) {
  mesh.positions[i] = Vec3f(Vec3(matrix * glm::dvec4(Vec3(mesh.positions[i]), 1)));
  if (mesh.normals.empty()) return;
  const Vec3 x(matrix[0]), y(matrix[1]), z(matrix[2]);
  const Mat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
  const double side = glm::dot(x, cofactors[0]) < 0 ? -1 : 1;
  mesh.normals[i] = direction(side * (cofactors * Vec3(mesh.normals[i])), mesh.normals[i]);
  if (mesh.tangents.empty()) return;
  const Vec3f before(mesh.tangents[i]);
  const Vec3f after = direction(Mat3(matrix) * Vec3(before), before);
  mesh.tangents[i] = Vec4f(after, mesh.tangents[i].w * static_cast<float>(side));
}

}  // namespace

const std::vector<Mat4>& Skins::matrices(int skin) {
  const auto [entry, is_new] = matrices_.try_emplace(skin);
  if (!is_new) return entry->second;
  if (asset_from_node_.empty()) asset_from_node_ = asset_from_nodes(model_);
  const tinygltf::Skin& source = model_.skins[static_cast<std::size_t>(skin)];
  const std::string pointer = "/skins/" + std::to_string(skin);
  std::vector<Mat4> bind;
  if (source.inverseBindMatrices >= 0) {
    bind = read_mat4(context_, model_, source.inverseBindMatrices);
  }
  const std::size_t count = std::min(source.joints.size(), most_joints);
  for (std::size_t i = 0; i < count; ++i) {
    Mat4 matrix = asset_from_node_[static_cast<std::size_t>(source.joints[i])];
    if (!bind.empty()) {
      matrix = matrix * affine(context_, pointer + "/inverseBindMatrices", i, bind[i]);
    }
    for (int column = 0; column < 4; ++column) {
      if (is_within(matrix[column], largest_coordinate)) continue;
      context_.fault(pointer + "/joints/" + std::to_string(i),
                     "its transform is not finite or beyond 1e15");
    }
    entry->second.push_back(matrix);
  }
  return entry->second;
}

void apply_skin(const PrimitivePlace& place, const tinygltf::Model& model,
                const tinygltf::Primitive& primitive, const std::vector<Mat4>& matrices,
                Mesh& mesh) {
  const std::vector<Influences> sets =
      read_all_influences(place, model, primitive, matrices.size());
  std::size_t uneven = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const double sum = sum_of_weights(sets, i);
    uneven += std::abs(sum - 1) > 0.01 ? 1U : 0U;
    move_vertex(blended(sets, i, matrices, sum), i, mesh);
  }
  if (uneven > 0) {
    place.context.warn(
        place.pointer + "/attributes/WEIGHTS_0",
        "the weights of " + std::to_string(uneven) + " vertices do not sum to 1: they are made to");
  }
}

}  // namespace restframe
