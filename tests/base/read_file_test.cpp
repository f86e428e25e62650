#include "tools/base/read_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/support/temporary_folder.h"
#include "tools/base/descriptor.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

std::string ErrorOf(const std::string& path, const ReadFileOptions& options) {
    try {
        ReadFile(path, options);
    } catch (const Error& error) {
        return error.what();
    }
    return "read";
}

TEST(ReadFileTest, FilesAreReadWholeUpToTheLimit) {
    const test::TemporaryFolder folder;
    const std::string path = folder.WriteText("f", std::string(1 << 20, 'a') + 'b');
    const std::vector<uint8_t> bytes = ReadFile(path, {"f", (1 << 20) + 1});
    EXPECT_EQ(bytes.size(), size_t{(1 << 20) + 1});
    EXPECT_EQ(bytes.back(), 'b');
    EXPECT_EQ(ReadFile(path, {"f"}), bytes);
    EXPECT_EQ(ErrorOf(path, {"f", 1 << 20}), "f: longer than 1 MiB, the most that is read");
}

TEST(ReadFileTest, WhatIsNoFileIsRefusedUnderTheNameThatIsGiven) {
    EXPECT_EQ(ErrorOf("/dev/zero", {"zero", 3 << 20}), "zero: longer than 3 MiB, the most that is read");
    EXPECT_EQ(ErrorOf("/", {"root"}), "root: a folder; a file is expected");
    EXPECT_EQ(ErrorOf("/none", {"'n'"}), "'n': cannot be read: No such file or directory");
}

TEST(ReadFileTest, StartIsCheckedBeforeTheRestIsRead) {
    const auto refuse = [](std::span<const uint8_t> start) {
        EXPECT_GE(start.size(), 16u);
        throw Error("not this");
    };
    EXPECT_EQ(ErrorOf("/dev/zero", {"zero", uint64_t{1} << 40, refuse}), "not this");
}

TEST(DescriptorTest, IsClosedOnceAndByItsLastOwner) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    Descriptor reader(ends[0]);
    {
        Descriptor writer(ends[1]);
        const Descriptor owner = std::move(writer);
        EXPECT_EQ(writer.Number(), -1);
        EXPECT_TRUE(WriteAll(owner.Number(), std::as_bytes(std::span("ab", 2))));
    }
    EXPECT_EQ(ReadDescriptor(reader.Number(), {"pipe"}), (std::vector<uint8_t>{'a', 'b'}));  // ends: nobody can write
    EXPECT_TRUE(reader.Close());
    EXPECT_EQ(reader.Number(), -1);
    EXPECT_TRUE(reader.Close());
}

}  // namespace
}  // namespace boxcar
