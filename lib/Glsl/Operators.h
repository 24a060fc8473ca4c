// Operators, and which of them bind closer.
#pragma once

#include <array>
#include <string_view>

namespace voxc::glsl {

struct BinaryOperator {
  std::string_view sign;
  int rank; ///< Higher ones bind closer. All group from the left.
};

inline constexpr std::array<BinaryOperator, 19> kBinaryOperators = {{{"||", 1},
                                                                     {"^^", 2},
                                                                     {"&&", 3},
                                                                     {"|", 4},
                                                                     {"^", 5},
                                                                     {"&", 6},
                                                                     {"==", 7},
                                                                     {"!=", 7},
                                                                     {"<", 8},
                                                                     {">", 8},
                                                                     {"<=", 8},
                                                                     {">=", 8},
                                                                     {"<<", 9},
                                                                     {">>", 9},
                                                                     {"+", 10},
                                                                     {"-", 10},
                                                                     {"*", 11},
                                                                     {"/", 11},
                                                                     {"%", 11}}};

/// The rank of an operator; 0 of a sign that is none.
constexpr int rankOfSign(std::string_view sign) {
  for (const BinaryOperator &binary : kBinaryOperators)
    if (binary.sign == sign)
      return binary.rank;
  return 0;
}

/// Those of what binds closer than any operator of two sides, and of what does less.
inline constexpr int kPrefixRank = 12, kPostfixRank = 13;
inline constexpr int kConditionalRank = 0, kAssignmentRank = -1;

/// = and the operators with it.
constexpr bool isAssignment(std::string_view sign) {
  return sign == "=" || (sign.size() > 1 && sign.back() == '=' &&
                         rankOfSign(sign.substr(0, sign.size() - 1)) > 3 && rankOfSign(sign) == 0);
}

static_assert(isAssignment("=") && isAssignment("<<=") && isAssignment("|=") && !isAssignment("==") &&
              !isAssignment("<=") && !isAssignment("!="));

} // namespace voxc::glsl
