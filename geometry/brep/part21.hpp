#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace isopatch::geometry {

class Part21Scanner;
struct Part21Token;

/// A value of a STEP file's data.
struct Part21Value {
  enum class Kind { omitted, derived, number, text, enumeration, reference, binary, list, typed };
  Kind kind = Kind::omitted;
  double number = 0;                    ///< of a number
  std::int64_t reference = 0;           ///< the instance referred to
  std::string text;                     ///< of a text as the file has it; name of an enumeration or a type
  std::vector<Part21Value> items = {};  ///< of a list, or what a typed value holds
};

/// One entity of an instance: CARTESIAN_POINT('',(0.,0.,0.)).
struct Part21Record {
  std::string type;
  std::vector<Part21Value> values;
};

/// The first one of a type; nothing where there is none.
const Part21Record* record_of(const std::vector<Part21Record>& records, std::string_view type);

/// An instance of the data section: where "#12=" stands, and what follows up to its semicolon.
struct Part21Instance {
  std::int64_t id = 0;
  int line = 0;           ///< from 1
  std::string_view type;  ///< of a simple one; "" of a complex one, which has several
  std::string_view body;  ///< from the type's first letter (or the bracket) up to the semicolon, without it
  std::size_t references_begin = 0, references_end = 0;  ///< in `Part21File::references`
};

/// The data of a STEP file (ISO 10303-21), checked token by token.
///
/// The text must outlive it. CAD kernels read on where a token is none: "1.2.3" and "1.#IND" become some
/// number and an unknown reference becomes nothing, so this stands before them.
/// @cost  one pass over the text, about 100 MB/s
class Part21File {
 public:
  /// @throws Error bad_format  with "source:line: " and the entity: no STEP file, a token that is none, a
  /// bracket or a text that does not end, an instance that is there twice, a missing end
  Part21File(std::string_view text, const std::string& source);

  std::string_view text() const { return text_; }
  const std::string& source() const { return source_; }
  const std::vector<Part21Instance>& instances() const { return instances_; }
  /// Nothing if there is none.
  const Part21Instance* find(std::int64_t id) const;
  /// What an instance refers to, in order.
  std::vector<std::int64_t> references(const Part21Instance& instance) const;
  /// References to instances that are not there, as "line 12: #45 = OFFSET_SURFACE refers to #99, which is
  /// not in the file".
  std::vector<std::string> unknown_references() const;
  /// The entities of an instance, read in full.
  std::vector<Part21Record> records(const Part21Instance& instance) const;
  /// "line 12: #45 = PLANE".
  std::string place(const Part21Instance& instance) const;
  /// Where the last data section ends: in front of its ENDSEC.
  std::size_t end_of_data() const { return end_of_data_; }
  /// Numbers that CAD libraries do not take for numbers, though they are: "1e-3" for 1.E-3, "1E5" for 1.E5.
  const std::vector<std::string_view>& irregular_numbers() const { return irregular_numbers_; }
  /// All texts in quotes, without these, as views of `text()`.
  std::vector<std::string_view> texts() const;
  /// The largest number of an instance.
  std::int64_t largest_id() const { return largest_id_; }

 private:
  void add_instance(Part21Scanner& scanner, const Part21Token& start);
  void add_entity(Part21Scanner& scanner, std::int64_t id, const Part21Token& type);

  std::string_view text_;
  std::string source_;
  std::vector<Part21Instance> instances_;
  std::vector<std::int64_t> references_;
  std::vector<std::string_view> irregular_numbers_;
  std::unordered_map<std::int64_t, std::size_t> by_id_;
  std::size_t end_of_data_ = 0;
  std::int64_t largest_id_ = 0;
};

}  // namespace isopatch::geometry
