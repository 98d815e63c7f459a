using UnityEngine.Rendering;

namespace UnityEngine;

public sealed class SystemInfo
{
    public const string unsupportedIdentifier = "n/a";

    public static string deviceModel => "Stand-in";
    public static string deviceName => World.Current.Host.DeviceName;
    public static string deviceUniqueIdentifier => World.Current.Host.DeviceIdentifier;
    public static GraphicsDeviceType graphicsDeviceType => World.Current.Gpu.Api;
    public static RenderingThreadingMode renderingThreadingMode => World.Current.Gpu.Threading;
    public static bool supportsAsyncGPUReadback => World.Current.Gpu.ReadbackFrames >= 0;
}

public enum RuntimePlatform
{
    WindowsPlayer = 2,
    Android = 11,
    WSAPlayerARM = 20,
}
