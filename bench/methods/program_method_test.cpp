#include "bench/methods/program_method.h"

#include <fstream>

#include <gmock/gmock.h>

#include "bench/process/child_process.h"
#include "core/file/hash.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::Field;
using ::testing::HasSubstr;

class ProgramMethodFile : public ::testing::Test {
 protected:
  std::string write(const std::string& text, const std::string& name = "my.yaml") const {
    std::ofstream(folder_.file(name)) << text;
    return folder_.file(name);
  }
  ProgramMethod load(const std::string& text, const Settings& settings = {}) const {
    return load_program_method(write(text), settings);
  }
  void expect_refused(const std::string& text, const std::string& message) const {
    EXPECT_INPUT_ERROR(load(text), folder_.file("my.yaml") + message);
  }
  std::string path(const std::string& name) const { return folder_.file(name); }

 private:
  TemporaryFolder folder_;
};

TEST_F(ProgramMethodFile, SaysWhatIsRun) {
  write("gain = 2\n", "settings.ini");
  const ProgramMethod method = load(
      "about: A copy\n"
      "command: [cp, '{log}', '{settings}', 'x{gain}']\n"
      "files: {settings: ./settings.ini}\n"
      "options: {gain: 0.5}\n"
      "log: rawlog\n"
      "trajectory: out/path.txt\n"
      "keep: [out/map.pgm]\n"
      "limit: 2 min\n");
  EXPECT_EQ(method.name, "my");
  EXPECT_EQ(method.about, "A copy");
  EXPECT_THAT(method.command, ElementsAre("cp", "{log}", "{settings}", "x{gain}"));
  EXPECT_EQ(method.files.at("settings"), path("settings.ini"));
  EXPECT_EQ(method.options.at("gain"), "0.5");
  EXPECT_EQ(method.log_format, "rawlog");
  EXPECT_EQ(method.trajectory, "out/path.txt");
  EXPECT_THAT(method.keep, ElementsAre("out/map.pgm"));
  EXPECT_EQ(method.limit, 120.0);
}

TEST_F(ProgramMethodFile, HasADefaultForAllButTheCommand) {
  const ProgramMethod method = load("command: [cp, '{log}', x]\n");
  EXPECT_EQ(method.log_format, "carmen");
  EXPECT_EQ(method.trajectory, "trajectory.tum");
  EXPECT_EQ(method.limit, 3600.0);
  EXPECT_EQ(method.version, "");
}

TEST_F(ProgramMethodFile, IsMadeOfItselfTheProgramAndTheFilesThatItNames) {
  write("x\n", "settings.ini");
  const std::string file =
      write("command: [cp, '{log}', '{settings}']\nfiles: {settings: settings.ini}\n");
  const ProgramMethod method = load_program_method(file);
  EXPECT_THAT(method.input_files, Contains(InputFile{file, sha256_of_file(file)}));
  EXPECT_THAT(method.input_files,
              Contains(InputFile{path("settings.ini"), sha256_of_file(path("settings.ini"))}));
  EXPECT_THAT(method.input_files, Contains(Field(&InputFile::path, program_in_path("cp"))));
}

TEST_F(ProgramMethodFile, NamesTheProgramOfAScript) {
  const ProgramMethod method = load("program: cp\nshell: cp {log} x; false\n");
  EXPECT_TRUE(method.is_shell);
  EXPECT_THAT(method.input_files, Contains(Field(&InputFile::path, EndsWith("/cp"))));
  expect_refused("shell: cp {log} x\n", ":1: does not say which program it is about; add 'program");
}

TEST_F(ProgramMethodFile, LetsItsOptionsBeSet) {
  const std::string text = "command: [cp, '{log}', '{gain}']\noptions: {gain: 1}\n";
  const ProgramMethod method =
      load(text, {{"gain", "3", {"x.yaml", 7}}, {"limit", "1 s", {"x.yaml", 8}}});
  EXPECT_EQ(method.options.at("gain"), "3");
  EXPECT_EQ(method.limit, 1.0);
  EXPECT_THAT(method.complete_yaml(), HasSubstr("gain: 3"));
  EXPECT_THAT(method.complete_yaml(), HasSubstr("limit: 1 s"));
  EXPECT_INPUT_ERROR(load(text, {{"gian", "3", {"x.yaml", 7}}}),
                     "x.yaml:7: unknown key 'gian' in my; did you mean 'gain'?");
  EXPECT_INPUT_ERROR(load(text, {{"limit", "0 s", {"x.yaml", 7}}}), "x.yaml:7: ");
}

