#pragma once

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "bench/cli/program_under_test.h"
#include "core/file/text_file.h"
#include "core/testing/temporary_folder.h"

namespace mapbed {

// Wrong input ends with status 1 and one line, which has `message` in it.
inline void expect_refused(const Outcome& outcome, const std::string& message) {
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, ::testing::StartsWith("mapbed: "));
  EXPECT_THAT(outcome.err, ::testing::HasSubstr(message));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

// The program itself, called in an empty folder.
class CommandTest : public ::testing::Test {
 protected:
  std::string path(const std::string& name = ".") const { return folder_.file(name); }
  std::string text(const std::string& name) const { return read_text_file(path(name)); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
  }
  Outcome call(const std::vector<std::string>& arguments) const {
    return run_mapbed(arguments, path());
  }
  void expect_refusal(const std::vector<std::string>& arguments, const std::string& message) const {
    expect_refused(call(arguments), message);
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace mapbed
