using UnityEditor.PackageManager.Requests;

namespace UnityEditor.PackageManager;

public static class Client
{
    /// <summary>Identifiers of the requested packages, oldest first.</summary>
    internal static List<string> Asked { get; } = new List<string>();

    /// <summary>Number of calls of <see cref="Resolve"/>.</summary>
    internal static int Resolved { get; set; }

    internal static AddRequest Newest { get; private set; }

    public static AddRequest Add(string identifier)
    {
        Asked.Add(identifier);
        return Newest = new AddRequest();
    }

    public static void Resolve() => Resolved++;

    internal static void Reset()
    {
        Asked.Clear();
        Resolved = 0;
        Newest = null;
    }
}
