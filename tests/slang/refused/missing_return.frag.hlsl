// A function that does not always return
float Above(float value)
{
    if (value > 0.0) {
        return value;
    }
}
float4 main(float2 uv : TEXCOORD0) : SV_Target0
{
    return float4(uv, Above(uv.x), 1.0);
}
