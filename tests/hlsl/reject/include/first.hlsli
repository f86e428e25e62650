// On the register that another takes too.
Texture2D<float4> first : register(t3);
