namespace UnityEngine;

public sealed class SystemInfo
{
    public const string unsupportedIdentifier = "n/a";

    public static bool supportsAsyncGPUReadback => World.Current.Gpu.ReadbackFrames >= 0;
    public static string deviceName => "stand-in";
    public static string deviceModel => "stand-in";
    public static string graphicsDeviceName => "stand-in";
    public static string operatingSystem => "stand-in";
}
