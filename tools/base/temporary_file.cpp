#include "tools/base/temporary_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>

namespace boxcar {
namespace {

constexpr std::array kEnding = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU, SIGXFSZ};

// The files that the signal handler removes.
std::array<std::atomic<const char*>, 16> names;
static_assert(std::atomic<const char*>::is_always_lock_free);

std::atomic_flag lock;

void Lock() {
    while (lock.test_and_set())
        ::poll(nullptr, 0, 1);
}

sigset_t EndingSignals() {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : kEnding)
        sigaddset(&set, signal);
    return set;
}

// While this exists, the table and the files do not have to agree. A signal to this thread waits until then; in
// another thread, such as a driver's, the handler waits for the lock.
class Exclusive {
public:
    Exclusive() {
        const sigset_t ending = EndingSignals();
        pthread_sigmask(SIG_BLOCK, &ending, &m_before);
        Lock();
    }
    ~Exclusive() {
        lock.clear();
        pthread_sigmask(SIG_SETMASK, &m_before, nullptr);
    }
    Exclusive(const Exclusive&) = delete;
    Exclusive& operator=(const Exclusive&) = delete;

private:
    sigset_t m_before;
};

// Calls only what a signal handler may. It keeps the lock, so no more files are made. The signal is blocked until
// this returns.
void UnlinkAndEnd(int signal) {
    Lock();
    for (const auto& name : names)
        if (const char* const path = name) ::unlink(path);
    std::signal(signal, SIG_DFL);
    ::raise(signal);
}

void HandleSignals() {
    for (const int signal : kEnding) {
        struct sigaction action = {};
        if (sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) continue;
        action.sa_handler = UnlinkAndEnd;
        action.sa_mask = EndingSignals();
        sigaction(signal, &action, nullptr);
    }
}

void Replace(const char* from, const char* to) {
    for (auto& name : names)
        if (name == from) {
            name = to;
            return;
        }
}

}  // namespace

TemporaryFile::TemporaryFile(const std::string& folder, mode_t permissions) {
    [[maybe_unused]] static const bool isHandled = (HandleSignals(), true);
    const Exclusive exclusive;
    int number = 0;
    do {
        m_name = fmt::format("{}{}.boxcar-{}-{}", folder, folder.empty() ? "" : "/", ::getpid(), number++);
        m_descriptor = Descriptor(::open(m_name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions));
    } while (Number() < 0 && errno == EEXIST);
    if (Number() < 0)
        m_name.clear();
    else
        Replace(nullptr, m_name.c_str());
}

TemporaryFile::~TemporaryFile() {
    Close();
    if (m_name.empty()) return;
    const Exclusive exclusive;
    ::unlink(m_name.c_str());
    Replace(m_name.c_str(), nullptr);
}

bool TemporaryFile::RenameTo(const std::string& path) {
    const Exclusive exclusive;
    if (std::rename(m_name.c_str(), path.c_str()) != 0) return false;
    Replace(m_name.c_str(), nullptr);
    m_name.clear();
    return true;
}

}  // namespace boxcar
