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

/// (sin(r) - r) / r^3, of r^2 up to (1 / 8)^2; off by no more than 2^-56
constexpr std::array<double, 4> kSine{-0x1.5555555555555p-3, 0x1.111111110db47p-7, -0x1.a01a009327b59p-13,
                                      0x1.71c35502c809cp-19};

/// (cos(r) - 1) / r^2, of r^2 up to (1 / 63)^2; off by no more than 2^-56
constexpr std::array<double, 3> kCosine{-0x1.0000000000000p-1, 0x1.55555555362c9p-5, -0x1.6c16206448642p-10};

/// sin(i / 32)
constexpr std::array<Pair, 26> kSineOf{{{0.0, 0.0},
                                        {0x1.ffeaaaeeee86fp-6, -0x1.cd406fb224ae2p-60},
                                        {0x1.ffaaaeeed4edbp-5, -0x1.2d16d32684b69p-59},
                                        {0x1.7f701032550e4p-4, 0x1.afc2d1800501ap-60},
                                        {0x1.feaaeee86ee36p-4, -0x1.afcb2bcc6f03bp-59},
                                        {0x1.3eb312c5d66cbp-3, 0x1.47d666b66cb91p-57},
                                        {0x1.7dc102fbaf2b5p-3, 0x1.5ab50e23c97c3p-59},
                                        {0x1.bc6f84edc6199p-3, 0x1.9c1a56a7b0cabp-57},
                                        {0x1.faaeed4f31577p-3, -0x1.15d88508e32b8p-57},
                                        {0x1.1c37d64c6b876p-2, 0x1.46076fe0dcff4p-56},
                                        {0x1.3ad129769d3d8p-2, 0x1.03d550487839ap-63},
                                        {0x1.591bc9fa2f597p-2, 0x1.7c74bac3fe0cbp-57},
                                        {0x1.7710255764214p-2, -0x1.6ead7314bb6cep-57},
                                        {0x1.94a6be9f546c5p-2, -0x1.69ce13e683f58p-56},
                                        {0x1.b1d8305321617p-2, -0x1.ae242cb99f519p-56},
                                        {0x1.ce9d2e3d4a51fp-2, -0x1.2fc8a12dae298p-57},
                                        {0x1.eaee8744b05f0p-2, -0x1.789b43c9b027dp-58},
                                        {0x1.0362939c69955p-1, -0x1.2d8cd78397b01p-55},
                                        {0x1.110d0c4b69c3bp-1, 0x1.d918998809981p-55},
                                        {0x1.1e7343236574cp-1, 0x1.22a3fa4f41d5ap-56},
                                        {0x1.2b91dea88421ep-1, -0x1.fa371db216ab0p-55},
                                        {0x1.386597456282bp-1, -0x1.10fada93b07a8p-56},
                                        {0x1.44eb381cf386bp-1, -0x1.3ed6c1e6a5505p-55},
                                        {0x1.511f9fd7b351cp-1, -0x1.5c0e861c48831p-55},
                                        {0x1.5cffc16bf8f0dp-1, 0x1.96cb370eb578ap-55},
                                        {0x1.6888a4e134b2fp-1, -0x1.6b7d37644d5e6p-55}}};

/// cos(i / 32)
constexpr std::array<Pair, 26> kCosineOf{{{0x1.0000000000000p+0, 0.0},
                                          {0x1.ffc00155527d3p-1, -0x1.3b54492d89b5bp-55},
                                          {0x1.ff0015549f4d3p-1, 0x1.328387b99426fp-55},
                                          {0x1.fdc06bf7e6b9bp-1, 0x1.31902b535f8dbp-55},
                                          {0x1.fc015527d5bd3p-1, 0x1.b68f35094efb8p-55},
                                          {0x1.f9c340a7cc428p-1, 0x1.c5b6b063b7462p-55},
                                          {0x1.f706bdf9ece1cp-1, -0x1.698c80c36dcb4p-55},
                                          {0x1.f3cc7c3b3d16ep-1, -0x1.21a3ad28a3494p-57},
                                          {0x1.f01549f7deea1p-1, 0x1.d3c1e99e5cafdp-55},
                                          {0x1.ebe214f76efa8p-1, -0x1.02f9f12ba543ep-55},
                                          {0x1.e733ea0193d40p-1, -0x1.6428b3546ce13p-55},
                                          {0x1.e20bf49acd6c1p-1, -0x1.660aec7ef636bp-58},
                                          {0x1.dc6b7eb995912p-1, 0x1.4b364776dcd35p-58},
                                          {0x1.d653f073e4040p-1, -0x1.76236434bec37p-55},
                                          {0x1.cfc6cfa52ad9fp-1, 0x1.8b5b5508f2a0dp-55},
                                          {0x1.c8c5bf8ce1a84p-1, 0x1.ab3d1a1590123p-56},
                                          {0x1.c1528065b7d50p-1, -0x1.892111312e828p-55},
                                          {0x1.b96eeef58840ep-1, 0x1.45a3cc78fade0p-58},
                                          {0x1.b11d04162a4c6p-1, 0x1.1dd561efbc0c2p-56},
                                          {0x1.a85ed4373e02dp-1, 0x1.9be06385ec792p-57},
                                          {0x1.9f368ed912f85p-1, -0x1.1d200c5791606p-55},
                                          {0x1.95a67e00cb1fdp-1, -0x1.0befda21f862dp-55},
                                          {0x1.8bb105a5dc900p-1, 0x1.863e03e9474c1p-55},
                                          {0x1.8158a31916d5dp-1, -0x1.de8b90b8228dep-57},
                                          {0x1.769fec655211fp-1, -0x1.827d5cf8c68c5p-57},
                                          {0x1.6b898fa9efb5dp-1, 0x1.15ac786ccf4b2p-56}}};

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
