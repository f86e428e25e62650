#include "tools/base/descriptor.h"

#include <poll.h>
#include <unistd.h>

#include <cerrno>

namespace boxcar {

bool Descriptor::Close() {
    return m_number < 0 || ::close(std::exchange(m_number, -1)) == 0;
}

bool WriteAll(int descriptor, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written > 0) bytes = bytes.subspan(static_cast<size_t>(written));
        if (written >= 0 || errno == EINTR) continue;
        pollfd wait = {descriptor, POLLOUT, 0};
        if (errno != EAGAIN || ::poll(&wait, 1, -1) < 0) return false;
    }
    return true;
}

}  // namespace boxcar
