#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/choices.hpp"
#include "app/base/units.hpp"
#include "app/study/config_value.hpp"
#include "geometry/base/angle.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {

/// The values a number may take.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool least_allowed = true;
  bool most_allowed = true;

  bool contains(double value) const;
  /// "above 0", "from 0 to 10", ...; "" for all numbers
  std::string text() const;
};
inline constexpr Range any_number{};
inline constexpr Range positive{.least = 0, .least_allowed = false};
inline constexpr Range not_negative{.least = 0};

/// What the documentation says of a key. The parser works from the same entry.
struct KeyText {
  std::string name;
  std::string type;      ///< "integer", "length", "3 lengths", "\"elimination\" or \"lagrange\"", ...
  std::string range;     ///< "" for none
  std::string fallback;  ///< the default as one would write it; "" for none
  std::string meaning;   ///< one or two sentences
  bool required = false;
};

/// A table of the study file and its keys, for the documentation.
struct SectionText {
  std::string name;     ///< "model", "support.where.cylinder"
  std::string heading;  ///< as one writes it: "[model]", "[[support]]", "where = { cylinder = { ... } }"
  std::string meaning;
  std::vector<KeyText> keys;
};

/// Reads basic values; each throws Error invalid_argument with the value's place, what was expected and what
/// came.
/// @param what  name of the key for messages
bool read_flag(const ConfigValue& value, const std::string& what);
int read_integer(const ConfigValue& value, const std::string& what, int least, int most);
std::string read_text(const ConfigValue& value, const std::string& what);
/// A number in SI units, or a string with a unit of the dimension.
double read_quantity(const ConfigValue& value, const std::string& what, const Dimension& dimension,
                     const Range& range = any_number);
Eigen::Vector3d read_vector(const ConfigValue& value, const std::string& what, const Dimension& dimension);
/// A direction: "x", "-y", ... or three numbers; returned with length 1.
Eigen::Vector3d read_direction(const ConfigValue& value, const std::string& what);
/// m per model unit: "mm", "225 mm", or a number.
double read_length_unit(const ConfigValue& value);
const std::vector<ConfigValue>& read_array(const ConfigValue& value, const std::string& what);
const ConfigTable& read_subtable(const ConfigValue& value, const std::string& what);
/// The error for a word that is not among those known, naming the nearest one.
Error unknown_choice(const ConfigValue& value, const std::string& what, const std::string& text,
                     const std::vector<std::string>& known);
template <class Value>
Value read_choice(const ConfigValue& value, const std::string& what, const Choices<Value>& choices) {
  const std::string text = read_text(value, what);
  if (const Value* found = find_choice(choices, text)) return *found;
  throw unknown_choice(value, what, text, names(choices));
}

/// The type's name for the documentation: "length (m)".
std::string type_name(const Dimension& dimension);
/// A default value as one would write it.
std::string format_default(double value);

/// A key of a table that fills a struct S.
template <class S>
struct Key {
  KeyText text;
  std::function<void(S&, const ConfigValue&)> read;

  Key required() && {
    text.required = true;
    text.fallback.clear();
    return std::move(*this);
  }
  Key with_default(std::string fallback) && {
    text.fallback = std::move(fallback);
    return std::move(*this);
  }
};
template <class S>
using Keys = std::vector<Key<S>>;

template <class S>
Key<S> custom_key(std::string name, std::string type, std::string meaning,
                  std::function<void(S&, const ConfigValue&)> read) {
  return {{std::move(name), std::move(type), "", "", std::move(meaning)}, std::move(read)};
}

/// The functions below make a key that fills a member; its default is the one of a fresh S.
template <class S>
Key<S> quantity_key(const std::string& name, double S::*member, const Dimension& dimension,
                    const Range& range, std::string meaning) {
  return {{name, type_name(dimension), range.text(), format_default(S{}.*member), std::move(meaning)},
          [=](S& target, const ConfigValue& value) {
            target.*member = read_quantity(value, name, dimension, range);
          }};
}

template <class S>
Key<S> quantity_key(const std::string& name, std::optional<double> S::*member, const Dimension& dimension,
                    const Range& range, std::string meaning) {
  return {{name, type_name(dimension), range.text(), "", std::move(meaning)},
          [=](S& target, const ConfigValue& value) {
            target.*member = read_quantity(value, name, dimension, range);
          }};
}

template <class S>
Key<S> quantity_key(const std::string& name, Angle S::*member, const Range& range, std::string meaning) {
  return {{name, type_name(dimensions::angle), range.text(), format_default((S{}.*member).radians()),
           std::move(meaning)},
          [=](S& target, const ConfigValue& value) {
            target.*member = Angle::radians(read_quantity(value, name, dimensions::angle, range));
          }};
}

template <class S>
Key<S> integer_key(const std::string& name, int S::*member, int least, int most, std::string meaning) {
  const Range range{.least = static_cast<double>(least), .most = static_cast<double>(most)};
  return {
      {name, "integer", range.text(), std::to_string(S{}.*member), std::move(meaning)},
      [=](S& target, const ConfigValue& value) { target.*member = read_integer(value, name, least, most); }};
}

