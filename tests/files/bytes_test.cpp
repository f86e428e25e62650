#include "samples/files/bytes.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <thread>

#include "tests/files/support.h"

namespace boxcar::test {
namespace {

const Bytes kOld = {1, 2, 3};
const Bytes kNew = {4, 5, 6, 7};

mode_t PermissionsOf(const std::string& path) {
    struct stat status = {};
    EXPECT_EQ(::stat(path.c_str(), &status), 0);
    return status.st_mode & 0777;
}

TEST(WriteFileAtomicallyTest, WritesTheBytesAndNothingElse) {
    const TemporaryFolder folder;
    for (const Bytes& bytes : {kNew, Bytes{}, Bytes(5'000'000, 7)}) {
        WriteFileAtomically(folder.Path("f"), bytes);
        EXPECT_EQ(Contents(folder.Path("f")), bytes);
    }
    EXPECT_EQ(folder.Names(), std::vector<std::string>{"f"});
}

TEST(WriteFileAtomicallyTest, NamesMayHaveNoFolder) {
    const TemporaryFolder folder;
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder.Path(""));
    WriteFileAtomically("plain", kNew);
    std::filesystem::current_path(before);
    EXPECT_EQ(Contents(folder.Path("plain")), kNew);
    EXPECT_EQ(folder.Names(), std::vector<std::string>{"plain"});
}

TEST(WriteFileAtomicallyTest, NewFilesHaveThePermissionsOfTheUmask) {
    const TemporaryFolder folder;
    for (const mode_t mask : {0022u, 0077u, 0002u}) {
        const mode_t before = ::umask(mask);
        WriteFileAtomically(folder.Path(fmt::format("{}", mask)), kNew);
        ::umask(before);
        EXPECT_EQ(PermissionsOf(folder.Path(fmt::format("{}", mask))), 0666u & ~mask);
    }
}

TEST(WriteFileAtomicallyTest, AReplacedFileHandsOnItsPermissions) {
    const TemporaryFolder folder;
    const std::string path = folder.Put("f", kOld);
    ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
    WriteFileAtomically(path, kNew);
    EXPECT_EQ(Contents(path), kNew);
    EXPECT_EQ(PermissionsOf(path), 0640u);
}

TEST(WriteFileAtomicallyTest, ReadersOfTheOldFileKeepIt) {
    const TemporaryFolder folder;
    const std::string path = folder.Put("f", kOld);
    const int reader = ::open(path.c_str(), O_RDONLY);
    WriteFileAtomically(path, kNew);
    uint8_t seen[8] = {};
    EXPECT_EQ(::read(reader, seen, sizeof(seen)), 3);  // not a byte of the new one
    ::close(reader);
    EXPECT_EQ(Bytes(seen, seen + 3), kOld);
}

TEST(WriteFileAtomicallyTest, ALinkStaysAndItsFileIsReplaced) {
    const TemporaryFolder folder;
    folder.Put("file", kOld);
    std::filesystem::create_symlink("file", folder.Path("link"));
    WriteFileAtomically(folder.Path("link"), kNew);
    EXPECT_TRUE(std::filesystem::is_symlink(folder.Path("link")));
    EXPECT_EQ(Contents(folder.Path("file")), kNew);
    EXPECT_EQ(folder.Names(), (std::vector<std::string>{"file", "link"}));
}

TEST(WriteFileAtomicallyTest, ALeftOverTemporaryNameIsNoObstacle) {
    const TemporaryFolder folder;
    const std::string left = fmt::format(".boxcar-{}-0", ::getpid());
    folder.Put(left, kOld);
    WriteFileAtomically(folder.Path("f"), kNew);
    EXPECT_EQ(Contents(folder.Path("f")), kNew);
    EXPECT_EQ(Contents(folder.Path(left)), kOld);
    EXPECT_EQ(folder.Names(), (std::vector<std::string>{left, "f"}));
}

TEST(WriteFileAtomicallyTest, DevicesAndPipesAreWrittenDirectly) {
    const TemporaryFolder folder;
    WriteFileAtomically("/dev/null", kNew);
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));

    const std::string pipe = folder.Path("pipe");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    Bytes got;
    std::thread reader([&] { got = Contents(pipe); });
    WriteFileAtomically(pipe, kNew);
    reader.join();
    EXPECT_EQ(got, kNew);
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST(WriteFileAtomicallyTest, AFullDiskIsNoticed) {
    EXPECT_EQ(ErrorOf([] { WriteFileAtomically("/dev/full", kNew); }),
              "/dev/full: cannot be written: No space left on device");
}

