namespace UnityEngine.Rendering;

public enum GraphicsDeviceType
{
    Direct3D11 = 2,
    Direct3D12 = 18,
    Vulkan = 21,
}
