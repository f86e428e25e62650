#include "samples/cli/console.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "samples/files/bytes.h"
#include "tools/base/printable.h"

namespace boxcar {
namespace {

nlohmann::ordered_json WithValidUtf8(nlohmann::ordered_json json) {
    if (json.is_string()) return ValidUtf8(json.get_ref<const std::string&>());
    if (json.is_structured())
        for (auto& value : json)
            value = WithValidUtf8(std::move(value));
    return json;
}

}  // namespace

void PrintDocument(std::string_view text) {
    WriteFileAtomically("-", {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
}

void PrintJson(const nlohmann::ordered_json& json) {
    PrintDocument(WithValidUtf8(json).dump(2) + "\n");
}

void PrintProblem(std::string_view text) {
    const std::string line = "boxcar: " + Printable(text) + "\n";
    std::fputs(line.c_str(), stderr);
}

}  // namespace boxcar
