namespace UnityEngine.InputSystem;

/// <summary>Values of the controls of connected devices, by their binding paths. Tests set them.</summary>
static class Controls
{
    static readonly Dictionary<string, (object Value, int Frame)> Values = new Dictionary<string, (object Value, int Frame)>();

    /// <summary>Sets the value of a control from the next frame on. The value of a button is whether it is pressed.</summary>
    internal static void Set(string path, object value)
    {
        if (!Values.TryGetValue(path, out var known) || !known.Value.Equals(value)) Values[path] = (value, Time.frameCount + 1);
    }

    /// <summary>Disconnects all devices.</summary>
    internal static void Clear() => Values.Clear();

    internal static bool TryGet(string path, out object value, out int since)
    {
        var isKnown = Values.TryGetValue(path, out var known);
        (value, since) = known;
        return isKnown;
    }
}
