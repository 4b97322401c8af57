[pass("mine")] [fragment]
float4 mineFragment() {
    return float4(1, 0, 0, 1);
}
