#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "bench/cli/testing/command_test.h"

namespace mapbed {

// A sweep over levels of noise with two variants. One is a program that waits from the sixth seed
// on as long as there is a file hold_3, where 3 is the number of the task, and notes it in held_3.
class ShardCommand : public CommandTest {
 protected:
  explicit ShardCommand(int seeds = 12);  // of each there are four runs

  Outcome run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"run", "./sweep.yaml", "--out", "r"});
    return call(arguments);
  }
  Outcome shell(const std::string& script) const { return run_shell(script, path()); }
  bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }

  // Waits for it as long as nobody would for a program that works.
  static bool comes_true(const std::function<bool()>& condition) {
    for (int i = 0; i < 3000; ++i) {
      if (condition()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
  }

  // Everything but cost, provenance and the page that shows them.
  std::map<std::string, std::string> files_in(const std::string& folder) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path(folder))) {
      const std::string name = std::filesystem::relative(entry.path(), path(folder)).string();
      const bool differs = name == "cost.csv" || name == "provenance.json" || name == "report.html";
      if (entry.is_regular_file() && !differs) files[name] = text(folder + "/" + name);
    }
    return files;
  }
  void expect_as_on_one_machine() const {
    ASSERT_EQ(call({"run", "./sweep.yaml", "-j", "2", "--out", "whole"}).status, 0);
    const auto files = files_in("r");
    for (const auto& [name, content] : files_in("whole")) {
      ASSERT_TRUE(files.contains(name)) << name;
      EXPECT_TRUE(files.at(name) == content) << name;
    }
    EXPECT_EQ(files.size(), files_in("whole").size());
    EXPECT_TRUE(exists("r/report.html"));
    EXPECT_FALSE(exists("r/shards"));
  }
};

}  // namespace mapbed
