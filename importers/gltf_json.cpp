#include "importers/gltf_json.h"

#include <algorithm>
#include <cstring>
#include <string_view>

#include "scene/message.h"

namespace restframe {
namespace {

constexpr std::size_t most_elements = 1'000'000;  // of one array or object
constexpr std::size_t most_values = 20'000'000;   // of the whole document

// The parser's message without its own prefixes ("[json.exception.parse_error.101] parse error at
// ...: ").
std::string reason_of(const nlohmann::detail::exception& error) {
  std::string_view text = error.what();
  for (const char* prefix : {"] ", "parse error", ": "}) {
    const std::size_t found = text.find(prefix);
    if (found == std::string_view::npos) break;
    text.remove_prefix(found + std::strlen(prefix));
  }
  constexpr std::size_t longest = 200;
  return std::string(text.substr(0, longest));
}

// Builds the document from the parser's events.
class Builder : public nlohmann::json_sax<Json> {
 public:
  Builder(const GltfContext& context, const std::string& text) : context_(context), text_(text) {}

  Json take() { return std::move(root_); }

  bool null() override { return store(nullptr); }
  bool boolean(bool value) override { return store(value); }
  bool number_integer(number_integer_t value) override { return store(value); }
  bool number_unsigned(number_unsigned_t value) override { return store(value); }
  bool number_float(number_float_t value, const string_t&) override { return store(value); }
  bool string(string_t& value) override { return store(std::move(value)); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return start(Json::object()); }
  bool start_array(std::size_t) override { return start(Json::array()); }
  bool end_object() override { return end(); }
  bool end_array() override { return end(); }

  bool key(string_t& key) override {
    if (skipped_depth_ > 0) return true;
    Json& object = *open_.back();
    skip_next_ = open_.size() == extras_depth_ ? key != "restframe" : starts_extras(key);
    if (object.contains(key)) context_.fault(pointer(), "key " + quote(key) + " is there twice");
    key_ = std::move(key);
    return true;
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(position, text_.size()));
    const auto line = std::count(text_.begin(), end, '\n') + 1;
    const auto newline = std::find(std::make_reverse_iterator(end), text_.rend(), '\n');
    const auto column =
        std::max(newline.base() == text_.begin() ? end - text_.begin() : end - newline.base(),
                 std::ptrdiff_t{1});
    context_.fault(std::to_string(line) + ":" + std::to_string(column),
                   "not JSON: " + reason_of(error));
  }

 private:
  bool start(Json container) {
    if (open_.size() + skipped_depth_ >= static_cast<std::size_t>(context_.limits.json_depth)) {
      context_.fault(pointer(), "nested deeper than the limit of " +
                                    std::to_string(context_.limits.json_depth) +
                                    "; --max-json-depth raises it");
    }
    const bool enters_extras = skip_next_ && key_ == "extras" && may_keep_extras() &&
                               skipped_depth_ == 0 && container.is_object();
    if ((skipped_depth_ > 0 || skip_next_) && !enters_extras) {
      skip_next_ = false;
      ++skipped_depth_;
    } else {
      skip_next_ = false;
      open_.push_back(place(std::move(container)));
      if (enters_extras) extras_depth_ = open_.size();
    }
    return true;
  }

  // Inside `extras.restframe` the word has no meaning.
  bool starts_extras(const std::string& key) const {
    return key == "extras" && (extras_depth_ == 0 || open_.size() < extras_depth_);
  }

  // Elements of the document's arrays (document, array, element), and of those of its extensions
  // (document, extensions, extension, array, element) may have an `extras.restframe`.
  bool may_keep_extras() const { return open_.size() == 3 || open_.size() == 5; }

  bool end() {
    if (skipped_depth_ > 0) {
      --skipped_depth_;
    } else {
      if (open_.size() == extras_depth_) extras_depth_ = 0;
      open_.pop_back();
    }
    return true;
  }

  template <class Value>
  bool store(Value&& value) {
    if (skipped_depth_ == 0 && !skip_next_) place(Json(std::forward<Value>(value)));
    skip_next_ = false;
    return true;
  }

  Json* place(Json value) {
    if (++values_ > most_values) {
      context_.fault(pointer(), "more than " + std::to_string(most_values) + " values in all");
    }
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    Json& container = *open_.back();
    if (container.size() >= std::max(most_elements, context_.limits.nodes)) {
      context_.fault(pointer(), "more than " + std::to_string(container.size()) + " elements");
    }
    if (container.is_object()) return &(container[key_] = std::move(value));
    container.push_back(std::move(value));
    return &container.back();
  }

  // Of the innermost open container.
  std::string pointer() const {
    std::string text;
    for (std::size_t i = 1; i < open_.size(); ++i) {
      const Json& parent = *open_[i - 1];
      if (parent.is_array()) {
        text.append("/").append(std::to_string(parent.size() - 1));
        continue;
      }
      for (auto member = parent.begin(); member != parent.end(); ++member) {
        if (&member.value() == open_[i]) text.append("/").append(member.key());
      }
    }
    return text.empty() ? "/" : text;
  }

  const GltfContext& context_;
  const std::string& text_;
  Json root_;
  std::vector<Json*> open_;
  std::string key_;
  std::size_t skipped_depth_ = 0;
  std::size_t extras_depth_ = 0;  // of an open `extras` in open_; 0: none is
  bool skip_next_ = false;
  std::size_t values_ = 0;
};

}  // namespace

Json parse_gltf_json(const GltfContext& context, const std::string& text) {
  Builder builder(context, text);
  Json::sax_parse(text, &builder);
  return builder.take();
}

}  // namespace restframe
