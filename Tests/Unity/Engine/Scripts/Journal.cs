namespace Nowpose.Unity.Tests.Engine.Scripts;

/// <summary>Notes of a test's scripts, in order.</summary>
static class Journal
{
    public static List<string> Entries { get; } = [];

    public static void Note(string what) => Entries.Add(what);

    /// <summary>Returns the notes since the last call, joined with spaces, and removes them.</summary>
    public static string Take()
    {
        var text = string.Join(" ", Entries);
        Entries.Clear();
        return text;
    }
}
