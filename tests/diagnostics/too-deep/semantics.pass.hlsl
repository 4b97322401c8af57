[semantic("pixel")]
float s0(float value = s1) {
    return value;
}
[semantic("pixel")]
float s1(float value = s2) {
    return value;
}
[semantic("pixel")]
float s2(float value = s3) {
    return value;
}
[semantic("pixel")]
float s3(float value = s4) {
    return value;
}
[semantic("pixel")]
float s4(float value = s5) {
    return value;
}
[semantic("pixel")]
float s5(float value = s6) {
    return value;
}
[semantic("pixel")]
float s6(float value = s7) {
    return value;
}
[semantic("pixel")]
float s7(float value = s8) {
    return value;
}
[semantic("pixel")]
float s8(float value = s9) {
    return value;
}
[semantic("pixel")]
float s9(float value = s10) {
    return value;
}
[semantic("pixel")]
float s10(float value = s11) {
    return value;
}
[semantic("pixel")]
float s11(float value = s12) {
    return value;
}
[semantic("pixel")]
float s12(float value = s13) {
    return value;
}
[semantic("pixel")]
float s13(float value = s14) {
    return value;
}
[semantic("pixel")]
float s14(float value = s15) {
    return value;
}
[semantic("pixel")]
float s15(float value = s16) {
    return value;
}
[semantic("pixel")]
float s16(float value = s17) {
    return value;
}
[semantic("pixel")]
float s17(float value = s18) {
    return value;
}
[semantic("pixel")]
float s18(float value = s19) {
    return value;
}
[semantic("pixel")]
float s19(float value = s20) {
    return value;
}
[semantic("pixel")]
float s20(float value = s21) {
    return value;
}
[semantic("pixel")]
float s21(float value = s22) {
    return value;
}
[semantic("pixel")]
float s22(float value = s23) {
    return value;
}
[semantic("pixel")]
float s23(float value = s24) {
    return value;
}
[semantic("pixel")]
float s24(float value = s25) {
    return value;
}
[semantic("pixel")]
float s25(float value = s26) {
    return value;
}
[semantic("pixel")]
float s26(float value = s27) {
    return value;
}
[semantic("pixel")]
float s27(float value = s28) {
    return value;
}
[semantic("pixel")]
float s28(float value = s29) {
    return value;
}
[semantic("pixel")]
float s29(float value = s30) {
    return value;
}
[semantic("pixel")]
float s30(float value = s31) {
    return value;
}
[semantic("pixel")]
float s31(float value = s32) {
    return value;
}
[semantic("pixel")]
float s32(float value = s33) {
    return value;
}
[semantic("pixel")]
float s33(float value = s34) {
    return value;
}
[semantic("pixel")]
float s34(float value = s35) {
    return value;
}
[semantic("pixel")]
float s35(float value = s36) {
    return value;
}
[semantic("pixel")]
float s36(float value = s37) {
    return value;
}
[semantic("pixel")]
float s37(float value = s38) {
    return value;
}
[semantic("pixel")]
float s38(float value = s39) {
    return value;
}
[semantic("pixel")]
float s39(float value = s40) {
    return value;
}
[semantic("pixel")]
float s40(float value = s41) {
    return value;
}
[semantic("pixel")]
float s41(float value = s42) {
    return value;
}
[semantic("pixel")]
float s42(float value = s43) {
    return value;
}
[semantic("pixel")]
float s43(float value = s44) {
    return value;
}
[semantic("pixel")]
float s44(float value = s45) {
    return value;
}
[semantic("pixel")]
float s45(float value = s46) {
    return value;
}
[semantic("pixel")]
float s46(float value = s47) {
    return value;
}
[semantic("pixel")]
float s47(float value = s48) {
    return value;
}
[semantic("pixel")]
float s48(float value = s49) {
    return value;
}
[semantic("pixel")]
float s49(float value = s50) {
    return value;
}
[semantic("pixel")]
float s50(float value = s51) {
    return value;
}
[semantic("pixel")]
float s51(float value = s52) {
    return value;
}
[semantic("pixel")]
float s52(float value = s53) {
    return value;
}
[semantic("pixel")]
float s53(float value = s54) {
    return value;
}
[semantic("pixel")]
float s54(float value = s55) {
    return value;
}
[semantic("pixel")]
float s55(float value = s56) {
    return value;
}
[semantic("pixel")]
float s56(float value = s57) {
    return value;
}
[semantic("pixel")]
float s57(float value = s58) {
    return value;
}
[semantic("pixel")]
float s58(float value = s59) {
    return value;
}
[semantic("pixel")]
float s59(float value = s60) {
    return value;
}
[semantic("pixel")]
float s60(float value = s61) {
    return value;
}
[semantic("pixel")]
float s61(float value = s62) {
    return value;
}
[semantic("pixel")]
float s62(float value = s63) {
    return value;
}
[semantic("pixel")]
float s63(float value = s64) {
    return value;
}
[semantic("pixel")]
float s64(float value = s65) {
    return value;
}
[semantic("pixel")]
float s65(float value = s66) {
    return value;
}
[semantic("pixel")]
float s66(float value = s67) {
    return value;
}
[semantic("pixel")]
float s67(float value = s68) {
    return value;
}
[semantic("pixel")]
float s68(float value = s69) {
    return value;
}
[semantic("pixel")]
float s69(float value = s70) {
    return value;
}
[semantic("pixel")]
float s70() {
    return 1;
}

[pass("mine")] [vertex]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mineFragment(float value = s0) {
    return float4(value);
}
