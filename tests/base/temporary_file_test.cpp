#include "tools/base/temporary_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "tests/support/temporary_folder.h"

namespace boxcar {
namespace {

class TemporaryFileTest : public testing::Test {
protected:
    size_t Files() const { return m_temporary.Names().size(); }

    // In a child: makes a file, and a second one that takes another's name, then gets the signal.
    void ReceiveWhileItExists(int signal) const {
        TemporaryFile file(m_folder, 0600), other(m_folder, 0600);
        other.RenameTo(m_folder + "/complete");
        if (Files() != 2) std::exit(2);
        ::raise(signal);
        std::exit(3);
    }

    const test::TemporaryFolder m_temporary;
    const std::string m_folder = m_temporary.Path();
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
