using System.Collections.Generic;

namespace UnityEngine.InputSystem;

/// <summary>Values of the connected devices by their bound paths, set by a test.</summary>
static class Controls
{
    static readonly Dictionary<string, (object Value, int Frame)> Values = new Dictionary<string, (object Value, int Frame)>();

    /// <summary>Sets a value from the next frame on; for a button, whether it is pressed.</summary>
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
