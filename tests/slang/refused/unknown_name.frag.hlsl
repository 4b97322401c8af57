// A misspelt name
cbuffer Material : register(b4, space1)
{
    float4 _Tint;
};
struct FragmentOutput
{
    float4 color : SV_Target0;
};
FragmentOutput main()
{
    FragmentOutput output;
    output.color = _Tnit;
    return output;
}
