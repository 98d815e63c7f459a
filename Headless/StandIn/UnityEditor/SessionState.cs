namespace UnityEditor;

public class SessionState
{
    static readonly Dictionary<string, bool> Flags = new Dictionary<string, bool>();

    public static void SetBool(string key, bool value) => Flags[key] = value;

    public static bool GetBool(string key, bool defaultValue) => Flags.TryGetValue(key, out var value) ? value : defaultValue;

    /// <summary>Forgets everything, as at a restart of the editor.</summary>
    internal static void Clear() => Flags.Clear();
}
