#include "core/log/bags/bag_folder.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class FolderOfABag : public ::testing::Test {
 protected:
  void add(const std::string& name, const std::string& text = "x") const {
    std::ofstream(folder_.file(name)) << text;
  }
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const std::string& file : bag_folder(folder_.file(".")).files)
      names.push_back(std::filesystem::path(file).filename().string());
    return names;
  }

  TemporaryFolder folder_;
};

TEST_F(FolderOfABag, HasTheFilesThatItsMetadataNameInTheirOrder) {
  for (const char* name : {"a_0.db3", "a_1.db3", "of_another_day.db3"}) add(name);
  add("metadata.yaml",
      "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: sqlite3\n"
      "  relative_file_paths:\n    - a_1.db3\n    - drive/a_0.db3\n    - a_2.db3\n    - a_3.db3\n"
      "  topics_with_message_count:\n    - topic_metadata:\n        name: /scan\n"
      "        offered_qos_profiles: \"- history: 3\\n  depth: 0\"\n      message_count: 3\n"
      "  compression_format: \"\"\n");
  EXPECT_THAT(names(), ElementsAre("a_1.db3", "a_0.db3"));
  EXPECT_THAT(bag_folder(folder_.file(".")).remark,
              HasSubstr("'a_2.db3', 'a_3.db3' of metadata.yaml: not there"));
}

TEST_F(FolderOfABag, WithoutMetadataHasThePartsOfOneBagByTheirNumbers) {
  for (const char* name : {"a_10.mcap", "a_2.mcap", "a_0.mcap", "notes.txt"}) add(name);
  EXPECT_THAT(names(), ElementsAre("a_0.mcap", "a_2.mcap", "a_10.mcap"));
}

TEST_F(FolderOfABag, OfSeveralBagsIsRefused) {
  add("monday.mcap");
  add("tuesday.mcap");
  EXPECT_INPUT_ERROR(bag_folder(folder_.file(".")),
                     "holds several bags: monday.mcap, tuesday.mcap; name one of them");
}

TEST_F(FolderOfABag, IsNoneWithoutSuchFiles) {
  add("notes.txt");
  EXPECT_THAT(names(), IsEmpty());
}

}  // namespace
}  // namespace mapbed
