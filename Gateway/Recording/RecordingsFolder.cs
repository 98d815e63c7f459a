using System.Text.RegularExpressions;
using Nowpose.Gateway.Status;

namespace Nowpose.Gateway.Recording;

/// <summary>A recording in the gateway's folder.</summary>
sealed record StoredRecording(string Name, long Bytes, string ChangedUtc);

/// <summary>The recordings in the gateway's folder. Thread-safe.</summary>
/// <param name="path">Path of the folder; null if none is configured.</param>
sealed partial class RecordingsFolder(string path)
{
    internal const int MaxListed = 1000;

    /// <summary>Gets the newest recordings, the newest first; an empty list if no folder is configured.</summary>
    /// <exception cref="IOException">The folder cannot be read now, so that it is not known which recordings exist.</exception>
    public IReadOnlyList<StoredRecording> List()
    {
        try
        {
            if (path == null) return [];
            return
            [
                .. new DirectoryInfo(path).EnumerateFiles("*.jsonl").Select(Refreshed).Where(IsRecording)
                    .OrderByDescending(file => file.LastWriteTimeUtc).Take(MaxListed)
                    .Select(file => new StoredRecording(file.Name, file.Length, UtcText.Of(file.LastWriteTimeUtc))),
            ];
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new IOException(RecorderMessages.FolderNotRead(e.Message), e);
        }
    }

    /// <summary>Gets the file of a recording; null for a name that is not a recording in this folder.</summary>
    public FileInfo Find(string name)
    {
        // A name that matches has no path separator, so the path stays inside the folder.
        if (path == null || !Name().IsMatch(name)) return null;
        var file = new FileInfo(Path.Combine(path, name));
        return IsRecording(file) ? file : null;
    }

    // In an enumeration, Windows returns the size and the time that an open file had when it was opened.
    internal static FileInfo Refreshed(FileInfo file)
    {
        file.Refresh();
        return file;
    }

    // Excludes files that were deleted after the enumeration, and symbolic links, because a link can point to a file outside the folder.
    static bool IsRecording(FileInfo file) => file.Exists && file.LinkTarget == null && Name().IsMatch(file.Name);

    [GeneratedRegex(@"\A[A-Za-z0-9_-]{1,100}\.jsonl\z")]
    private static partial Regex Name();
}