TEST_F(ProgramMethodFile, TellsTheVersionThatTheProgramStates) {
  const ProgramMethod method =
      load("command: [cp, '{log}', x]\nversion: [printf, '\\n1.2\\t-3\\n4\\n']\n");
  EXPECT_EQ(method.version, "1.2 -3");
  EXPECT_THAT(method.complete_yaml(), HasSubstr("# a program that states version 1.2 -3\n"));
  EXPECT_EQ(load("command: [cp, '{log}', x]\nversion: ['false']\n").version, "");
  EXPECT_EQ(load("command: [cp, '{log}', x]\nversion: [no_such_program]\n").version, "");
}

TEST_F(ProgramMethodFile, RefusesAKeyThatItDoesNotKnow) {
  expect_refused("command: [cp, '{log}']\ntrajectroy: x\n",
                 ":2: unknown key 'trajectroy' in a method's file; did you mean 'trajectory'?");
}

TEST_F(ProgramMethodFile, RefusesACommandThatCannotBeRun) {
  expect_refused("about: x\n", ":1: needs one of 'command' and 'shell'");
  expect_refused("command: [cp, '{log}']\nshell: cp {log}\n",
                 ":1: needs one of 'command' and 'shell'");
  expect_refused("command: []\n", ":1: names no program");
  expect_refused("command: [cp, x]\n", ":1: has no placeholder '{log}'");
  expect_refused("command: [cp, '{lgo}']\n",
                 ":1: unknown placeholder '{lgo}'; did you mean 'log'?");
  expect_refused("command: ['{log}']\n", ":1: the program's name has a placeholder");
}

TEST_F(ProgramMethodFile, SaysHowToInstallAProgramThatIsNotThere) {
  expect_refused("command: [no_such_slam, '{log}']\ninstall: apt-get install slam-apps\n",
                 ":1: the program 'no_such_slam' is not there, or cannot be run; apt-get install "
                 "slam-apps");
  expect_refused("about: x\nprogram: no_such_slam\nshell: true {log}\n",
                 ":2: the program 'no_such_slam' is not there, or cannot be run; install it, so "
                 "that it is found in PATH");
}

TEST_F(ProgramMethodFile, TakesAProgramBesideIt) {
  write("#!/bin/sh\n", "slam");
  expect_refused("command: [./slam, '{log}']\n", ":1: the program '" + path("slam") + "' is not");
  std::filesystem::permissions(path("slam"), std::filesystem::perms::owner_all);
  const ProgramMethod method = load("command: [./slam, '{log}']\n");
  EXPECT_THAT(method.input_files, Contains(Field(&InputFile::path, path("slam"))));
  EXPECT_EQ(method.command.front(), path("slam")) << "it runs in another folder";
}

TEST_F(ProgramMethodFile, RefusesWrongFilesFormatsAndNames) {
  const std::string command = "command: [cp, '{log}']\n";
  expect_refused(command + "files: {a: none.ini}\n", ":2: 'none.ini' is no file");
  expect_refused(command + "files: {log: my.yaml}\n", ":2: 'log' has a meaning already");
  expect_refused(command + "options: {limit: 3}\n", ":2: 'limit' has a meaning already");
  expect_refused(command + "options: {A b: 3}\n", ":2: 'A b' cannot stand in braces");
  expect_refused(command + "log: carman\n",
                 ":2: unknown format of logs 'carman'; did you mean 'carmen'?");
  expect_refused(command + "trajectory: ../x\n", ":2: '../x' is not below the program's folder");
  expect_refused(command + "keep: [/etc/passwd]\n",
                 ":2: '/etc/passwd' is not below the program's folder");
  expect_refused(command + "limit: 3\n", ":2: ");
  EXPECT_INPUT_ERROR(load_program_method(write(command, "rbpf.yaml")),
                     "its name, 'rbpf', means something else here; rename the file");
  EXPECT_INPUT_ERROR(load_program_method(write(command, "map.yaml")), "rename the file");
  EXPECT_INPUT_ERROR(load_program_method(write(command, "a b.yaml")), "rename the file");
  EXPECT_INPUT_ERROR(load_program_method(path("none.yaml")), "there is no such file");
}

TEST(ProgramMethods, AreToldByPathOrByTheirName) {
  EXPECT_TRUE(is_program_method("./x.yaml"));
  EXPECT_TRUE(is_program_method("odometry_in_python"));
  EXPECT_FALSE(is_program_method("rbpf"));
  EXPECT_EQ(program_method_name("../a/x.yaml"), "x");
}

}  // namespace
}  // namespace mapbed
