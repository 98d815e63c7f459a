using System.Collections.Generic;

namespace UnityEngine.InputSystem;

/// <summary>What the devices that are connected report, by the paths that are bound; a test is the device.</summary>
static class Controls
{
    static readonly Dictionary<string, (object Value, int Frame)> Values = new Dictionary<string, (object Value, int Frame)>();

    /// <summary>Reports a value as of the next frame; for a button whether it is pressed.</summary>
    internal static void Set(string path, object value) => Values[path] = (value, Time.frameCount + 1);

    /// <summary>Disconnects everything.</summary>
    internal static void Clear() => Values.Clear();

    internal static bool TryGet(string path, out object value, out int since)
    {
        var isKnown = Values.TryGetValue(path, out var known);
        (value, since) = known;
        return isKnown;
    }
}
