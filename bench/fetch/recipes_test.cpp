#include "bench/fetch/recipes.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include "bench/fetch/scan_list.h"
#include "core/file/gzip_writer.h"
#include "core/file/hash.h"
#include "core/file/text_file.h"
#include "core/log/public_log.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/test_bag.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

class Recipes : public ::testing::Test {
 protected:
  Recipes() { std::ofstream(path("piece"), std::ios::binary) << "a\nb\n"; }
  std::string path(const std::string& name) const { return folder_.file(name); }
  MadeFile copied(const std::string& content) const {
    return {.content = sha256(content), .piece = "piece", .by = "copy"};
  }
  TemporaryFolder folder_;
};

TEST_F(Recipes, PackAsTheDescribedFileWas) {
  for (const GzipForm form : {GzipForm::gzip, GzipForm::python}) {
    const std::string packed = gzipped("a\nb\n", form);
    make_file(path("piece"), copied("a\nb\n"), sha256(packed), path("a.gz"));
    EXPECT_EQ(sha256_of_file(path("a.gz")), sha256(packed));
  }
  make_file(path("piece"), copied("a\nb\n"), sha256("packed by nobody we know"), path("b.gz"));
  EXPECT_EQ(read_text_file(path("b.gz")), "a\nb\n");
}

TEST_F(Recipes, PutTheHeaderInFront) {
  MadeFile made = copied("# one\n# two\na\nb\n");
  made.header = {"# one", "# two"};
  make_file(path("piece"), made, made.content, path("a.log"));
  EXPECT_EQ(read_text_file(path("a.log")), "# one\n# two\na\nb\n");
}

TEST_F(Recipes, WriteNothingThatIsNotWhatShallBeInTheFile) {
  EXPECT_INPUT_ERROR(make_file(path("piece"), copied("c\n"), "", path("a.log")),
                     "a.log: what was made of piece is not what shall be in it: its SHA-256 is ");
  EXPECT_FALSE(fs::exists(path("a.log")));
  MadeFile made = copied("a\nb\n");
  made.by = "copi";
  EXPECT_INPUT_ERROR(make_file(path("piece"), made, "", path("a.log")),
                     "there is no way called 'copi' to make it; did you mean 'copy'?");
}

TEST_F(Recipes, ListTheScansOfABag) {
  TestBag bag;
  bag.add("/scan", {.time = 2.5, .range_min = 0.1F, .ranges = {1.2344F, 0.05F, 2.0F, NAN, 7.5F}});
  bag.add("/scan", {.time = 3.0, .ranges = {10.0F, 1.0F, INFINITY, 1.1F, 0.0F}});
  std::ofstream(path("a.bag"), std::ios::binary) << bag.bytes();
  EXPECT_EQ(scan_list(path("a.bag")), "2.500000 5 1.234 0.05 2 0 7.5\n3.000000 5 10 1 0 1.1 0\n");
  EXPECT_EQ(scan_list(path("a.bag"), 1), "2.500000 5 1.234 0.05 2 0 7.5\n");
  std::ofstream(path("b.bag"), std::ios::binary) << TestBag().bytes();
  EXPECT_INPUT_ERROR(scan_list(path("b.bag")), "b.bag");
}

}  // namespace
}  // namespace mapbed
