#include "app/problem/patch_file.hpp"

#include <cstdint>
#include <type_traits>
#include <vector>

#include "app/problem/stored_texts.hpp"
#include "geometry/base/error.hpp"
#include "geometry/io/hdf5_patch_set.hpp"

namespace isopatch::app {
namespace {

using segmentation::ParameterizationReport;

const std::string patches_group = "/isopatch_patches";

/// A report as three sequences, in the order in which `visit` comes by its members.
struct Sequences {
  std::vector<double> numbers;
  std::vector<std::int64_t> integers;
  std::vector<std::string> texts;
};

class Pack {
 public:
  void number(const double& value) { sequences.numbers.push_back(value); }
  void text(const std::string& value) { sequences.texts.push_back(value); }
  template <class Integer>
  void integer(const Integer& value) {
    sequences.integers.push_back(static_cast<std::int64_t>(value));
  }
  template <class Items>
  void resize(const Items& items) {
    sequences.integers.push_back(static_cast<std::int64_t>(items.size()));
  }

  Sequences sequences;
};

class Unpack {
 public:
  explicit Unpack(Sequences sequences) : sequences_(std::move(sequences)) {}
  void number(double& value) { value = next(sequences_.numbers, number_); }
  void text(std::string& value) { value = next(sequences_.texts, text_); }
  template <class Integer>
  void integer(Integer& value) {
    value = static_cast<Integer>(next(sequences_.integers, integer_));
  }
  /// What is counted takes at least one entry of some sequence each.
  template <class Items>
  void resize(Items& items) {
    const std::int64_t count = next(sequences_.integers, integer_);
    const auto most = static_cast<std::int64_t>(sequences_.numbers.size() + sequences_.integers.size() +
                                                sequences_.texts.size());
    if (count < 0 || count > most) throw Error(ErrorCode::bad_format, "the report of the patches is damaged");
    items.resize(static_cast<std::size_t>(count));
  }

 private:
  template <class Item>
  static const Item& next(const std::vector<Item>& items, std::size_t& at) {
    if (at >= items.size()) throw Error(ErrorCode::bad_format, "the report of the patches is cut off");
    return items[at++];
  }
  Sequences sequences_;
  std::size_t number_ = 0, integer_ = 0, text_ = 0;
};

template <class Archive, class Vector>
void visit_vector(Archive& archive, Vector& vector) {
  for (Eigen::Index i = 0; i < vector.size(); ++i) archive.number(vector[i]);
}

template <class Archive, class Numbers>
void visit_numbers(Archive& archive, Numbers& numbers) {
  archive.resize(numbers);
  for (auto& number : numbers) archive.number(number);
}

template <class Archive, class Patch>
void visit_patch(Archive& archive, Patch& patch) {
  archive.text(patch.name);
  auto& certificate = patch.certificate;
  archive.integer(certificate.sign);
  archive.number(certificate.lower);
  archive.number(certificate.upper);
  visit_vector(archive, certificate.parameter);
  visit_vector(archive, certificate.place);
  archive.number(certificate.smallest);
  archive.number(patch.quality.min_scaled_jacobian);
  archive.number(patch.quality.mean_scaled_jacobian);
  archive.number(patch.quality.min_jacobian);
  visit_vector(archive, patch.quality.worst_parameter);
  bool folds = patch.folded_edge.has_value();
  archive.integer(folds);
  if constexpr (!std::is_const_v<Patch>)
    if (folds) patch.folded_edge.emplace();
  if (folds) {
    visit_vector(archive, patch.folded_edge->parameter);
    visit_vector(archive, patch.folded_edge->place);
    archive.number(patch.folded_edge->scaled_jacobian);
  }
  for (auto& count : patch.histogram) archive.integer(count);
  archive.number(patch.volume);
  archive.integer(patch.control_points);
  archive.integer(patch.certified_before);
  archive.integer(patch.moved);
}

template <class Archive, class Face>
void visit_face(Archive& archive, Face& face) {
  archive.text(face.name);
  archive.integer(face.kind);
  archive.number(face.deviation);
  archive.number(face.gap);
  archive.number(face.off_edges);
  archive.resize(face.uses);
  for (auto& use : face.uses) {
    archive.integer(use.side.block.value);
    archive.integer(use.side.side);
    archive.integer(use.orientation.swapped);
    archive.integer(use.orientation.flip_first);
    archive.integer(use.orientation.flip_second);
  }
  visit_numbers(archive, face.deviations.s);
  visit_numbers(archive, face.deviations.t);
  std::vector<double> values(face.deviations.values.begin(), face.deviations.values.end());
  visit_numbers(archive, values);
  if constexpr (!std::is_const_v<Face>)
    face.deviations.values =
        Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

template <class Archive, class Report>
void visit_report(Archive& archive, Report& report) {
  archive.number(report.size);
  archive.number(report.tolerance);
  archive.integer(report.max_spans);
  archive.resize(report.patches);
  for (auto& patch : report.patches) visit_patch(archive, patch);
  archive.resize(report.faces);
  for (auto& face : report.faces) visit_face(archive, face);
  archive.resize(report.warnings);
  for (auto& warning : report.warnings) archive.text(warning);
  archive.number(report.largest_gap);
  archive.text(report.gap_at);
  archive.integer(report.rounds);
  archive.integer(report.evaluations);
  archive.number(report.seconds);
}

}  // namespace

std::string patch_file_bytes(const segmentation::Parameterization& patches) {
  Pack pack;
  visit_report(pack, patches.report);
  geometry::Hdf5Writer file;
  geometry::write_patch_set(file, patches_group + "/patch_set", patches.patches);
  file.write(patches_group + "/report/numbers", pack.sequences.numbers);
  file.write(patches_group + "/report/integers", pack.sequences.integers);
  write_texts(file, patches_group + "/report/texts", pack.sequences.texts);
  return file.image();
}

segmentation::Parameterization read_patch_file(const std::filesystem::path& path) {
  const geometry::Hdf5Reader file(path);
  const Eigen::VectorXd numbers = file.vector(patches_group + "/report/numbers");
  Unpack unpack({{numbers.begin(), numbers.end()},
                 file.integers(patches_group + "/report/integers"),
                 read_texts(file, patches_group + "/report/texts")});
  segmentation::Parameterization result{geometry::read_patch_set(file, patches_group + "/patch_set"), {}};
  visit_report(unpack, result.report);
  return result;
}

}  // namespace isopatch::app
