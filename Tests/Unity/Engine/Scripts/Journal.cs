namespace Nowpose.Unity.Tests.Engine.Scripts;

/// <summary>Notes that the scripts of a test make, in order.</summary>
static class Journal
{
    public static List<string> Entries { get; } = [];

    public static void Note(string what) => Entries.Add(what);

    /// <summary>Returns all notes since the last call, separated by spaces, and removes them.</summary>
    public static string Take()
    {
        var text = string.Join(" ", Entries);
        Entries.Clear();
        return text;
    }
}
