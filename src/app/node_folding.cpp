#include "app/node_folding.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <tuple>
#include <unordered_map>

namespace restframe {
namespace {

std::size_t index_of(int i) {
  return static_cast<std::size_t>(i);
}

// The name without digits and dividers at its end.
std::string_view stem_of(std::string_view name) {
  const std::size_t last = name.find_last_not_of("0123456789._- ");
  return name.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

// Siblings of one kind.
struct Group {
  int kind = 0;
  std::vector<int> nodes;
};

class Folding {
 public:
  Folding(const Asset& asset, const NodeRanges& nodes, const FoldingLimits& limits)
      : asset_(asset),
        tree_(asset.tree),
        limits_(limits),
        children_(tree_.nodes.size()),
        kinds_(tree_.nodes.size(), -1),
        sizes_(tree_.nodes.size(), 1) {
    for (const NodeRange& range : nodes) {
      for (int i = range.begin; i < range.end; ++i) {
        const int parent = tree_.nodes[index_of(i)].parent;
        (parent < 0 ? roots_ : children_[index_of(parent)]).push_back(i);
      }
    }
    for (auto range = nodes.rbegin(); range != nodes.rend(); ++range) {
      for (int i = range->end - 1; i >= range->begin; --i) find_kind(i);
    }
  }

  FoldedNode all() {
    FoldedNode top;
    list(roots_, 1, top);
    return top;
  }

 private:
  // Children come before their parents, so that their kinds are known.
  void find_kind(int node) {
    const AssetNode& it = tree_.nodes[index_of(node)];
    std::string key = fmt::format("{}\n{} {} {}", stem_of(it.name), it.light, it.camera,
                                  has_extras(tree_, ExtrasOf::node, node));
    for (const MeshUse& use : mesh_uses(asset_, node)) {
      fmt::format_to(std::back_inserter(key), " m{}x{}", use.mesh, use.count);
    }
    for (const Group& group : groups_of(children_[index_of(node)])) {
      fmt::format_to(std::back_inserter(key), " {}x{}", group.kind, group.nodes.size());
    }
    for (const int child : children_[index_of(node)])
      sizes_[index_of(node)] += sizes_[index_of(child)];
    const auto [known, is_new] = known_kinds_.try_emplace(key, known_kinds_.size());
    kinds_[index_of(node)] = static_cast<int>(known->second);
  }

  // In the order of the first of each.
  std::vector<Group> groups_of(const std::vector<int>& nodes) const {
    std::vector<Group> groups;
    std::unordered_map<int, std::size_t> of_kind;
    for (const int node : nodes) {
      const int kind = kinds_[index_of(node)];
      const auto [known, is_new] = of_kind.try_emplace(kind, groups.size());
      if (is_new) groups.push_back({kind, {}});
      groups[known->second].nodes.push_back(node);
    }
    return groups;
  }

  std::string name_of(const std::vector<int>& nodes) const {
    const std::string& first = tree_.nodes[index_of(nodes.front())].name;
    std::size_t common = first.size();
    bool equal = true;
    for (const int node : nodes) {
      const std::string& name = tree_.nodes[index_of(node)].name;
      equal &= name == first;
      const auto differ = std::mismatch(first.begin(), first.end(), name.begin(), name.end());
      common = std::min(common, static_cast<std::size_t>(differ.first - first.begin()));
    }
    if (equal && (nodes.size() == 1 || !first.empty())) return shown_name(tree_, nodes.front());
    return equal ? "(no name)" : first.substr(0, common) + "*";
  }

  void list(const std::vector<int>& nodes, int depth, FoldedNode& parent) {
    const std::vector<Group> groups = groups_of(nodes);
    for (const Group& group : groups) {
      if (depth > limits_.depth || parent.children.size() >= limits_.siblings ||
          lines_ >= limits_.lines) {
        for (const int node : group.nodes) parent.more += sizes_[index_of(node)];
        continue;
      }
      ++lines_;
      parent.children.push_back(
          {group.nodes.front(), name_of(group.nodes), group.nodes.size(), {}});
    }
    for (FoldedNode& child : parent.children) {
      list(children_[index_of(child.node)], depth + 1, child);
    }
  }

  const Asset& asset_;
  const AssetTree& tree_;
  FoldingLimits limits_;
  std::vector<int> roots_;
  std::vector<std::vector<int>> children_;
  std::vector<int> kinds_;
  std::vector<std::size_t> sizes_;  // nodes at and below each
  std::unordered_map<std::string, std::size_t> known_kinds_;
  std::size_t lines_ = 0;
};

}  // namespace

FoldedNode folded_nodes(const Asset& asset, const NodeRanges& nodes, const FoldingLimits& limits) {
  return Folding(asset, nodes, limits).all();
}

std::string shown_name(const AssetTree& tree, int node) {
  const AssetNode& it = tree.nodes[index_of(node)];
  return it.name.empty() ? fmt::format("node {}", it.number) : it.name;
}

std::vector<MeshUse> mesh_uses(const Asset& asset, int node) {
  const auto is_before = [](const Part& part, int wanted) { return part.node < wanted; };
  auto part = std::lower_bound(asset.parts.begin(), asset.parts.end(), node, is_before);
  std::vector<MeshUse> uses;
  for (; part != asset.parts.end() && part->node == node; ++part) {
    if (uses.empty() || uses.back().mesh != part->mesh) uses.push_back({part->mesh, 0});
    ++uses.back().count;
  }
  return uses;
}

bool has_extras(const AssetTree& tree, ExtrasOf of, int index) {
  const auto is_before = [](const AssetExtras& extras, std::pair<ExtrasOf, int> wanted) {
    return std::pair(extras.of, extras.index) < wanted;
  };
  const auto found =
      std::lower_bound(tree.extras.begin(), tree.extras.end(), std::pair(of, index), is_before);
  return found != tree.extras.end() && found->of == of && found->index == index;
}

}  // namespace restframe
