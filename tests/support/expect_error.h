// EXPECT_ERROR(statement, "text"): the statement throws boxcar::Error with exactly this text.
#pragma once

#include <gtest/gtest.h>

#include "tools/base/error.h"

#define EXPECT_ERROR(statement, text)                                         \
    do {                                                                      \
        try {                                                                 \
            statement;                                                        \
            ADD_FAILURE() << #statement " threw nothing; expected: " << text; \
        } catch (const ::boxcar::Error& error) {                              \
            EXPECT_EQ(std::string(error.what()), text);                       \
        }                                                                     \
    } while (false)
