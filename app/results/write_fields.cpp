#include "app/results/write_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "app/base/engineering_units.hpp"
#include "app/problem/face_name.hpp"
#include "app/results/output_directory.hpp"
#include "geometry/io/vtk_collection.hpp"
#include "iga/output/bezier_output.hpp"
#include "iga/output/hexahedra_output.hpp"

namespace isopatch::app {
namespace {

constexpr std::size_t most_blocks = 100;
// The Bezier cells' numbers above this size are written in single precision unless the study says otherwise.
constexpr std::int64_t most_bytes_in_full = 1'000'000'000;

/// Patches that are one block of a collection.
struct Block {
  std::string group, name;
  std::string file;  ///< ending of the files' names
  std::vector<int> patches;
};

std::vector<Block> blocks_of(const iga::ElasticField& field) {
  const std::vector<int> material = iga::material_numbers(field);
  const int materials = *std::max_element(material.begin(), material.end()) + 1;
  const bool by_patch = material.size() <= most_blocks;
  const bool by_material = static_cast<std::size_t>(materials) <= most_blocks;
  std::vector<Block> result;
  std::set<std::string> names;
  for (int m = 0; m < (by_material ? materials : 1); ++m) {
    const auto first =
        static_cast<std::size_t>(std::find(material.begin(), material.end(), m) - material.begin());
    std::string name = by_material ? field.materials[first].name : "patches";
    if (name.empty() || !names.insert(name).second) name = fmt::format("material {}", m);
    std::vector<int> patches;
    for (std::size_t p = 0; p < material.size(); ++p)
      if (!by_material || material[p] == m) patches.push_back(static_cast<int>(p));
    if (by_patch)
      for (const int p : patches)
        result.push_back({name, fmt::format("patch {}", p), fmt::format("patch_{:03d}.vtu", p), {p}});
    else
      result.push_back(
          {name, fmt::format("{} patches", patches.size()), fmt::format("patches_{:03d}.vtu", m), patches});
  }
  return result;
}

std::string to_vtm(const std::vector<Block>& blocks, const std::string& prefix) {
  std::vector<geometry::VtkGroup> groups;
  for (const Block& block : blocks) {
    if (groups.empty() || groups.back().name != block.group) groups.push_back({block.group, {}});
    groups.back().blocks.push_back({block.name, prefix + block.file});
  }
  return geometry::to_vtm(groups);
}

geometry::Precision chosen(FieldPrecision precision, const iga::ElasticField& field) {
  const bool full = precision == FieldPrecision::full || (precision == FieldPrecision::automatic &&
                                                          iga::bezier_bytes(field) <= most_bytes_in_full);
  return full ? geometry::Precision::full : geometry::Precision::single;
}

// Elements of large models are small.
int automatic_pieces(const iga::ElasticField& field) {
  std::int64_t elements = 0;
  for (const auto& patch : field.patches)
    elements += std::int64_t{patch.knots(0).element_count()} * patch.knots(1).element_count() *
                patch.knots(2).element_count();
  return elements <= 100'000 ? 4 : elements <= 1'000'000 ? 2 : 1;
}

/// The faces of regions, in the model's own naming; regions that act on none are left out.
std::vector<geometry::Boundary> named_faces(const std::vector<SummarizedRegion>& regions,
                                            const geometry::MultiPatch& model) {
  std::vector<geometry::Boundary> result;
  for (const SummarizedRegion& region : regions) {
    geometry::Boundary boundary{region.name, {}};
    for (const std::string& label : region.faces)
      boundary.faces.push_back(model.from_input(side_named(label, model.patch_count())));
    if (!boundary.faces.empty()) result.push_back(std::move(boundary));
  }
  return result;
}

}  // namespace

std::vector<FaceGroup> face_groups(const geometry::MultiPatch& model, const RunSummary& summary) {
  return {{"supports", named_faces(summary.supports, model)},
          {"loads", named_faces(summary.loads, model)},
          {"boundaries", model.boundaries()}};
}

WrittenFields write_fields(const iga::ElasticField& field, const geometry::MultiPatch& model,
                           const std::vector<FaceGroup>& groups, const FieldOptions& options,
                           const std::filesystem::path& directory, const Progress& progress) {
  remove_earlier_fields(directory);
  const std::vector<Block> blocks = blocks_of(field);
  WrittenFields written;
  const auto write = [&](const std::string& file, const auto& content) {
    write_in_places(directory, file, content);
    ++written.files;
  };
  const auto collect = [&](const std::string& file, const std::string& content) {
    write_in(directory, file, content);
    written.collections.push_back(file);
    ++written.files;
  };
  const auto for_each_block = [&](const char* phase, const auto& visit) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      progress(phase, static_cast<double>(i) / static_cast<double>(blocks.size()));
      visit(blocks[i]);
    }
  };

  const iga::HexahedraOutput output =
      options.pieces > 0 ? iga::HexahedraOutput(field, model, options.pieces)
                         : iga::HexahedraOutput(field, model, automatic_pieces(field), iga::FitOptions{});
  written.fit = output.fit();
  for_each_block("writing the fields", [&](const Block& block) {
    write("fields/" + block.file, [&](const geometry::PlacedByteSink& sink) {
      written.borrowed.add(output.write(block.patches, sink));
    });
  });
  collect("results.vtm", to_vtm(blocks, "fields/"));

  progress("writing the boundaries", 0);
  std::vector<geometry::VtkGroup> boundaries;
  int number = 0;
  for (const FaceGroup& group : groups) {
    if (!group.members.empty()) boundaries.push_back({group.name, {}});
    for (const geometry::Boundary& member : group.members) {
      const std::string file = fmt::format("fields/boundary_{:03d}.vtu", number++);
      write(file, [&](const geometry::PlacedByteSink& sink) { output.write_faces(member.faces, sink); });
      boundaries.back().blocks.push_back({member.name, file});
    }
  }
  if (!boundaries.empty()) collect("results_boundaries.vtm", geometry::to_vtm(boundaries));

  if (!options.exact) return written;
  const geometry::Precision precision = chosen(options.precision, field);
  for_each_block("writing the exact fields", [&](const Block& block) {
    write("fields/exact_" + block.file, [&](const geometry::PlacedByteSink& sink) {
      iga::write_bezier_cells(field, block.patches, sink, precision);
    });
  });
  collect("results_exact.vtm", to_vtm(blocks, "fields/exact_"));
  return written;
}

std::optional<Warning> borrowed_warning(const iga::BorrowedStress& borrowed, double model_size) {
  if (borrowed.count == 0) return std::nullopt;
  return Warning{
      fmt::format(
          "{} of the {} points of results.vtm lie where a patch is folded or nearly so, the worst in "
          "patch {} at {} (scaled Jacobian {:.2g}); they show the stress of the nearest good point inside",
          with_separators(borrowed.count), with_separators(borrowed.of), borrowed.patch,
          place_with_unit(borrowed.place, model_size), borrowed.scaled_jacobian),
      borrowed.patch, borrowed.place};
}

std::optional<Warning> fit_warning(const std::optional<iga::FitReport>& fit, double model_size) {
  if (!fit || !(fit->off > iga::FitOptions{}.tolerance)) return std::nullopt;
  return Warning{
      fmt::format(
          "between the nodes of results.vtm von Mises stress is off by up to {:.2g} % of the largest, in "
          "patch {} at {}; its nodes are right. Finer elements there or a larger output.pieces mend it, "
          "unless the patch is nearly folded there",
          100 * fit->off, fit->patch, place_with_unit(fit->place, model_size)),
      fit->patch, fit->place};
}

}  // namespace isopatch::app
