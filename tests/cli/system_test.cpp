// The program among others: names of any bytes, full disks, streams that are appended to, links, other people's files
// and signals.
#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/cli/program.h"

namespace boxcar {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr uid_t kNobody = 65534;
constexpr char kNotUtf8[] = "bad\xff\xfe.png";
constexpr char kControls[] = "li\nne\x1b[31m.png";

class SystemTest : public testing::Test {
protected:
    void SetUp() override { Put("ok.png"); }

    void Put(const std::string& name) {
        WritePicture(RandomPicture(6, 4, 3, SampleType::Unorm8), m_folder.Path(name), FileFormat::Png,
                     SampleType::Unorm8);
    }

    std::string Text(const std::string& name) const {
        std::ifstream file(m_folder.Path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    struct stat StatusOf(const std::string& name) const {
        struct stat status = {};
        EXPECT_EQ(::lstat(m_folder.Path(name).c_str(), &status), 0) << name;
        return status;
    }

    bool IsPicture(const std::string& name) const { return ReadPicture(m_folder.Path(name)).widthTexels == 6; }

    Folder m_folder;
};

TEST_F(SystemTest, MessagesAreOneLineWhateverTheNameIs) {
    const auto said = [&](const std::string& name) {
        return m_folder.Run(fmt::format("filter '{}' -o out.png --width 3", name)).err;
    };
    EXPECT_EQ(said(kNotUtf8), "boxcar: bad\\xff\\xfe.png: cannot be read: No such file or directory\n");
    EXPECT_EQ(said(kControls), "boxcar: li\\nne\\x1b[31m.png: cannot be read: No such file or directory\n");
    EXPECT_EQ(m_folder.Run("filter ok.png -o out.png --width '3\n\xff'").err,
              "boxcar: --width 3\\n\\xff: expected W or WxH in texels, numbers above 0 and at most 32768\n");
    EXPECT_EQ(m_folder.Run("list '--a\nb'").err, "boxcar: The following argument was not expected: --a\\nb\n");
    Put(kControls);
    const std::string stats = m_folder.Run(fmt::format("filter '{0}' -o 'out{0}' --width 3 --stats", kControls)).err;
    EXPECT_TRUE(stats.starts_with("li\\nne\\x1b[31m.png -> outli\\nne\\x1b[31m.png: 6 x 4\n")) << stats;
}

TEST_F(SystemTest, ABadNameKeepsTheReportOfEveryFile) {
    for (const char* name : {kNotUtf8, kControls, "caf\u00e9.png"})
        Put(name);
    const std::string inputs = fmt::format("'{}' '{}' caf\u00e9.png 'gone\xff.png' ok.png", kNotUtf8, kControls);
    const Outcome outcome = m_folder.Run(fmt::format("filter {} -o out/ --width 3 --json", inputs));
    EXPECT_EQ(outcome.exitCode, 1);
    const auto results = nlohmann::json::parse(outcome.out)["results"];
    ASSERT_EQ(results.size(), 5u);
    // JSON spells control characters itself, so a program gets the name as it is; what is no text it cannot get.
    EXPECT_EQ(results[0]["input"], "bad\\xff\\xfe.png");
    EXPECT_EQ(results[0]["output"], "out/bad\\xff\\xfe.png");
    EXPECT_EQ(results[1]["input"], kControls);
    EXPECT_EQ(results[2]["input"], "caf\u00e9.png");
    EXPECT_EQ(results[3]["input"], "gone\\xff.png");
    EXPECT_EQ(results[3]["error"], "gone\\xff.png: cannot be read: No such file or directory");
    EXPECT_EQ(results[4]["input"], "ok.png");
    for (const char* name : {kNotUtf8, kControls, "caf\u00e9.png", "ok.png"})
        EXPECT_TRUE(IsPicture(std::string("out/") + name));

    const auto measured = nlohmann::json::parse(m_folder.Run(fmt::format("precision {} --json", inputs)).out);
    ASSERT_EQ(measured.size(), 5u);
    EXPECT_EQ(measured[0]["image"], "bad\\xff\\xfe.png");
    EXPECT_EQ(measured[3]["error"], "gone\\xff.png: cannot be read: No such file or directory");
}

TEST_F(SystemTest, AFullDiskUnderAnyDocumentIsAFailure) {
    const std::string inspect = "inspect planar-reflection --stage reflected --size 16x16";
    for (const std::string& command :
         {std::string("--help"), std::string("--version"), std::string("filter --help"), std::string("list"),
          std::string("list --json"), std::string("fit-lobe --phong 9"), std::string("fit-lobe --phong 9 --json"),
          std::string("devices"), std::string("devices --json"), std::string("precision ok.png"),
          std::string("precision ok.png --json"), inspect, inspect + " --json",
          std::string("filter ok.png -o out.png --width 3 --json"),
          std::string("filter ok.png -o - --format png --width 3")}) {
        const Outcome outcome = m_folder.Run(command + " > /dev/full");
        EXPECT_EQ(outcome.exitCode, 1) << command;
        EXPECT_EQ(outcome.err, "boxcar: standard output: cannot be written: No space left on device\n") << command;
    }
}

// Of a command without a device: drivers keep images in files of their own.
TEST_F(SystemTest, ALimitOfAFilesSizeIsAFailureToo) {
    const Outcome outcome = m_folder.Run("list", "prlimit --fsize=100");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_EQ(outcome.err, "boxcar: standard output: cannot be written: File too large\n");
}

TEST_F(SystemTest, AClosedOutputIsAFailure) {
    const Outcome outcome = m_folder.Run("filter ok.png -o - --format png --width 3 >&-");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_EQ(outcome.err, "boxcar: standard output: cannot be written: Bad file descriptor\n");
}

TEST_F(SystemTest, StreamsByNameAreWrittenWhereTheyStand) {
    ASSERT_EQ(m_folder.Run("filter ok.png -o out.png --width 3").exitCode, 0);
    const std::string picture = Text("out.png");
    fs::create_symlink("/proc/self/fd/1", m_folder.Path("link.png"));
    // The link of our own goes first: a program that replaced links would, run by root, take the system's away.
    for (const auto& [name, redirection] :
         {std::pair("link.png", ">> log"), std::pair("/proc/self/fd/7", "7>> log"), std::pair("/dev/fd/7", "7>> log"),
          std::pair("/dev/stdout", ">> log"), std::pair("/dev/stderr", "2>> log")}) {
        m_folder.WriteText("log", "kept\n");
        const Outcome outcome =
            m_folder.Run(fmt::format("filter ok.png -o {} --format png --width 3 {}", name, redirection));
        ASSERT_EQ(outcome.exitCode, 0) << name;
        ASSERT_EQ(Text("log"), "kept\n" + picture) << name;
        ASSERT_TRUE(fs::is_symlink(m_folder.Path("link.png")));
    }
    EXPECT_EQ(m_folder.Run("filter ok.png -o /dev/stdout --format png --width 3 | cat #").out, picture);
    EXPECT_EQ(m_folder.Run("filter ok.png -o /dev/fd/9 --format png --width 3 9>&-").err,
              "boxcar: /dev/fd/9: cannot be written: Bad file descriptor\n");
    EXPECT_EQ(m_folder.Run("filter ok.png -o link.png --width 3 --json").err,
              "boxcar: --json and -o link.png would both write to standard output\n");
}

TEST_F(SystemTest, FifosAreWrittenAndStay) {
    ASSERT_EQ(::mkfifo(m_folder.Path("pipe.png").c_str(), 0600), 0);
    const Outcome outcome =
        m_folder.Run(fmt::format("filter ok.png -o pipe.png --width 3 & timeout 60 cat '{}' > '{}'; wait #",
                                 m_folder.Path("pipe.png"), m_folder.Path("got.png")));
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_TRUE(IsPicture("got.png"));
    EXPECT_TRUE(fs::is_fifo(m_folder.Path("pipe.png")));
}

TEST_F(SystemTest, LinksStayAndTheirTargetsAreWritten) {
    fs::create_directory(m_folder.Path("elsewhere"));
    m_folder.WriteText("elsewhere/old.png", "old");
    ::chmod(m_folder.Path("elsewhere/old.png").c_str(), 0640);
    fs::create_symlink("elsewhere/old.png", m_folder.Path("old.png"));
    fs::create_symlink("../new.png", m_folder.Path("elsewhere/over.png"));
    fs::create_symlink("elsewhere/over.png", m_folder.Path("twice.png"));  // -> new.png, which is not there yet
    for (const char* link : {"old.png", "twice.png"}) {
        EXPECT_EQ(m_folder.Run(fmt::format("filter ok.png -o {} --width 3", link)).exitCode, 0) << link;
        EXPECT_TRUE(fs::is_symlink(m_folder.Path(link)));
    }
    EXPECT_TRUE(IsPicture("elsewhere/old.png"));
    EXPECT_EQ(StatusOf("elsewhere/old.png").st_mode & 0777, 0640u);
    EXPECT_TRUE(fs::is_regular_file(m_folder.Path("new.png")) && IsPicture("new.png"));
    EXPECT_TRUE(fs::is_symlink(m_folder.Path("elsewhere/over.png")));

    fs::create_symlink("loop.png", m_folder.Path("loop.png"));
    EXPECT_EQ(m_folder.Run("filter ok.png -o loop.png --width 3").err,
              "boxcar: loop.png: cannot be written: Too many levels of symbolic links\n");
}

// What root alone can set up: files of two people.
class OthersFiles : public SystemTest {
protected:
    void SetUp() override {
        if (::geteuid() != 0) GTEST_SKIP() << "only root can give a file to another user";
        SystemTest::SetUp();
        ASSERT_EQ(::chmod(m_folder.Path("").c_str(), 0755), 0);
    }

    Outcome RunAsNobody(const std::string& arguments) const {
        return m_folder.Run(arguments,
                            "MESA_SHADER_CACHE_DISABLE=1 setpriv --reuid=65534 --regid=65534 --clear-groups");
    }

    void PutOld(const std::string& name, uid_t owner, mode_t permissions) {
        m_folder.WriteText(name, std::string(100000, 'o'));
        ASSERT_EQ(::chown(m_folder.Path(name).c_str(), owner, owner), 0);
        ASSERT_EQ(::chmod(m_folder.Path(name).c_str(), permissions), 0);
    }

    void ExpectStill(const std::string& name, uid_t owner, mode_t permissions) {
        EXPECT_EQ(StatusOf(name).st_uid, owner) << name;
        EXPECT_EQ(StatusOf(name).st_gid, owner) << name;
        EXPECT_EQ(StatusOf(name).st_mode & 0777, permissions) << name;
    }
};

TEST_F(OthersFiles, AReplacedFileKeepsItsOwner) {
    PutOld("out.png", kNobody, 0604);
    const ino_t before = StatusOf("out.png").st_ino;
    ASSERT_EQ(m_folder.Run("filter ok.png -o out.png --width 3").exitCode, 0);
    EXPECT_TRUE(IsPicture("out.png"));
    ExpectStill("out.png", kNobody, 0604);
    EXPECT_NE(StatusOf("out.png").st_ino, before);  // replaced as a whole
}

TEST_F(OthersFiles, AWritableFileInAClosedFolderIsWritten) {
    PutOld("out.png", kNobody, 0644);
    const Outcome outcome = RunAsNobody("filter ok.png -o out.png --width 3");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_TRUE(IsPicture("out.png"));
    EXPECT_LT(StatusOf("out.png").st_size, 10000);
    ExpectStill("out.png", kNobody, 0644);
    EXPECT_EQ(RunAsNobody("filter ok.png -o new.png --width 3").err,
              "boxcar: new.png: cannot be written: Permission denied\n");
}

TEST_F(OthersFiles, AnothersWritableFileStaysTheirs) {
    ASSERT_EQ(::chmod(m_folder.Path("").c_str(), 0777), 0);
    PutOld("out.png", 0, 0666);
    EXPECT_EQ(RunAsNobody("filter ok.png -o out.png --width 3").exitCode, 0);
    EXPECT_TRUE(IsPicture("out.png"));
    ExpectStill("out.png", 0, 0666);

    PutOld("locked.png", 0, 0644);
    EXPECT_EQ(RunAsNobody("filter ok.png -o locked.png --width 3").err,
              "boxcar: locked.png: cannot be written: Permission denied\n");
    EXPECT_EQ(m_folder.Names(), (std::vector<std::string>{"locked.png", "ok.png", "out.png"}));
}

// The signal is sent while the temporary file is seen in the folder: 50 MB take their time.
class Signals : public SystemTest {
protected:
    void SetUp() override {
        const Picture picture{2048, 2048, 3, SampleType::Float32, std::vector<float>(2048 * 2048 * 3, 0.5f)};
        WritePicture(picture, m_folder.Path("big.pfm"), FileFormat::Pfm, SampleType::Float32);
        fs::create_directory(m_folder.Path("out"));
    }

    std::vector<std::string> Outputs() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(m_folder.Path("out")))
            names.push_back(entry.path().filename());
        return names;
    }

