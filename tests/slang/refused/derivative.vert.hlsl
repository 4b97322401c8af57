// A derivative where there are no pixels
struct VertexOutput
{
    float4 position : SV_Position;
};
VertexOutput main(float3 position : POSITION)
{
    VertexOutput output;
    output.position = float4(ddx(position), 1.0);
    return output;
}
