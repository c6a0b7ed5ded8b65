#include "importers/json_config.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "importers/toml_text.h"
#include "importers/value_reader.h"
#include "scene/message.h"

namespace restframe {
namespace {

constexpr std::size_t deepest = 32;
constexpr std::size_t most_places = 5'000'000;

TextPosition in_place(int place) {
  return {0, 0, place};
}

// Builds the value from the parser's events, which end with the first fault.
class Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
  Builder(int place, FaultList& faults) : faults_(faults), place_(place) {}

  std::optional<ConfigValue> take() { return failed_ ? std::nullopt : std::move(root_); }

  bool null() override { return store(ConfigNull{}); }
  bool boolean(bool value) override { return store(value); }
  bool number_integer(number_integer_t value) override { return store(value); }
  bool number_unsigned(number_unsigned_t value) override {
    constexpr auto largest = std::numeric_limits<std::int64_t>::max();
    if (value > static_cast<number_unsigned_t>(largest)) return store(static_cast<double>(value));
    return store(static_cast<std::int64_t>(value));
  }
  bool number_float(number_float_t value, const string_t&) override { return store(value); }
  bool string(string_t& value) override { return store(std::move(value)); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return start(ConfigTable{}); }
  bool start_array(std::size_t) override { return start(ConfigArray{}); }
  bool end_object() override { return end(); }
  bool end_array() override { return end(); }

  bool key(string_t& key) override {
    Open& object = open_.back();
    if (!object.keys.insert(key).second) {
      return fail(object.value.at.place, "key " + quote(key) + " is there twice");
    }
    object.key = std::move(key);
    return true;
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception&) override {
    return fail(place_, fmt::format("not JSON from character {} on", position));
  }

 private:
  struct Open {
    ConfigValue value;
    std::string key;             // of an object: that of the value to come
    std::set<std::string> keys;  // those so far
  };

  bool fail(int place, const std::string& what) {
    if (!failed_) faults_.add(in_place(place), what);
    failed_ = true;
    return false;
  }

  // Where the next value stands; 0 where there are too many.
  int next_place() {
    if (open_.empty()) return place_;
    if (faults_.places() >= most_places) return 0;
    const Open& parent = open_.back();
    const auto* array = std::get_if<ConfigArray>(&parent.value.data);
    return faults_.add_place(parent.value.at.place,
                             array ? std::to_string(array->size()) : parent.key);
  }

  template <class Container>
  bool start(Container container) {
    const int place = next_place();
    if (place == 0) return fail(place_, "what assets say in extras.restframe is too much in all");
    if (open_.size() >= deepest) return fail(place, fmt::format("nested deeper than {}", deepest));
    if constexpr (std::is_same_v<Container, ConfigTable>) container.at = in_place(place);
    open_.push_back({{in_place(place), std::move(container)}, {}, {}});
    return true;
  }

  bool end() {
    ConfigValue value = std::move(open_.back().value);
    open_.pop_back();
    return put(std::move(value));
  }

  template <class Data>
  bool store(Data&& data) {
    const int place = next_place();
    if (place == 0) return fail(place_, "what assets say in extras.restframe is too much in all");
    return put({in_place(place), std::forward<Data>(data)});
  }

  bool put(ConfigValue value) {
    if (open_.empty()) {
      root_ = std::move(value);
    } else if (auto* array = std::get_if<ConfigArray>(&open_.back().value.data)) {
      array->push_back(std::move(value));
    } else {
      const TextPosition at = value.at;
      auto& entries = std::get<ConfigTable>(open_.back().value.data).entries;
      entries.push_back({std::move(open_.back().key), at, std::move(value)});
    }
    return true;
  }

  FaultList& faults_;
  int place_;
  std::optional<ConfigValue> root_;
  std::vector<Open> open_;
  bool failed_ = false;
};

}  // namespace

std::optional<ConfigValue> parse_json(const std::string& text, int place, FaultList& faults) {
  Builder builder(place, faults);
  nlohmann::json::sax_parse(text, &builder);
  return builder.take();
}

std::optional<ConfigTable> parse_json_or_toml(const std::string& text, int place,
                                              FaultList& faults) {
  std::optional<ConfigValue> value = parse_json(text, place, faults);
  if (!value) return std::nullopt;
  if (auto* table = std::get_if<ConfigTable>(&value->data)) return std::move(*table);
  const auto* toml = std::get_if<std::string>(&value->data);
  if (!toml) {
    faults.add(value->at,
               fmt::format("is {}, must be an object, or TOML in a string", kind_name(*value)));
    return std::nullopt;
  }
  try {
    return parse_toml(*toml, faults.place_text(place), place);
  } catch (const InputError& error) {
    faults.add(in_place(place), error);
    return std::nullopt;
  }
}

}  // namespace restframe