template <class S>
Key<S> flag_key(const std::string& name, bool S::*member, std::string meaning) {
  return {{name, "true or false", "", S{}.*member ? "true" : "false", std::move(meaning)},
          [=](S& target, const ConfigValue& value) { target.*member = read_flag(value, name); }};
}

/// One of some words; those of its documentation and its default come from the same table.
template <class S, class Value>
Key<S> choice_key(const std::string& name, Value S::*member, const Choices<Value>& choices,
                  std::string meaning) {
  return {{name, quoted_list(names(choices)), "", "\"" + name_of(choices, S{}.*member) + "\"",
           std::move(meaning)},
          [=](S& target, const ConfigValue& value) { target.*member = read_choice(value, name, choices); }};
}

template <class S>
Key<S> text_key(const std::string& name, std::string S::*member, std::string meaning) {
  const std::string fallback = S{}.*member;
  return {{name, "string", "", fallback.empty() ? "" : "\"" + fallback + "\"", std::move(meaning)},
          [=](S& target, const ConfigValue& value) { target.*member = read_text(value, name); }};
}

template <class S>
Key<S> optional_text_key(const std::string& name, std::optional<std::string> S::*member,
                         std::string meaning) {
  return custom_key<S>(name, "string", std::move(meaning),
                       [=](S& target, const ConfigValue& value) { target.*member = read_text(value, name); });
}

template <class S>
Key<S> vector_key(const std::string& name, Eigen::Vector3d S::*member, const Dimension& dimension,
                  std::string meaning) {
  return {{name, "3 of " + type_name(dimension), "", "", std::move(meaning)},
          [=](S& target, const ConfigValue& value) { target.*member = read_vector(value, name, dimension); }};
}

template <class S>
Key<S> vector_key(const std::string& name, std::optional<Eigen::Vector3d> S::*member,
                  const Dimension& dimension, std::string meaning) {
  return {{name, "3 of " + type_name(dimension), "", "", std::move(meaning)},
          [=](S& target, const ConfigValue& value) { target.*member = read_vector(value, name, dimension); }};
}

template <class S>
Key<S> direction_key(const std::string& name, Eigen::Vector3d S::*member, std::string meaning) {
  return {{name, "3 numbers, or \"x\", \"-x\", \"y\", ...", "", "", std::move(meaning)},
          [=](S& target, const ConfigValue& value) { target.*member = read_direction(value, name); }};
}

/// A value of any kind, to be read later.
template <class S>
Key<S> value_key(const std::string& name, const std::string& type, std::optional<ConfigValue> S::*member,
                 std::string meaning) {
  return custom_key<S>(name, type, std::move(meaning),
                       [=](S& target, const ConfigValue& value) { target.*member = value; });
}

/// A key that its section does not have.
class UnknownKey : public Error {
 public:
  UnknownKey(const Error& error, std::string key) : Error(error), key_(std::move(key)) {}
  const std::string& key() const { return key_; }

 private:
  std::string key_;
};

/// "unknown key 'degre' in [discretization] (did you mean 'degree'?)", with the key's place.
UnknownKey unknown_key(const ConfigEntry& entry, const std::string& heading,
                       const std::vector<std::string>& known);

template <class S>
std::vector<std::string> names(const Keys<S>& keys) {
  std::vector<std::string> result;
  for (const Key<S>& key : keys) result.push_back(key.text.name);
  return result;
}

template <class S>
std::vector<KeyText> texts(const Keys<S>& keys) {
  std::vector<KeyText> result;
  for (const Key<S>& key : keys) result.push_back(key.text);
  return result;
}

/// Fills a struct from a table.
/// @param place    of the table, for keys that are missing
/// @param heading  the table's name for messages: "[model]"
/// @throws Error invalid_argument for unknown keys, missing required keys and wrong values, with file, line,
/// column
template <class S>
S read_table(const ConfigTable& table, const Place& place, const std::string& heading, const Keys<S>& keys,
             S result = {}) {
  for (const ConfigEntry& entry : table.entries) {
    const auto key =
        std::find_if(keys.begin(), keys.end(), [&](const Key<S>& k) { return k.text.name == entry.name; });
    if (key == keys.end()) throw unknown_key(entry, heading, names(keys));
    key->read(result, entry.value);
  }
  for (const Key<S>& key : keys)
    if (key.text.required && !table.find(key.text.name))
      throw error_at(place, heading + " lacks the key '" + key.text.name + "': " + key.text.meaning);
  return result;
}

/// A key whose value is a table of its own.
template <class S, class T>
Key<S> table_key(const std::string& name, std::optional<T> S::*member, std::function<const Keys<T>&()> keys,
                 std::string meaning) {
  return {{name, "table, see below", "", "", std::move(meaning)}, [=](S& target, const ConfigValue& value) {
            target.*member = read_table<T>(read_subtable(value, name), value.place, name, keys());
          }};
}

}  // namespace isopatch::app
