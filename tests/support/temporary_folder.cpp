#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "tools/base/error.h"

namespace boxcar::test {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "boxcar-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw Error("{}: cannot be made: {}", name, std::strerror(errno));
    m_path = name;
}

TemporaryFolder::~TemporaryFolder() {
    fs::remove_all(m_path);
}

std::vector<std::string> TemporaryFolder::Names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(m_path))
        names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

std::string TemporaryFolder::Put(const std::string& name, std::span<const uint8_t> bytes) const {
    return WriteText(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

std::string TemporaryFolder::WriteText(const std::string& name, std::string_view text) const {
    const fs::path path = m_path / name;
    fs::create_directories(path.parent_path());
    // ext4 flushes a file to the disk that is truncated and written again, which takes a while.
    if (fs::is_regular_file(path)) fs::remove(path);
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
}

std::string ReadText(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    EXPECT_TRUE(file) << path;
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace boxcar::test
