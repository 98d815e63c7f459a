using System;
using System.Collections.Generic;

namespace UnityEngine.XR.OpenXR;

public static class OpenXRRuntime
{
    /// <summary>Extensions enabled by the simulated runtime; null for no runtime.</summary>
    internal static HashSet<string> Extensions { get; set; }

    /// <summary>The exception thrown by each call; null for none.</summary>
    internal static Exception Fault { get; set; }

    public static string name => Fault != null ? throw Fault : Extensions == null ? "" : "played";

    public static bool IsExtensionEnabled(string extensionName) => Extensions?.Contains(extensionName) == true;
}
