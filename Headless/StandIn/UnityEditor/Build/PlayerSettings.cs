using UnityEditor.Build;
using UnityEngine.Rendering;

namespace UnityEditor;

public sealed class PlayerSettings : Object
{
    static readonly Dictionary<string, ScriptingImplementation> Backends = new Dictionary<string, ScriptingImplementation>();
    static readonly Dictionary<string, ApiCompatibilityLevel> ApiLevels = new Dictionary<string, ApiCompatibilityLevel>();

    static readonly Dictionary<BuildTarget, GraphicsDeviceType[]> GraphicsApis = new Dictionary<BuildTarget, GraphicsDeviceType[]>();

    PlayerSettings() { }

    public static bool graphicsJobs { get; set; } = true;

    public static bool enableFrameTimingStats { get; set; }
    public static bool runInBackground { get; set; }

    public static ScriptingImplementation GetScriptingBackend(NamedBuildTarget buildTarget) =>
        Backends.TryGetValue(buildTarget.TargetName, out var backend) ? backend : ScriptingImplementation.Mono2x;

    public static void SetScriptingBackend(NamedBuildTarget buildTarget, ScriptingImplementation backend) => Backends[buildTarget.TargetName] = backend;

    public static ApiCompatibilityLevel GetApiCompatibilityLevel(NamedBuildTarget buildTarget) =>
        ApiLevels.TryGetValue(buildTarget.TargetName, out var level) ? level : ApiCompatibilityLevel.NET_Unity_4_8;

    public static void SetApiCompatibilityLevel(NamedBuildTarget buildTarget, ApiCompatibilityLevel value) => ApiLevels[buildTarget.TargetName] = value;

    /// <summary>Returns the graphics APIs that the project has set. If it has set none, returns the default of Unity 6.</summary>
    public static GraphicsDeviceType[] GetGraphicsAPIs(BuildTarget platform) =>
        GraphicsApis.TryGetValue(platform, out var apis) ? apis : new[] { GraphicsDeviceType.Direct3D12, GraphicsDeviceType.Direct3D11 };

    public static bool GetUseDefaultGraphicsAPIs(BuildTarget platform) => !GraphicsApis.ContainsKey(platform);

    public static void SetGraphicsAPIs(BuildTarget platform, GraphicsDeviceType[] apis)
    {
        if (GraphicsApis.ContainsKey(platform)) GraphicsApis[platform] = apis;
    }

    public static void SetUseDefaultGraphicsAPIs(BuildTarget platform, bool automatic)
    {
        if (automatic) GraphicsApis.Remove(platform);
        else GraphicsApis[platform] = GetGraphicsAPIs(platform);
    }

    /// <summary>Resets all settings to their defaults.</summary>
    internal static void Reset()
    {
        Backends.Clear();
        ApiLevels.Clear();
        GraphicsApis.Clear();
        graphicsJobs = true;
        enableFrameTimingStats = runInBackground = false;
        WSA.Capabilities.Clear();
        Android.forceInternetPermission = false;
        Android.targetArchitectures = AndroidArchitecture.ARM64;
    }

    public enum WSACapability
    {
        InternetClient = 1,
        PrivateNetworkClientServer = 5,
        WebCam = 9,
        Microphone = 11,
        SpatialPerception = 23,
        GazeInput = 37,
    }

    public class Android
    {
        public static bool forceInternetPermission { get; set; }
        public static AndroidArchitecture targetArchitectures { get; set; } = AndroidArchitecture.ARM64;
    }

    public sealed class WSA
    {
        internal static readonly HashSet<WSACapability> Capabilities = new HashSet<WSACapability>();

        public static bool GetCapability(WSACapability capability) => Capabilities.Contains(capability);

        public static void SetCapability(WSACapability capability, bool value)
        {
            if (value) Capabilities.Add(capability);
            else Capabilities.Remove(capability);
        }
    }
}

[Flags]
public enum AndroidArchitecture : uint
{
    ARM64 = 2,
    X86_64 = 8,
}

public enum ApiCompatibilityLevel
{
    NET_Standard = 6,
    NET_Unity_4_8 = 3,
}

public enum ScriptingImplementation
{
    Mono2x = 0,
    IL2CPP = 1,
}
