using UnityEngine.Rendering;

namespace UnityEngine;

public sealed class SystemInfo
{
    public static string deviceModel => "Stand-in";
    public static string deviceName => "Stand-in 1";
    public static GraphicsDeviceType graphicsDeviceType => World.Current.Gpu.Api;
    public static RenderingThreadingMode renderingThreadingMode => World.Current.Gpu.Threading;
    public static bool supportsAsyncGPUReadback => World.Current.Gpu.ReadbackFrames >= 0;
}
