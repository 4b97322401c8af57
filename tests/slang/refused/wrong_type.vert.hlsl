// A texture where a number belongs
Texture2D _MainTex : register(t0, space1);
struct VertexOutput
{
    float4 position : SV_Position;
};
VertexOutput main(float3 position : POSITION)
{
    VertexOutput output;
    output.position = float4(position, _MainTex);
    return output;
}
