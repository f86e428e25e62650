#include "tools/bxc/prelude.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace boxcar {
namespace {

// float, 1 -> "float"; float, 3 -> "float3"
std::string VectorType(std::string_view scalar, int size) {
    return size == 1 ? std::string(scalar) : fmt::format("{}{}", scalar, size);
}

// A scalar stands for a vector of any size. All ways to write values of which the largest has this size.
std::vector<std::vector<int>> Sizes(size_t valueCount, int size) {
    std::vector<std::vector<int>> ways;
    for (unsigned wide = 1; wide < 1u << valueCount; ++wide) {  // a bit a value
        std::vector<int>& sizes = ways.emplace_back();
        for (size_t i = 0; i < valueCount; ++i)
            sizes.push_back(wide >> i & 1 ? size : 1);
        if (size == 1) break;  // all alike
    }
    return ways;
}

// `value` as the common type. The compiler makes no half of what is not float.
std::string Cast(std::string_view from, std::string_view common, int size, std::string_view value) {
    const bool goesByFloat = common == "half" && from != "half";
    return fmt::format("({}){}{}", VectorType(common, size),
                       goesByFloat ? fmt::format("({})", VectorType("float", size)) : "", value);
}

std::string SelectOf(std::string_view yes, std::string_view no, std::string_view common) {
    std::string text;
    for (int size = 1; size <= 4; ++size)
        for (const std::vector<int>& sizes : Sizes(3, size))
            text += fmt::format("{} select({} c, {} t, {} f) {{ return c ? {} : {}; }} ", VectorType(common, size),
                                VectorType("bool", sizes[0]), VectorType(yes, sizes[1]), VectorType(no, sizes[2]),
                                Cast(yes, common, size, "t"), Cast(no, common, size, "f"));
    return text;
}

// scalars  by rank: two have the later one in common
std::string Select(const std::vector<std::string_view>& scalars) {
    std::string text;
    for (size_t yes = 0; yes < scalars.size(); ++yes)
        for (size_t no = 0; no < scalars.size(); ++no)
            text += SelectOf(scalars[yes], scalars[no], scalars[std::max(yes, no)]);
    for (int rows = 2; rows <= 4; ++rows)
        for (int columns = 2; columns <= 4; ++columns)
            text += fmt::format(
                "float{0}x{1} select(bool c, float{0}x{1} t, float{0}x{1} f) "
                "{{ if (c) return t; return f; }} ",
                rows, columns);
    return text;
}

std::string Logical(std::string_view name, std::string_view op) {
    std::string text;
    for (int size = 1; size <= 4; ++size)
        for (const std::vector<int>& sizes : Sizes(2, size))
            text += fmt::format("{0} {1}({2} a, {3} b) {{ return ({0})a {4} ({0})b; }} ", VectorType("bool", size),
                                name, VectorType("bool", sizes[0]), VectorType("bool", sizes[1]), op);
    return text;
}

// What a shader can choose between. Without an overload of its own a type would be narrowed to float.
std::vector<std::string_view> ScalarsOf(const CompileOptions& options, const Outline& shader) {
    std::vector<std::string_view> scalars = {"bool", "int", "uint"};
    if (options.native16Bit) scalars.push_back("half");
    scalars.push_back("float");
    for (int size = 1; size <= 4; ++size)
        if (!shader.Mentions(VectorType("double", size)).empty()) {
            scalars.push_back("double");
            break;
        }
    return scalars;
}

// A macro is safe where every mention of the name is a call with that many arguments.
bool CanBeMacro(std::string_view name, size_t argumentCount, bool onlyMethods, const Outline& shader,
                const Source& source) {
    const std::vector<Outline::Mention> mentions = shader.Mentions(name);
    return !mentions.empty() && !shader.Function(name) && !source.DefinesMacro(name) &&
           std::ranges::all_of(mentions, [&](const Outline::Mention& mention) {
               return mention.argumentCount == argumentCount && (mention.isMethod || !onlyMethods);
           });
}

}  // namespace

std::string MakePrelude(const CompileOptions& options, const Outline& shader, const Source& source) {
    const auto lacks = [&](std::string_view name) {
        return options.hlslVersion >= 2021 && !shader.Mentions(name).empty() && !shader.Function(name);
    };
    std::string text;
    if (lacks("select")) text += Select(ScalarsOf(options, shader));
    if (lacks("and")) text += Logical("and", "&&");
    if (lacks("or")) text += Logical("or", "||");
    if (!text.empty()) text += "\n";

    // A macro's name is not replaced again in its own replacement.
    for (const int size : {2, 3, 4})
        if (const std::string name = fmt::format("Store{}", size); CanBeMacro(name, 2, true, shader, source))
            text += fmt::format("#define {0}(address, value) {0}(address, (uint{1})(value))\n", name, size);
    if (CanBeMacro("InterlockedCompareStore", 3, false, shader, source))
        text +=
            "static uint bxcBefore;\n"
            "#define InterlockedCompareStore(where, compare, value) "
            "InterlockedCompareExchange(where, compare, value, bxcBefore)\n";
    return text;
}

}  // namespace boxcar
