namespace Nowpose.Unity.Tests.Engine.Scripts;

/// <summary>What scripts of a test did, in order.</summary>
static class Journal
{
    public static List<string> Entries { get; } = [];

    public static void Note(string what) => Entries.Add(what);

    /// <summary>What was noted since, joined with blanks.</summary>
    public static string Take()
    {
        var text = string.Join(" ", Entries);
        Entries.Clear();
        return text;
    }
}