// The size limit of a process stands in for a full disk: the file is begun, then write(2) fails.
TEST(WriteFileAtomicallyDeathTest, WhatCannotBeCompletedIsTakenAway) {
    const TemporaryFolder folder;
    const std::string path = folder.Put("f", kOld);
    const auto writeTooMuch = [&] {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit = {1000, 1000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        try {
            WriteFileAtomically(path, Bytes(5000, 1));
        } catch (const Error& error) {
            std::exit(error.what() == path + ": cannot be written: File too large" ? 3 : 4);
        }
        std::exit(5);
    };
    EXPECT_EXIT(writeTooMuch(), testing::ExitedWithCode(3), "");
    EXPECT_EQ(Contents(path), kOld);
    EXPECT_EQ(folder.Names(), std::vector<std::string>{"f"});
}

TEST(WriteFileAtomicallyTest, PathsThatCannotBeAreRefusedWithTheSystemsReason) {
    const TemporaryFolder folder;
    folder.Put("file", kOld);
    const auto errorOf = [&](const std::string& path) { return ErrorOf([&] { WriteFileAtomically(path, kNew); }); };
    const std::string missing = folder.Path("missing/f");
    EXPECT_EQ(errorOf(missing), missing + ": cannot be written: No such file or directory");
    const std::string throughFile = folder.Path("file/f");
    EXPECT_EQ(errorOf(throughFile), throughFile + ": cannot be written: Not a directory");
    const std::string itself = folder.Path("");
    EXPECT_EQ(errorOf(itself), itself + ": cannot be written: Is a directory");
    const std::string tooLong = folder.Path(std::string(300, 'x'));
    EXPECT_EQ(errorOf(tooLong), tooLong + ": cannot be written: File name too long");
    EXPECT_EQ(errorOf(""), ": cannot be written: No such file or directory");
    EXPECT_EQ(folder.Names(), std::vector<std::string>{"file"});
    EXPECT_EQ(Contents(folder.Path("file")), kOld);
}

TEST(WriteFileAtomicallyDeathTest, AFileThatMayNotBeWrittenIsNotReplaced) {
    const TemporaryFolder folder;
    const std::string path = folder.Put("f", kOld);
    ASSERT_EQ(::chmod(path.c_str(), 0444), 0);
    ASSERT_EQ(::chmod(folder.Path("").c_str(), 0777), 0);
    const auto writeAsNobody = [&] {
        if (::geteuid() == 0 && ::setuid(65534) != 0) std::exit(2);  // root may write every file
        try {
            WriteFileAtomically(path, kNew);
        } catch (const Error& error) {
            std::exit(error.what() == path + ": cannot be written: Permission denied" ? 3 : 4);
        }
        std::exit(5);
    };
    EXPECT_EXIT(writeAsNobody(), testing::ExitedWithCode(3), "");
    EXPECT_EQ(Contents(path), kOld);
    EXPECT_EQ(folder.Names(), std::vector<std::string>{"f"});
}

constexpr auto kAny = [](ByteView) {};

TEST(ReadBytesTest, ReadsFilesAndPipesWhole) {
    const TemporaryFolder folder;
    Bytes bytes(300'000);
    for (size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<uint8_t>(i * 2654435761u >> 24);
    EXPECT_EQ(ReadBytes(folder.Put("f", bytes), bytes.size(), kAny), bytes);
    EXPECT_EQ(ReadBytes(folder.Put("empty", {}), 0, kAny), Bytes{});

    const std::string pipe = folder.Path("pipe");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::thread writer([&] { folder.Put("pipe", bytes); });
    EXPECT_EQ(ReadBytes(pipe, bytes.size(), kAny), bytes);
    writer.join();
}

TEST(ReadBytesTest, MoreThanIsAllowedIsRefused) {
    const TemporaryFolder folder;
    const std::string path = folder.Put("f", Bytes((1 << 20) + 1, 9));
    EXPECT_EQ(ReadBytes(path, (1 << 20) + 1, kAny).size(), size_t{(1 << 20) + 1});
    EXPECT_EQ(ErrorOf([&] { ReadBytes(path, 1 << 20, kAny); }), path + ": longer than 1 MiB, the most that is read");
    EXPECT_EQ(ErrorOf([] { ReadBytes("/dev/zero", 3 << 20, kAny); }),
              "/dev/zero: longer than 3 MiB, the most that is read");
}

TEST(ReadBytesTest, TheStartIsSeenBeforeTheRestIsRead) {
    const TemporaryFolder folder;
    size_t seen = 0;
    const auto refuse = [&](ByteView start) {
        seen = start.size();
        throw Error("not this");
    };
    EXPECT_EQ(ErrorOf([&] { ReadBytes("/dev/zero", uint64_t{1} << 40, refuse); }), "not this");
    EXPECT_GE(seen, 16u);
    EXPECT_EQ(ErrorOf([&] { ReadBytes(folder.Put("f", kOld), 100, refuse); }), "not this");
    EXPECT_EQ(seen, kOld.size());
}

}  // namespace
}  // namespace boxcar::test
