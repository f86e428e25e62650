#include "tools/base/temporary_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>

namespace boxcar {
namespace {

class TemporaryFileTest : public testing::Test {
protected:
    TemporaryFileTest() {
        std::string name = (std::filesystem::temp_directory_path() / "boxcar-test-XXXXXX").string();
        m_folder = mkdtemp(name.data());
    }
    ~TemporaryFileTest() override { std::filesystem::remove_all(m_folder); }

    size_t Files() const {
        const auto files = std::filesystem::directory_iterator(m_folder);
        return static_cast<size_t>(std::distance(begin(files), end(files)));
    }

    // In a child: makes a file, and a second one that takes another's name, then gets the signal.
    void ReceiveWhileItExists(int signal) const {
        TemporaryFile file(m_folder, 0600), other(m_folder, 0600);
        other.RenameTo(m_folder + "/complete");
        if (Files() != 2) std::exit(2);
        ::raise(signal);
        std::exit(3);
    }

    std::string m_folder;
};
using TemporaryFileDeathTest = TemporaryFileTest;

TEST_F(TemporaryFileTest, IsGoneWithItsObjectUnlessItIsRenamed) {
    {
        TemporaryFile file(m_folder, 0600), kept(m_folder, 0600);
        EXPECT_EQ(Files(), 2u);
        EXPECT_TRUE(kept.RenameTo(m_folder + "/kept"));
    }
    EXPECT_EQ(Files(), 1u);
    EXPECT_TRUE(std::filesystem::exists(m_folder + "/kept"));
}

TEST_F(TemporaryFileTest, SaysWhyItCannotBeMade) {
    TemporaryFile file(m_folder + "/missing", 0600);
    EXPECT_EQ(file.Number(), -1);
    EXPECT_EQ(errno, ENOENT);
}

TEST_F(TemporaryFileDeathTest, ASignalTakesItAwayAndEndsTheProcess) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU, SIGXFSZ}) {
        EXPECT_EXIT(ReceiveWhileItExists(signal), testing::KilledBySignal(signal), "") << signal;
        EXPECT_EQ(Files(), 1u) << signal;  // "complete"
    }
}

TEST_F(TemporaryFileDeathTest, ASignalThatIsIgnoredStaysSo) {
    const auto receive = [&] {
        std::signal(SIGHUP, SIG_IGN);
        ReceiveWhileItExists(SIGHUP);
    };
    EXPECT_EXIT(receive(), testing::ExitedWithCode(3), "");
}

}  // namespace
}  // namespace boxcar
