// Made by scripts/make_elementary_tables.py; not to be edited.
#pragma once

#include <array>

namespace quadline::tables {

/// A value to twice the precision of a double: high + low.
struct Pair {
  double high, low;
};

/// 2 / pi
constexpr double kQuartersPerRadian = 0x1.45f306dc9c883p-1;

/// pi / 2 as a sum; products of the first three with whole numbers below 2^20 are exact
constexpr std::array<double, 4> kQuarter{0x1.921fb54400000p+0, 0x1.0b4611a600000p-34, 0x1.3198a2e000000p-69,
                                         0x1.b839a252049c1p-104};

/// (sin(r) - r) / r^3, of r^2 up to (pi / 4)^2; off by no more than 2^-66
constexpr std::array<double, 7> kSine{-0x1.5555555555555p-3, 0x1.1111111111110p-7,   -0x1.a01a01a019937p-13,
                                      0x1.71de3a54607a5p-19, -0x1.ae64541295cdfp-26, 0x1.61217ee5cca1bp-33,
                                      -0x1.ab17bdcbd3414p-41};

/// (cos(r) - 1 + r^2 / 2) / r^4, of r^2 up to (pi / 4)^2; off by no more than 2^-59
constexpr std::array<double, 6> kCosine{0x1.5555555555555p-5,   -0x1.6c16c16c16967p-10, 0x1.a01a019f4e9b4p-16,
                                        -0x1.27e4fa17bf139p-22, 0x1.1eeb68cd22f56p-29,  -0x1.907d8f29fe831p-37};

/// pi / 2 and pi
constexpr std::array<Pair, 2> kQuarterTurns{
    {{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54}, {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53}}};

/// arctan(i / 16)
constexpr std::array<Pair, 17> kArcTangentOf{{{0.0, 0.0},
                                              {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60},
                                              {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                              {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58},
                                              {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                              {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
                                              {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                              {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
                                              {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                              {0x1.0657e94db30d0p-1, -0x1.d5b495f6349e6p-56},
                                              {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                              {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
                                              {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                              {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
                                              {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                              {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
                                              {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}};

/// (arctan(u) - u) / u^3, of u^2 up to (1 / 31)^2; off by no more than 2^-50
constexpr std::array<double, 4> kArcTangent{-0x1.5555555555546p-2, 0x1.99999998b8bd2p-3, -0x1.249238a767f7cp-3,
                                            0x1.c6564c0dd1a28p-4};

/// log(2); the high part, like those of the table below, is a multiple of 2^-42: whole multiples up to
/// 1100 add up to a double without rounding
constexpr Pair kLogOf2{0x1.62e42fefa3800p-1, 0x1.ef35793c76730p-45};

/// log(1 + i / 32)
constexpr std::array<Pair, 33> kLogarithmOf{{{0.0, 0.0},
                                             {0x1.f829b0e780000p-6, 0x1.980267c7e09e4p-45},
                                             {0x1.f0a30c0118000p-5, -0x1.d599e83368e91p-45},
                                             {0x1.6f0d28ae58000p-4, -0x1.4b4641b664613p-44},
                                             {0x1.e27076e2b0000p-4, -0x1.a342c2af0003cp-45},
                                             {0x1.29552f8200000p-3, -0x1.5b967f4471dfcp-44},
                                             {0x1.5ff3070a7a000p-3, -0x1.8586f183bebf2p-44},
                                             {0x1.9525a9cf46000p-3, -0x1.297137d9f158fp-44},
                                             {0x1.c8ff7c79aa000p-3, -0x1.7794f689f8434p-45},
                                             {0x1.fb9186d5e4000p-3, -0x1.d572aab993c87p-47},
                                             {0x1.1675cababa000p-2, 0x1.8380e731f55c4p-44},
                                             {0x1.2e8e2bae12000p-2, -0x1.67b1e99b72bd8p-45},
                                             {0x1.4618bc21c6000p-2, -0x1.3d82f484c84ccp-46},
                                             {0x1.5d1bdbf581000p-2, -0x1.8d6bdc9c7c238p-44},
                                             {0x1.739d7f6bbd000p-2, 0x1.a7389314feb50p-52},
                                             {0x1.89a3386c14000p-2, 0x1.2d5ad38c40882p-45},
                                             {0x1.9f323ecbfa000p-2, -0x1.ed03525ca2643p-44},
                                             {0x1.b44f77bcc9000p-2, -0x1.3ae68224aa2cep-47},
                                             {0x1.c8ff7c79aa000p-2, -0x1.7794f689f8434p-44},
                                             {0x1.dd46a04c1c000p-2, 0x1.282fb989a9274p-44},
                                             {0x1.f128f5faf0000p-2, 0x1.bb2cd720ec44cp-44},
                                             {0x1.02552a5a5d000p-1, 0x1.fd8d38d2bafddp-46},
                                             {0x1.0be72e4252800p-1, 0x1.415b4c4bdd99fp-44},
                                             {0x1.154c3d2f4d800p-1, -0x1.0b2b38662e34dp-44},
                                             {0x1.1e85f5e704000p-1, 0x1.a07bd8b34be7cp-46},
                                             {0x1.2795e1289b000p-1, 0x1.1aeb783f3db97p-45},
                                             {0x1.307d7334f1000p-1, 0x1.7c3f6b2143eadp-46},
                                             {0x1.393e0d3562800p-1, 0x1.0cd4e221301b7p-44},
                                             {0x1.41d8fe8467000p-1, 0x1.5732325e617a3p-44},
                                             {0x1.4a4f85db04000p-1, -0x1.44fdd840b8591p-45},
                                             {0x1.52a2d265bc800p-1, -0x1.2a88c41ba8752p-44},
                                             {0x1.5ad404c35a000p-1, -0x1.a609acaab41fcp-46},
                                             {0x1.62e42fefa3800p-1, 0x1.ef35793c76730p-45}}};

/// (artanh(s) - s) / s^3, of s^2 up to (1 / 30)^2; off by no more than 2^-61
constexpr std::array<double, 5> kArtanh{0x1.5555555555555p-2, 0x1.99999999997fcp-3, 0x1.249249276910bp-3,
                                        0x1.c71c39e5d70e1p-4, 0x1.753d7f263ee56p-4};

/// 32 / log(2)
constexpr double kStepsPerUnit = 0x1.71547652b82fep+5;

/// log(2) / 32 as a sum; products of the first with whole numbers below 2^17 are exact
constexpr std::array<double, 2> kStep{0x1.62e42fefa0000p-6, 0x1.cf79abc9e3b3ap-45};

/// (exp(r) - 1 - r) / r^2, of r up to log(2) / 64 either way; off by no more than 2^-48
constexpr std::array<double, 5> kExponential{0x1.0000000000000p-1, 0x1.555555554d577p-3, 0x1.5555555551566p-5,
                                             0x1.1111518a3b36fp-7, 0x1.6c1701e53f7b9p-10};

/// 2^(i / 32)
constexpr std::array<Pair, 32> kPowerOf2{{{0x1.0000000000000p+0, 0.0},
                                          {0x1.059b0d3158574p+0, 0x1.d73e2a475b465p-55},
                                          {0x1.0b5586cf9890fp+0, 0x1.8a62e4adc610bp-54},
                                          {0x1.11301d0125b51p+0, -0x1.6c51039449b3ap-54},
                                          {0x1.172b83c7d517bp+0, -0x1.19041b9d78a76p-55},
                                          {0x1.1d4873168b9aap+0, 0x1.e016e00a2643cp-54},
                                          {0x1.2387a6e756238p+0, 0x1.9b07eb6c70573p-54},
                                          {0x1.29e9df51fdee1p+0, 0x1.612e8afad1255p-55},
                                          {0x1.306fe0a31b715p+0, 0x1.6f46ad23182e4p-55},
                                          {0x1.371a7373aa9cbp+0, -0x1.63aeabf42eae2p-54},
                                          {0x1.3dea64c123422p+0, 0x1.ada0911f09ebcp-55},
                                          {0x1.44e086061892dp+0, 0x1.89b7a04ef80d0p-59},
                                          {0x1.4bfdad5362a27p+0, 0x1.d4397afec42e2p-56},
                                          {0x1.5342b569d4f82p+0, -0x1.07abe1db13cadp-55},
                                          {0x1.5ab07dd485429p+0, 0x1.6324c054647adp-54},
                                          {0x1.6247eb03a5585p+0, -0x1.383c17e40b497p-54},
                                          {0x1.6a09e667f3bcdp+0, -0x1.bdd3413b26456p-54},
                                          {0x1.71f75e8ec5f74p+0, -0x1.16e4786887a99p-55},
                                          {0x1.7a11473eb0187p+0, -0x1.41577ee04992fp-55},
                                          {0x1.82589994cce13p+0, -0x1.d4c1dd41532d8p-54},
                                          {0x1.8ace5422aa0dbp+0, 0x1.6e9f156864b27p-54},
                                          {0x1.93737b0cdc5e5p+0, -0x1.75fc781b57ebcp-57},
                                          {0x1.9c49182a3f090p+0, 0x1.c7c46b071f2bep-56},
                                          {0x1.a5503b23e255dp+0, -0x1.d2f6edb8d41e1p-54},
                                          {0x1.ae89f995ad3adp+0, 0x1.7a1cd345dcc81p-54},
                                          {0x1.b7f76f2fb5e47p+0, -0x1.5584f7e54ac3bp-56},
                                          {0x1.c199bdd85529cp+0, 0x1.11065895048ddp-55},
                                          {0x1.cb720dcef9069p+0, 0x1.503cbd1e949dbp-56},
                                          {0x1.d5818dcfba487p+0, 0x1.2ed02d75b3707p-55},
                                          {0x1.dfc97337b9b5fp+0, -0x1.1a5cd4f184b5cp-54},
                                          {0x1.ea4afa2a490dap+0, -0x1.e9c23179c2893p-54},
                                          {0x1.f50765b6e4540p+0, 0x1.9d3e12dd8a18bp-54}}};

}  // namespace quadline::tables
