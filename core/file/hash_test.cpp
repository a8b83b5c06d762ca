#include "core/file/hash.h"

#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "core/testing/temporary_folder.h"

namespace mapbed {
namespace {

// The examples of FIPS 180-4.
TEST(Sha256, GivesTheStandardsOwnExamples) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, IsTheSameHoweverTheBytesAreCut) {
  const std::string bytes(1'000, 'a');
  for (const std::size_t step : {1u, 55u, 63u, 64u, 65u, 999u}) {
    Sha256 hash;
    for (std::size_t at = 0; at < bytes.size(); at += step) hash.add(bytes.substr(at, step));
    EXPECT_EQ(hash.digits(), sha256(bytes)) << step;
  }
}

TEST(Sha256, OfAFileIsThatOfItsBytes) {
  const TemporaryFolder folder;
  const std::string bytes(200'001, 'x');  // some pieces and a rest
  std::ofstream(folder.file("a")) << bytes;
  EXPECT_EQ(sha256_of_file(folder.file("a")), sha256(bytes));
}

}  // namespace
}  // namespace mapbed
