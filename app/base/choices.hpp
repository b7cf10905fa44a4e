#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isopatch::app {

/// A word that users write and what it stands for. Words and values belong together here alone: neither the
/// order of a list nor that of an enumeration means anything.
template <class Value>
struct Choice {
  std::string name;
  Value value;
};
template <class Value>
using Choices = std::vector<Choice<Value>>;

template <class Value>
std::vector<std::string> names(const Choices<Value>& choices) {
  std::vector<std::string> result;
  for (const Choice<Value>& choice : choices) result.push_back(choice.name);
  return result;
}

/// @return nullptr for a word that is none of them
template <class Value>
const Value* find_choice(const Choices<Value>& choices, std::string_view name) {
  for (const Choice<Value>& choice : choices)
    if (choice.name == name) return &choice.value;
  return nullptr;
}

/// The first word that stands for a value; "" if none does.
template <class Value>
std::string name_of(const Choices<Value>& choices, const Value& value) {
  for (const Choice<Value>& choice : choices)
    if (choice.value == value) return choice.name;
  return "";
}

/// "\"a\", \"b\" or \"c\"", for documentation.
std::string quoted_list(const std::vector<std::string>& names);

}  // namespace isopatch::app
