namespace UnityEngine.XR.OpenXR;

public class OpenXRSettings : ScriptableObject
{
    public enum DepthSubmissionMode
    {
        None,
        Depth16Bit,
        Depth24Bit,
    }

    public static OpenXRSettings Instance { get; internal set; }

    public DepthSubmissionMode depthSubmissionMode { get; set; }
}

public static class OpenXRRuntime
{
    /// <summary>Extensions that the simulated runtime has enabled; null if no runtime exists.</summary>
    internal static HashSet<string> Extensions { get; set; }

    /// <summary>Exception that each call throws; null if calls succeed.</summary>
    internal static Exception Fault { get; set; }

    public static string name => Fault != null ? throw Fault : Extensions == null ? "" : "played";

    public static bool IsExtensionEnabled(string extensionName) => Extensions?.Contains(extensionName) == true;
}
