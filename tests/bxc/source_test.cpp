#include "tools/bxc/source.h"

#include "tests/bxc/bxc_test.h"

namespace boxcar {
namespace {

class SourceTest : public BxcTest {
protected:
    Source Make(std::vector<std::string> includeDirs = {}) {
        return Source(m_folder.string(), std::move(includeDirs));
    }

    std::string OpenError(const std::string& name) {
        Source source = Make();
        std::string error;
        EXPECT_EQ(source.Open(name, error), nullptr);
        return error;
    }
};

TEST_F(SourceTest, NamesAreRelativeToTheRootWithoutDots) {
    Write("a/b.hlsl", "text");
    Source source = Make();
    std::string error;
    const Source::File* file = source.Open("./a/../a/b.hlsl", error);
    ASSERT_NE(file, nullptr) << error;
    EXPECT_EQ(file->name, "a/b.hlsl");
    EXPECT_EQ(file->text, "text");
    EXPECT_EQ(source.Open("a/b.hlsl", error), file);
    EXPECT_EQ(source.Names(), std::vector<std::string>{"a/b.hlsl"});
}

TEST_F(SourceTest, IncludeLooksBesideTheFileThenInTheFoldersThenInTheRoot) {
    Write("x.hlsli", "root");
    Source source = Make({"first", "second"});
    std::string error;
    const auto found = [&] {
        Source fresh = Make({"first", "second"});
        const Source::File* file = fresh.Include("x.hlsli", "shaders/a.hlsl", 1, error);
        return file ? file->text : error;
    };
    EXPECT_EQ(found(), "root");
    Write("second/x.hlsli", "second");
    EXPECT_EQ(found(), "second");
    Write("first/x.hlsli", "first");
    EXPECT_EQ(found(), "first");
    Write("shaders/x.hlsli", "beside");
    EXPECT_EQ(found(), "beside");
}

TEST_F(SourceTest, MissingIncludeNamesTheFoldersThatWereSearched) {
    Source source = Make({"first", "first"});
    std::string error;
    EXPECT_EQ(source.Include("x.hlsli", "shaders/a.hlsl", 1, error), nullptr);
    EXPECT_EQ(error, "cannot find 'x.hlsli'; searched: shaders, first, .");
}

TEST_F(SourceTest, IncludesThatNestTooDeepAreRefused) {
    Write("x.hlsli", "");
    Source source = Make();
    std::string error;
    EXPECT_NE(source.Include("x.hlsli", "a.hlsl", 64, error), nullptr);
    EXPECT_EQ(source.Include("x.hlsli", "a.hlsl", 65, error), nullptr);
    EXPECT_EQ(error, "includes are nested more than 64 deep: does a file include itself?");
}

TEST_F(SourceTest, WhatIsNotAReadableTextIsRefused) {
    Write("binary.hlsl", std::string("abc\0def", 7));
    EXPECT_EQ(OpenError("binary.hlsl"), "'binary.hlsl': not text: byte 3 is 0");
    Write("words.hlsl", "\x03\x02#\x07");
    EXPECT_EQ(OpenError("words.hlsl"), "'words.hlsl': not text: byte 0 is 3");
    EXPECT_EQ(OpenError("none.hlsl"), "'none.hlsl': cannot be read: No such file or directory");
    EXPECT_EQ(OpenError("."), "'.': a folder; a file is expected");
    EXPECT_EQ(OpenError("/dev/zero"), "'/dev/zero': longer than 16 MiB, the most that is read");
}

TEST_F(SourceTest, TextOfUpTo16MibIsAccepted) {
    Write("most.hlsl", std::string(16 << 20, ' '));
    Write("more.hlsl", std::string((16 << 20) + 1, ' '));
    Source source = Make();
    std::string error;
    EXPECT_NE(source.Open("most.hlsl", error), nullptr) << error;
    EXPECT_EQ(source.Open("more.hlsl", error), nullptr);
    EXPECT_EQ(error, "'more.hlsl': longer than 16 MiB, the most that is read");
}

TEST_F(SourceTest, ByteOrderMarkIsNotPartOfTheText) {
    Write("a.hlsl",
          "\xef\xbb\xbf"
          "float uv;");
    Source source = Make();
    std::string error;
    ASSERT_NE(source.Open("a.hlsl", error), nullptr) << error;
    EXPECT_EQ(source.Open("a.hlsl", error)->text, "float uv;");
}

TEST_F(SourceTest, PlaceIsTheFirstWholeWordOfTheLine) {
    Write("a.hlsl", "first\nfloat uvw, uv, x = uv;\nlast");
    Source source = Make();
    std::string error;
    ASSERT_NE(source.Open("a.hlsl", error), nullptr);
    EXPECT_EQ(source.PlaceOf("a.hlsl", 2, "uv"), (SourcePlace{"a.hlsl", 2, 12}));
    EXPECT_EQ(source.PlaceOf("a.hlsl", 2, "="), (SourcePlace{"a.hlsl", 2, 18}));
    EXPECT_EQ(source.PlaceOf("a.hlsl", 3, "uv"), (SourcePlace{"a.hlsl", 3, 0}));
    EXPECT_EQ(source.PlaceOf("a.hlsl", 9, "uv"), (SourcePlace{"a.hlsl", 9, 0}));
}

TEST_F(SourceTest, MacrosAreFoundInEveryFileThatWasRead) {
    Write("a.hlsl", "#define Other Store2\n#  define\tStore2(a, b) a\n");
    Source source(m_folder.string(), {});
    std::string error;
    EXPECT_FALSE(source.DefinesMacro("Store2"));
    source.Open("a.hlsl", error);
    EXPECT_TRUE(source.DefinesMacro("Store2"));
    EXPECT_TRUE(source.DefinesMacro("Other"));
    for (const char* name : {"Store", "Store22", "a"})
        EXPECT_FALSE(source.DefinesMacro(name)) << name;
}

}  // namespace
}  // namespace boxcar
