#include <fmt/format.h>
#include <omp.h>

#include "app/tests/program_fixture.hpp"
#include "solvers/blas_core.hpp"
#include "solvers/blas_threads.hpp"

namespace isopatch::app {
namespace {

TEST_F(Program, ALauncherOfAnotherMpiIsNamed) {
  // As if srun had started two without telling MPI how to find each other.
  ::setenv("SLURM_STEP_NUM_TASKS", "2", 1);
  ::setenv("SLURM_PROCID", "0", 1);
  EXPECT_EQ(run({"run", study()}), 2);
  EXPECT_THAT(err_, HasSubstr("2 processes were started that cannot find each other"));
  EXPECT_THAT(err_, HasSubstr("srun --mpi=pmix"));
  // A step that was started from a shell of another one, whose variables are still there.
  ::setenv("PMIX_NAMESPACE", "slurm.pmix.7.0", 1);
  ::setenv("SLURM_JOB_ID", "7", 1);
  ::setenv("SLURM_STEP_ID", "1", 1);
  EXPECT_EQ(run({"run", study()}), 2);
  EXPECT_THAT(err_, HasSubstr("srun --mpi=pmix"));
  ::setenv("SLURM_PROCID", "1", 1);
  EXPECT_EQ(run({"run", study()}), 0);  // the first one speaks
  EXPECT_EQ(err_, "");
  EXPECT_FALSE(fs::exists(results()));
  for (const char* name :
       {"SLURM_STEP_NUM_TASKS", "SLURM_PROCID", "PMIX_NAMESPACE", "SLURM_JOB_ID", "SLURM_STEP_ID"})
    ::unsetenv(name);
}

TEST_F(Program, WarnsOfMoreThreadsThanCores) {
  const int cores = omp_get_num_procs(), before = omp_get_max_threads();
  EXPECT_EQ(run({"run", study(), "-q", "--threads", std::to_string(cores)}), 0);
  EXPECT_EQ(err_, "");
  EXPECT_EQ(run({"run", study(), "-q", "--threads", std::to_string(cores + 1)}), 0);
  EXPECT_THAT(err_, HasSubstr(fmt::format("warning: {} threads on {} core", cores + 1, cores)));
  EXPECT_THAT(err_, HasSubstr(fmt::format("--threads {}\n", cores)));
  omp_set_num_threads(before);
}

TEST_F(Program, CountsTheCoresThatItMayUse) {
  const std::string said = (folder_ / "said").string();
  const auto warning = [&](const std::string& before) {
    EXPECT_EQ(shell(fmt::format("env -u OMP_NUM_THREADS {} {} run {} -q 2> {}", before, ISOPATCH_PROGRAM,
                                study(), said)),
              0);
    return read_file(said);
  };
  EXPECT_EQ(warning("taskset -c 0"), "");
  EXPECT_THAT(warning("taskset -c 0 env OMP_NUM_THREADS=2"), HasSubstr("2 threads on 1 core:"));
  // Binding puts the first thread on one core, which takes none from the others.
  EXPECT_EQ(warning("env OMP_PROC_BIND=true"), "");
}

TEST_F(Program, ThreadsThatWaitSleepUnlessTheUserSaysOtherwise) {
  const auto shown = [&](const std::string& before) {
    const std::string said = (folder_ / "said").string();
    EXPECT_EQ(
        shell(fmt::format("env -u OMP_WAIT_POLICY -u GOMP_SPINCOUNT OMP_DISPLAY_ENV=verbose {} {} --version "
                          "> /dev/null 2> {}",
                          before, ISOPATCH_PROGRAM, said)),
        0);
    return read_file(said);
  };
  EXPECT_THAT(shown(""), HasSubstr("OMP_WAIT_POLICY = 'PASSIVE'"));
  EXPECT_THAT(shown("OMP_WAIT_POLICY=active"), HasSubstr("OMP_WAIT_POLICY = 'ACTIVE'"));
  EXPECT_THAT(shown("GOMP_SPINCOUNT=4321"), HasSubstr("GOMP_SPINCOUNT = '4321'"));
}

TEST_F(Program, TheBlasHasOneThreadOutsideOfFactorizations) {
  if (solvers::blas_threads() == 0) GTEST_SKIP() << "the BLAS is not OpenBLAS";
  solvers::set_blas_threads(2);
  EXPECT_EQ(run({"run", study(), "-q"}), 0);
  EXPECT_EQ(solvers::blas_threads(), 1);
}

TEST_F(Program, TheUserChoosesTheCoreOfTheBlas) {
  if (solvers::blas_core().empty()) GTEST_SKIP() << "the BLAS is not OpenBLAS";
  // Not the best core of any CPU with AVX2, and one of those that are replaced without the variable.
  EXPECT_EQ(
      shell(fmt::format("OPENBLAS_CORETYPE=Nehalem {} --version | grep -qx 'BLAS: OpenBLAS for Nehalem'",
                        ISOPATCH_PROGRAM)),
      0);
}

// The variable may be set where the tests run, so what it is without it is asked of a program of its own.
TEST_F(Program, ChoosesACoreThatSuitsTheCpuByItself) {
  if (solvers::blas_core().empty()) GTEST_SKIP() << "the BLAS is not OpenBLAS";
  const fs::path said = folder_ / "version.txt";
  ASSERT_EQ(shell(fmt::format("env -u OPENBLAS_CORETYPE {} --version > {}", ISOPATCH_PROGRAM, said.string())),
            0);
  const std::string text = read_file(said), before = "BLAS: OpenBLAS for ";
  const auto start = text.find(before);
  ASSERT_NE(start, text.npos) << text;
  const auto from = start + before.size();
  const std::string core = text.substr(from, text.find('\n', from) - from);
  EXPECT_NE(core, "");
  EXPECT_EQ(solvers::better_blas_core(core, solvers::cpu_features()), "") << core;
}

TEST_F(Program, ASecondRunReplacesTheFirstWholly) {
  ASSERT_EQ(run({"run", study(), "-q"}), 0) << err_;
  ASSERT_EQ(run({"compare", study(), "-q"}), 0) << err_;
  write_file(results() / "notes.txt", "mine");
  write_file(results() / "fields/patch_mine.vtu", "mine");
  // One patch instead of two: a field file of the first run would be left beside the new ones.
  ASSERT_EQ(run({"run", study(), "-q", "--set", "model.patches=[1,1,1]"}), 0) << err_;
  // The support, the load and the six sides of the box.
  std::vector<std::string> expected = {"summary.json",         "results.h5",
                                       "report.html",          "compare.json",
                                       "compare.html",         "notes.txt",
                                       "results.vtm",          "results_boundaries.vtm",
                                       "results_exact.vtm",    "fields/patch_mine.vtu",
                                       "fields/patch_000.vtu", "fields/exact_patch_000.vtu"};
  for (int i = 0; i < 8; ++i) expected.push_back(fmt::format("fields/boundary_{:03d}.vtu", i));
  EXPECT_THAT(files_below(results()), testing::UnorderedElementsAreArray(expected));
  EXPECT_EQ(json::parse(read_file(results() / "summary.json"))["model"]["patches"], 1);
  ASSERT_EQ(run({"run", study(), "-q", "--set", "output.fields=false", "--set", "output.hdf5=false", "--set",
                 "output.report=false"}),
            0);
  EXPECT_THAT(files_below(results()),
              testing::UnorderedElementsAre("summary.json", "compare.json", "compare.html", "notes.txt",
                                            "fields/patch_mine.vtu"));
}

TEST_F(Program, AFailedRunLeavesEarlierResultsAlone) {
  ASSERT_EQ(run({"run", study(), "-q"}), 0) << err_;
  const std::string before = read_file(results() / "summary.json");
  EXPECT_NE(run({"run", study(), "-q", "--set", "load.0.faces=[\"x_min\", \"0:east\"]"}), 0);
  EXPECT_EQ(read_file(results() / "summary.json"), before);
  EXPECT_TRUE(fs::exists(results() / "fields/patch_001.vtu"));
}

TEST_F(Program, TheStudySaysHowFineAndHowExactFieldsAre) {
  const std::string hexahedra = "fields/patch_000.vtu", exact = "fields/exact_patch_000.vtu";
  const auto sizes = [&](const std::string& assignment) {
    EXPECT_EQ(run({"run", study(), "-q", "--set", "discretization.refine=2", "--set", assignment}), 0)
        << err_;
    return std::array{static_cast<double>(fs::file_size(results() / hexahedra)),
                      static_cast<double>(fs::file_size(results() / exact))};
  };
  const auto usual = sizes("output.fields=true"), single = sizes("output.precision=single"),
             coarse = sizes("output.pieces=2");
  EXPECT_EQ(single[0], usual[0]);
  EXPECT_LT(single[1], 0.75 * usual[1]);
  EXPECT_LT(coarse[0], 0.25 * usual[0]);
  EXPECT_EQ(coarse[1], usual[1]);
  ASSERT_EQ(run({"run", study(), "-q", "--set", "output.exact=false"}), 0);
  EXPECT_TRUE(fs::exists(results() / hexahedra));
  EXPECT_FALSE(fs::exists(results() / exact));
  EXPECT_FALSE(fs::exists(results() / "results_exact.vtm"));
  EXPECT_EQ(run({"run", study(), "-q", "--set", "output.precision=singel"}), 2);
  EXPECT_THAT(err_, HasSubstr("single"));
  EXPECT_EQ(run({"run", study(), "-q", "--set", "output.pieces=0"}), 2);
  EXPECT_THAT(err_, HasSubstr("pieces"));
}

TEST_F(Program, ReadsStudiesWrittenByWindowsEditors) {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : bar) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  ASSERT_EQ(run_text(text), 0) << err_;
  EXPECT_EQ(json::parse(read_file(results() / "summary.json"))["title"], "bar");
  EXPECT_EQ(run_text(replaced(text, "poisson", "poison")), 2);
  EXPECT_THAT(err_,
              HasSubstr("study.toml:8:1: unknown key 'poison' in [[material]] (did you mean 'poisson'?)"));
  std::string wide = "\xFF\xFE";
  for (const char c : bar) wide += {c, '\0'};
  EXPECT_EQ(run_text(wide), 2);
  EXPECT_THAT(err_, HasSubstr("UTF-16; save it as UTF-8"));
}

TEST_F(Program, AStudyThatIsADirectoryIsRefusedByItsName) {
  EXPECT_EQ(run({"run", folder_.string()}), 3);
  EXPECT_THAT(err_, HasSubstr(folder_.string() + " is a directory; did you mean " + study() + "?"));
  fs::remove(study());
  EXPECT_EQ(run({"run", folder_.string()}), 3);
  EXPECT_THAT(err_, HasSubstr(folder_.string() + " is a directory; give a study's file"));
  EXPECT_EQ(run({"info", folder_.string()}), 3);
  EXPECT_THAT(err_, HasSubstr("Is a directory"));
}

TEST_F(Program, SettingAnUnknownKeyNamesTheNearest) {
  const auto message = [&](const std::string& assignment) {
    EXPECT_EQ(run({"run", study(), "--set", assignment}), 2) << assignment;
    return err_;
  };
  EXPECT_THAT(message("discretization.refin=2"),
              HasSubstr("--set discretization.refin=2: unknown key 'refin' in [discretization] "
                        "(did you mean 'refine'?)"));
  EXPECT_THAT(message("load.0.tracton=[1,0,0]"), HasSubstr("did you mean 'traction'?"));
  EXPECT_THAT(message("discretisation.refine=2"), HasSubstr("did you mean 'discretization'?"));
  EXPECT_THAT(message("loads.0.pressure=2"), HasSubstr("did you mean 'load'?"));
  EXPECT_THAT(message("model.siz=[1,1,1]"), HasSubstr("did you mean 'size'?"));
  EXPECT_THAT(message("load.1.pressure=2"), HasSubstr("'1' is no index of an array of 1"));
}

TEST(ProgramCommands, AnUnknownOneIsNamedWithTheNearest) {
  std::ostringstream out, err;
  EXPECT_EQ(run_program({"rnu", "study.toml"}, {out, err}), 2);
  EXPECT_THAT(err.str(), HasSubstr("unknown command 'rnu' (did you mean 'run'?)"));
}

}  // namespace
}  // namespace isopatch::app
