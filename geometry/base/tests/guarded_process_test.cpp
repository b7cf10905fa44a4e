#include "geometry/base/guarded_process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <thread>

#include "geometry/base/error.hpp"
#include "geometry/base/tests/expect_error.hpp"

namespace isopatch {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using End = GuardedOutcome::End;

GuardedCommand shell(const std::string& script, GuardLimits limits = {.seconds = 20}) {
  return {.program = "/bin/sh", .arguments = {"-c", script}, .limits = limits};
}

TEST(GuardedProcess, GivesInputAndTakesResultLinesAndErrors) {
  std::vector<std::string> lines;
  GuardedCommand command = shell("cat >&3; echo one; echo two; echo oh >&2");
  const std::string input(200'000, 'x');
  command.input = input;
  command.on_line = [&](std::string_view line) { lines.emplace_back(line); };
  const GuardedOutcome outcome = run_guarded(command);
  EXPECT_TRUE(outcome.succeeded());
  EXPECT_EQ(outcome.result, input);
  EXPECT_THAT(lines, ElementsAre("one", "two"));
  EXPECT_EQ(outcome.errors, "oh\n");
}

TEST(GuardedProcess, SaysHowItEnded) {
  const GuardedOutcome code = run_guarded(shell("exit 7"));
  EXPECT_EQ(code.end, End::exited);
  EXPECT_EQ(code.code, 7);
  EXPECT_FALSE(code.succeeded());
  EXPECT_EQ(code.text({}), "ended with code 7");
  const GuardedOutcome signal = run_guarded(shell("kill -SEGV $$"));
  EXPECT_EQ(signal.end, End::signalled);
  EXPECT_EQ(signal.code, SIGSEGV);
  EXPECT_EQ(signal.text({}), "ended by signal 11 (Segmentation fault)");
}

TEST(GuardedProcess, StopsWhatComputesTooLong) {
  const GuardLimits limits{.seconds = 1};
  const GuardedOutcome outcome = run_guarded(shell("while :; do :; done", limits));
  EXPECT_EQ(outcome.end, End::timed_out);
  EXPECT_EQ(outcome.text(limits), "was stopped after 1 s");
}

TEST(GuardedProcess, StopsWhatOnlyWaits) {
  const GuardedOutcome outcome =
      run_guarded({.program = "/bin/sleep", .arguments = {"600"}, .limits = {.seconds = 0.05}});
  EXPECT_EQ(outcome.end, End::timed_out);
}

TEST(GuardedProcess, StopsWhatHasClosedItsStreams) {
  const GuardedOutcome outcome = run_guarded(shell("exec >&- 2>&-; sleep 600", {.seconds = 0.05}));
  EXPECT_EQ(outcome.end, End::timed_out);
}

TEST(GuardedProcess, MemoryIsLimited) {
  // dd asks for a buffer of that size.
  const std::string script = "dd if=/dev/zero of=/dev/null bs=96M count=1 2>/dev/null";
  EXPECT_TRUE(run_guarded(shell(script, {.seconds = 20, .bytes = std::uint64_t(1) << 30})).succeeded());
  EXPECT_FALSE(run_guarded(shell(script, {.seconds = 20, .bytes = std::uint64_t(1) << 26})).succeeded());
}

TEST(GuardedProcess, KeepsOnlyTheEndOfManyErrors) {
  const GuardedOutcome outcome =
      run_guarded(shell("for i in 1 2 3 4 5 6 7 8 9; do printf %01000d $i >&2; done"));
  EXPECT_EQ(outcome.errors.size(), 4000u);
  EXPECT_THAT(outcome.errors, testing::EndsWith("09"));
}

TEST(GuardedProcess, AMissingProgramIsAnError) {
  try {
    run_guarded({.program = "/nowhere/at/all"});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::io);
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/at/all cannot be started: No such file or directory"));
  }
  EXPECT_ERROR(run_guarded({.program = "/bin/true", .limits = {.seconds = 0}}), ErrorCode::invalid_argument,
               "the time limit is 0 s");
}

TEST(GuardedProcess, SeveralThreadsMayGuardAtOnce) {
  std::vector<std::thread> threads;
  std::array<std::string, 4> results;
  for (std::size_t i = 0; i < results.size(); ++i)
    threads.emplace_back(
        [&results, i] { results[i] = run_guarded(shell("echo " + std::to_string(i) + " >&3")).result; });
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(results, ElementsAre("0\n", "1\n", "2\n", "3\n"));
}

TEST(GuardedProcess, EndsItWhenListeningFails) {
  GuardedCommand command = shell("echo line; sleep 600");
  command.on_line = [](std::string_view) { throw std::runtime_error("enough"); };
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THROW(run_guarded(command), std::runtime_error);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(100));
}

}  // namespace
}  // namespace isopatch
