#include "tools/base/printable.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "tools/base/error.h"

namespace boxcar {
namespace {

TEST(Printable, TextOfAnyLanguageStays) {
    for (const char* text : {"", "plain.png", "a\\b", "caf\u00e9", "\u5199\u771f.png", "\U0001f4f7.png"})
        EXPECT_EQ(Printable(text), text);
}

TEST(Printable, WhatATerminalWouldActOnIsSpelled) {
    EXPECT_EQ(Printable("a\nb\r\tc"), "a\\nb\\r\\tc");
    EXPECT_EQ(Printable("\x1b[31m\x7f"), "\\x1b[31m\\x7f");
    EXPECT_EQ(Printable("\u009b1m"), "\\xc2\\x9b1m");                        // C1's own start of a control sequence
    EXPECT_EQ(Printable("\u2028\u202e"), "\\xe2\\x80\\xa8\\xe2\\x80\\xae");  // line separator, right to left
    EXPECT_EQ(Printable("\xff"
                        "caf\xe9"),
              "\\xffcaf\\xe9");
    EXPECT_EQ(Printable(std::string_view("\0", 1)), "\\x00");
}

TEST(Printable, ASecondTimeChangesNothing) {
    for (const char* text : {"a\nb", "\xff\x1b", "a\\nb"})
        EXPECT_EQ(Printable(Printable(text)), Printable(text));
}

TEST(Printable, ErrorsAreOneLineWhateverTheValueIs) {
    EXPECT_STREQ(Error("{}: no file", "a\n\xff").what(), "a\\n\\xff: no file");
}

bool JsonTakes(const std::string& text) {
    try {
        nlohmann::json(text).dump();
        return true;
    } catch (const nlohmann::json::type_error&) {
        return false;
    }
}

// The reference is nlohmann's own check of what it is given.
TEST(ValidUtf8, IsWhatJsonTakesAndChangesNothingElse) {
    std::mt19937 random(5);
    // The first and last of each length, their neighbors that are none, surrogates, and bytes that begin or go on.
    const std::string bytes =
        "az\n\x7f\x80\xbf\xc0\xc1\xc2\xdf\xe0\xe1\xec\xed\xee\xef\xf0\xf1\xf3\xf4\xf5\xff\x8f\x90\x9f\xa0";
    size_t valid = 0;
    for (int i = 0; i < 200000; i++) {
        std::string text;
        for (size_t length = random() % 6; text.size() < length;)
            text += bytes[random() % bytes.size()];
        const std::string made = ValidUtf8(text);
        ASSERT_TRUE(JsonTakes(made)) << Printable(text);
        ASSERT_EQ(made == text, JsonTakes(text)) << Printable(text);
        valid += made == text;
    }
    EXPECT_GT(valid, 1000u);
}

}  // namespace
}  // namespace boxcar
