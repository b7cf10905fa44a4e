#include "app/problem/solid_stages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "app/problem/block_file.hpp"
#include "app/problem/cut_solids.hpp"
#include "app/problem/patch_file.hpp"
#include "app/problem/solid_file.hpp"
#include "app/problem/t_joint_text.hpp"
#include "app/study/file_kind.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/base/content_hash.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "geometry/brep/write_brep.hpp"

namespace isopatch::app {
namespace {

/// Patches that meet in parts of sides are for couplings of faces that do not match: said before they are
/// fitted, which takes longer than the cuts.
void require_side_to_side(const segmentation::HexModel& model) {
  const std::vector<std::string> joints = t_joint_texts(model);
  if (joints.empty()) return;
  throw Error(
      ErrorCode::not_conforming,
      fmt::format("blocks meet in parts of sides (T-joints): {}{}; couple them with coupling.non_matching = "
                  "\"nitsche\" (or \"mortar\", where each has a side that is covered all over), or cut the "
                  "solid with t_joints = \"remove\", the default",
                  joints.front(), joints.size() == 1 ? "" : fmt::format(", and {} more", joints.size() - 1)));
}

bool is_block_file(const BlocksInput& input) {
  return input.files.files.size() == 1 && kind_of(input.files.files.front()) == FileKind::blocks;
}

/// Whether solids are cut, not blocks read.
bool cuts(const BlocksInput& input) {
  return input.decomposition && !input.files.pairs && !is_block_file(input);
}

std::uint64_t key_of_files(const BlocksInput& input) {
  std::uint64_t key = content_hash(input.texts.model, build_stamp());
  std::vector<std::filesystem::path> files = input.files.files;
  if (input.files.pairs) files.push_back(*input.files.pairs);
  for (const std::filesystem::path& file : files)
    key = content_hash(read_file(file), content_hash(file.filename().string(), key));
  return key;
}

/// Patches are no nearer to a solid than that is to the triangles that it was made of; nor coarser than this
/// share of the size for that.
constexpr double coarsest_tolerance = 1e-3;

/// The fit's tolerance where none was asked for.
double suitable_tolerance(const FoundSolids& found, double tolerance) {
  double size = 0, off = 0;
  for (const geometry::BrepFile& solid : found.read.solids) size = std::max(size, solid.brep.size());
  for (const SolidTriangles& triangles : found.triangles) off = std::max(off, triangles.deviation);
  return size > 0 ? std::max(tolerance, std::min(off / size, coarsest_tolerance)) : tolerance;
}

/// A stage that is kept, or is made.
template <class Value>
struct Step {
  StageReport report;
  std::function<Value()> read;
  std::optional<Value> value;

  const Value& get() {
    if (!value) value = read();
    return *value;
  }
};

/// The stages one after the other; what is kept is read only where it is needed.
class SolidStages {
 public:
  SolidStages(const BlocksInput& input, const Progress& progress)
      : input_(input), progress_(progress), folder_(input.stages) {}

  StagedPatches run(Stage to) {
    StagedPatches result;
    const bool cut = cuts(input_);
    std::uint64_t key = folder_.is_used() ? key_of_files(input_) : 0;
    if (cut) {
      make_solids(content_hash(input_.texts.reconstruction, key));
      result.stages.push_back(solids_.report);
      key = content_hash(input_.texts.segmentation, after(solids_.report));
    }
    if (to >= Stage::hexahedra) {
      make_blocks(content_hash(fmt::format("{}", input_.files.assembly.same_point), key));
      if (!is_block_file(input_)) result.stages.push_back(blocks_.report);
      key = is_block_file(input_) ? key : after(blocks_.report);
    }
    if (to >= Stage::patches) {
      make_patches(
          content_hash(input_.texts.parameterization + (input_.options.keep_t_joints ? "\nkept" : ""), key));
      result.stages.push_back(patches_.report);
      result.made = patches_.get();
      result.made->report.names = input_.options.names;
    }
    return result;
  }

 private:
  /// Of a result and the program.
  static std::uint64_t after(const StageReport& report) {
    return content_hash(fmt::format("{:x}", report.content), build_stamp());
  }

  template <class Value, class Make, class Bytes>
  Step<Value> step(Stage stage, std::uint64_t key, Value (*read)(const std::filesystem::path&), Make make,
                   Bytes bytes) {
    if (auto kept = folder_.kept(stage, key)) {
      progress_(fmt::format("{}: as before, from {}", name_of(stage_choices(), stage), kept->file.string()),
                1);
      return {*kept, [read, file = kept->file] { return read(file); }, {}};
    }
    const Stopwatch watch;
    Value value = make();
    StageReport report{.stage = stage, .seconds = watch.seconds()};
    if (folder_.is_used()) report = folder_.keep(stage, key, bytes(value), report.seconds);
    return {report, {}, std::move(value)};
  }

  void make_solids(std::uint64_t key) {
    solids_ = step<FoundSolids>(
        Stage::solid, key, read_solid_file, [&] { return solids_of_files(input_, progress_); },
        solid_file_bytes);
    if (!solids_.report.kept && !solids_.report.file.empty()) write_step();
  }

  /// The solid that was made of triangles, for other programs; none of an earlier run stays.
  void write_step() {
    const std::filesystem::path file = input_.stages.folder / solid_step_name;
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    const FoundSolids& found = solids_.get();
    if (found.triangles.size() != 1 || found.read.solids.size() != 1) return;
    try {
      geometry::write_brep(file, found.read.solids.front().brep);
    } catch (const Error& error) {
      solids_.report.problem = error.what();
    }
  }

  void make_blocks(std::uint64_t key) {
    if (is_block_file(input_)) {
      blocks_ = {{}, [&] { return read_block_file(input_.files.files.front()); }, {}};
      return;
    }
    const auto make = [&] {
      if (!cuts(input_)) return segmentation::read_blocks(input_.files, progress_);
      return put_together(cut_solids(solids_.get().read, *input_.decomposition, progress_),
                          input_.files.assembly);
    };
    blocks_ = step<segmentation::ReadBlocks>(Stage::hexahedra, key, read_block_file, make, block_file_bytes);
  }

  void make_patches(std::uint64_t key) {
    const auto make = [&] {
      const segmentation::ReadBlocks& blocks = blocks_.get();
      if (!input_.options.keep_t_joints && (input_.decomposition || is_block_file(input_)))
        require_side_to_side(blocks.model);
      segmentation::ParameterizationOptions options = input_.options;
      if (!input_.gives_tolerance && cuts(input_))
        options.fit.tolerance = suitable_tolerance(solids_.get(), options.fit.tolerance);
      segmentation::Parameterization made = segmentation::parameterize(blocks.model, options, progress_);
      made.report.warnings = blocks.warnings;
      return made;
    };
    patches_ =
        step<segmentation::Parameterization>(Stage::patches, key, read_patch_file, make, patch_file_bytes);
  }

  const BlocksInput& input_;
  const Progress& progress_;
  StageFolder folder_;
  Step<FoundSolids> solids_;
  Step<segmentation::ReadBlocks> blocks_;
  Step<segmentation::Parameterization> patches_;
};

}  // namespace

StagedPatches staged_patches(const BlocksInput& input, Stage to, const Progress& progress) {
  progress("reading blocks", 0);
  return SolidStages(input, progress).run(to);
}

}  // namespace isopatch::app