    pid_t Start() const {
        const pid_t process = ::fork();
        if (process != 0) return process;
        if (::chdir(m_folder.Path("").c_str()) != 0) ::_exit(9);
        ::execl(BOXCAR_PROGRAM, BOXCAR_PROGRAM, "filter", "big.pfm", "-o", "out/", "--width", "1", nullptr);
        ::_exit(9);
    }
};

TEST_F(Signals, NoTemporaryFileIsLeftAndTheStatusIsTheSignals) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        bool wasWriting = false;
        for (int attempt = 0; attempt < 5 && !wasWriting; attempt++) {
            fs::remove(m_folder.Path("out/big.pfm"));
            const pid_t process = Start();
            for (const auto end = Clock::now() + std::chrono::minutes(1); Outputs().empty() && Clock::now() < end;)
                std::this_thread::sleep_for(std::chrono::microseconds(50));
            ::kill(process, signal);
            int status = 0;
            ::waitpid(process, &status, 0);
            wasWriting = WIFSIGNALED(status) && !fs::exists(m_folder.Path("out/big.pfm"));
            if (!wasWriting) continue;
            EXPECT_EQ(WTERMSIG(status), signal);
            EXPECT_EQ(Outputs(), std::vector<std::string>{});
        }
        EXPECT_TRUE(wasWriting) << "signal " << signal << " never came while the file was written";
    }
}

}  // namespace
}  // namespace boxcar
