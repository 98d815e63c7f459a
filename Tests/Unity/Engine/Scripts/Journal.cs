namespace Nowpose.Unity.Tests.Engine.Scripts;

/// <summary>Log of the entries that a test's scripts write, in order.</summary>
static class Journal
{
    public static List<string> Entries { get; } = [];

    public static void Note(string what) => Entries.Add(what);

    /// <summary>Returns all entries since the last call, separated by spaces, and removes them.</summary>
    public static string Take()
    {
        var text = string.Join(" ", Entries);
        Entries.Clear();
        return text;
    }
}
