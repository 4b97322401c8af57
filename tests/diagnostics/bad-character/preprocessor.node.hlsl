#include "common.hlsl"
[node("Test/F")]
float F(float a = 1) {
    return a \ 2;
}
