// boxcar gallery.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "tests/cli/program.h"

namespace boxcar {
namespace {

TEST(Gallery, PageShowsEveryPictureAndLoadsNothingElse) {
    const Folder folder;
    const Outcome outcome = folder.Run("gallery -o shown --size 96x60", "", 600);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "shown/index.html\n");
    std::ifstream file(folder.Path("shown/index.html"));
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(page.find("http"), std::string::npos);
    EXPECT_EQ(page.find("<script"), std::string::npos);

    std::set<std::string> shown, written;
    const std::regex image("<img src=\"([^\"]+)\"");
    for (std::sregex_iterator it(page.begin(), page.end(), image), end; it != end; ++it)
        shown.insert((*it)[1]);
    for (const auto& entry : std::filesystem::directory_iterator(folder.Path("shown")))
        if (entry.path().filename() != "index.html") written.insert(entry.path().filename().string());
    EXPECT_EQ(shown, written);
    EXPECT_GE(shown.size(), 20u);
    for (const std::string& name : shown) {
        if (name.ends_with(".svg")) continue;
        const Picture picture = ReadPicture(folder.Path("shown/" + name));
        EXPECT_GT(*std::max_element(picture.samples.begin(), picture.samples.end()), 0.1f) << name << " is black";
    }
    // Scheuermann's table, from the device.
    EXPECT_NE(page.find("<td>7</td><td>17</td><td>23</td><td>28</td>"), std::string::npos);
}

}  // namespace
}  // namespace boxcar
