using System;
using System.Collections.Generic;

namespace UnityEngine.XR.OpenXR;

public static class OpenXRRuntime
{
    /// <summary>Extensions that the played runtime has enabled; null for no runtime.</summary>
    internal static HashSet<string> Extensions { get; set; }

    /// <summary>Thrown by each call; null for none.</summary>
    internal static Exception Fault { get; set; }

    public static string name => Fault != null ? throw Fault : Extensions == null ? "" : "played";

    public static bool IsExtensionEnabled(string extensionName) => Extensions?.Contains(extensionName) == true;
}
