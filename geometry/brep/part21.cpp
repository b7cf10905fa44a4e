#include "geometry/brep/part21.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/base/error.hpp"
#include "geometry/brep/internal/part21_scanner.hpp"

namespace isopatch::geometry {
namespace {

using TokenKind = Part21Token::Kind;

constexpr int deepest = 200;

bool is_irregular(std::string_view number) {
  return number.find('e') != number.npos ||
         (number.find('E') != number.npos && number.find('.') == number.npos);
}

/// The values up to the bracket that closes; the one that opens has been read.
/// @param visit  gets each token that is a value or a bracket
template <class Visit>
void pass_values(Part21Scanner& scanner, const Visit& visit) {
  int depth = 1;
  bool wants_value = true, may_be_empty = true;
  while (depth > 0) {
    const Part21Token token = scanner.next();
    const auto shown = token.bytes.substr(0, 40);
    if (token.kind == TokenKind::end) scanner.fail(token.line, "the entity does not end");
    visit(token);
    if (token.is(')')) {
      if (wants_value && !may_be_empty) scanner.fail(token.line, "a value is missing before ')'");
      --depth;
      wants_value = may_be_empty = false;
    } else if (token.is(',')) {
      if (wants_value) scanner.fail(token.line, "a value is missing before ','");
      wants_value = true;
      may_be_empty = false;
    } else if (!wants_value) {
      scanner.fail(token.line, fmt::format("',' or ')' is expected where '{}' stands", shown));
    } else if (token.is('(') || token.kind == TokenKind::word) {
      if (token.kind == TokenKind::word && !scanner.next().is('('))
        scanner.fail(token.line, fmt::format("'{}' is no value", shown));
      if (++depth > deepest) scanner.fail(token.line, "more than 200 brackets in one another");
      may_be_empty = true;
    } else if (token.kind == TokenKind::sign && !token.is('$') && !token.is('*')) {
      scanner.fail(token.line, fmt::format("'{}' is no value", shown));
    } else {
      wants_value = may_be_empty = false;
    }
  }
}

Part21Value value_of(const Part21Token& token) {
  Part21Value value;
  switch (token.kind) {
    case TokenKind::number:
      value.kind = Part21Value::Kind::number;
      value.number = token.number;
      break;
    case TokenKind::reference:
      value.kind = Part21Value::Kind::reference;
      value.reference = token.reference;
      break;
    case TokenKind::text:
      value.kind = Part21Value::Kind::text;
      value.text = std::string(token.bytes.substr(1, token.bytes.size() - 2));
      break;
    case TokenKind::enumeration:
      value.kind = Part21Value::Kind::enumeration;
      value.text = std::string(token.bytes.substr(1, token.bytes.size() - 2));
      break;
    case TokenKind::binary:
      value.kind = Part21Value::Kind::binary;
      break;
    default:
      value.kind = token.is('*') ? Part21Value::Kind::derived : Part21Value::Kind::omitted;
  }
  return value;
}

// Of a body that has been checked.
std::vector<Part21Value> values_of(Part21Scanner& scanner) {
  std::vector<Part21Value> result;
  for (Part21Token token = scanner.next(); !token.is(')') && token.kind != TokenKind::end;
       token = scanner.next()) {
    if (token.is(',')) continue;
    if (token.is('(')) {
      result.emplace_back().kind = Part21Value::Kind::list;
      result.back().items = values_of(scanner);
    } else if (token.kind == TokenKind::word) {
      scanner.next();
      result.emplace_back().kind = Part21Value::Kind::typed;
      result.back().text = std::string(token.bytes);
      result.back().items = values_of(scanner);
    } else {
      result.push_back(value_of(token));
    }
  }
  return result;
}

}  // namespace

Part21File::Part21File(std::string_view text, const std::string& source) : text_(text), source_(source) {
  Part21Scanner scanner(text, source);
  if (!scanner.next().is("ISO-10303-21"))
    throw Error(ErrorCode::bad_format,
                source + ": this is no STEP file: it does not begin with ISO-10303-21");
  bool in_data = false, ended = false;
  for (Part21Token token = scanner.next(); token.kind != TokenKind::end && !ended; token = scanner.next()) {
    if (token.is("ENDSEC")) {
      if (in_data) end_of_data_ = token.begin;
      in_data = false;
    } else if (token.is("DATA")) {
      in_data = true;
    } else if (token.is("END-ISO-10303-21")) {
      ended = true;
    } else if (in_data && token.kind == TokenKind::reference) {
      add_instance(scanner, token);
    }
  }
  if (!ended)
    throw Error(ErrorCode::bad_format,
                source + ": the file is cut short: its last line, END-ISO-10303-21, is missing");
  if (instances_.empty()) throw Error(ErrorCode::bad_format, source + ": the STEP file has no data");
}

void Part21File::add_instance(Part21Scanner& scanner, const Part21Token& start) {
  Part21Instance instance;
  instance.id = start.reference;
  instance.line = start.line;
  scanner.set_entity(fmt::format("#{}", instance.id));
  if (!scanner.next().is('=')) scanner.fail(start.line, "'=' is missing");
  const Part21Token first = scanner.next();
  instance.references_begin = references_.size();
  if (first.kind == TokenKind::word) {
    instance.type = first.bytes;
    add_entity(scanner, instance.id, first);
  } else if (first.is('(')) {
    Part21Token type = scanner.next();
    for (; type.kind == TokenKind::word; type = scanner.next()) add_entity(scanner, instance.id, type);
    if (!type.is(')')) scanner.fail(type.line, fmt::format("'{}' is no entity", type.bytes.substr(0, 40)));
  } else {
    scanner.fail(first.line, fmt::format("'{}' is no entity", first.bytes.substr(0, 40)));
  }
  const Part21Token end = scanner.next();
  if (!end.is(';')) scanner.fail(end.line, "';' is missing at its end");
  instance.references_end = references_.size();
  instance.body = text_.substr(first.begin, end.begin - first.begin);
  if (!by_id_.emplace(instance.id, instances_.size()).second)
    scanner.fail(instance.line,
                 fmt::format("this number is there before, in line {}", find(instance.id)->line));
  largest_id_ = std::max(largest_id_, instance.id);
  instances_.push_back(instance);
  scanner.set_entity("");
}

void Part21File::add_entity(Part21Scanner& scanner, std::int64_t id, const Part21Token& type) {
  scanner.set_entity(fmt::format("#{} = {}", id, type.bytes));
  if (!scanner.next().is('(')) scanner.fail(type.line, "'(' is missing");
  pass_values(scanner, [&](const Part21Token& seen) {
    if (seen.kind == TokenKind::reference) references_.push_back(seen.reference);
    if (seen.kind == TokenKind::number && is_irregular(seen.bytes)) irregular_numbers_.push_back(seen.bytes);
  });
}

const Part21Instance* Part21File::find(std::int64_t id) const {
  const auto found = by_id_.find(id);
  return found == by_id_.end() ? nullptr : &instances_[found->second];
}

std::vector<std::int64_t> Part21File::references(const Part21Instance& instance) const {
  return {references_.begin() + std::ptrdiff_t(instance.references_begin),
          references_.begin() + std::ptrdiff_t(instance.references_end)};
}

std::string Part21File::place(const Part21Instance& instance) const {
  const std::string_view type = instance.type.empty() ? instance.body.substr(0, 30) : instance.type;
  return fmt::format("line {}: #{} = {}", instance.line, instance.id, type);
}

std::vector<std::string> Part21File::unknown_references() const {
  std::vector<std::string> result;
  for (const Part21Instance& instance : instances_)
    for (std::size_t i = instance.references_begin; i < instance.references_end; ++i)
      if (!by_id_.contains(references_[i]))
        result.push_back(
            fmt::format("{} refers to #{}, which is not in the file", place(instance), references_[i]));
  return result;
}

std::vector<Part21Record> Part21File::records(const Part21Instance& instance) const {
  std::vector<Part21Record> result;
  Part21Scanner scanner(instance.body, source_, instance.line);
  Part21Token token = scanner.next();
  if (token.is('(')) token = scanner.next();
  for (; token.kind == TokenKind::word; token = scanner.next()) {
    scanner.next();
    result.push_back({std::string(token.bytes), values_of(scanner)});
  }
  return result;
}

const Part21Record* record_of(const std::vector<Part21Record>& records, std::string_view type) {
  for (const Part21Record& found : records)
    if (found.type == type) return &found;
  return nullptr;
}

std::vector<std::string_view> Part21File::texts() const {
  std::vector<std::string_view> result;
  Part21Scanner scanner(text_, source_);
  for (Part21Token token = scanner.next(); token.kind != TokenKind::end; token = scanner.next())
    if (token.kind == TokenKind::text) result.push_back(token.bytes.substr(1, token.bytes.size() - 2));
  return result;
}

}  // namespace isopatch::geometry
