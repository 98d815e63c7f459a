using System.Globalization;

namespace Nowpose.Gateway.Recording;

/// <summary>Chooses the paths of recordings. Thread-safe.</summary>
/// <remarks>A file appears on the disk after its path was taken, because its writing thread creates it. The taken paths are therefore stored.</remarks>
/// <param name="cell">Name of the cell, with which file names begin; null or empty for a gateway without one.</param>
sealed class RecordingPaths(string folder, string cell)
{
    readonly Lock _lock = new();
    readonly HashSet<string> _taken = [];

    /// <summary>Returns a path that is not in use. Appends a number if an earlier recording in the same second or another gateway uses the name.</summary>
    public string Free(DateTime utcNow)
    {
        var name = $"{Safe(cell) ?? "gateway"}-{utcNow.ToString("yyyyMMdd'T'HHmmss'Z'", CultureInfo.InvariantCulture)}";
        for (var number = 1; ; number++)
        {
            var path = Path.Combine(folder, number == 1 ? $"{name}.jsonl" : $"{name}-{number}.jsonl");
            if (!IsTaken(path) && !File.Exists(path)) return path;
        }
    }

    /// <returns>False if the path was taken in the meantime.</returns>
    public bool TryTake(string path)
    {
        lock (_lock) return _taken.Add(path);
    }

    /// <summary>Releases the path of a file that has ended.</summary>
    public void Release(string path)
    {
        lock (_lock) _taken.Remove(path);
    }

    bool IsTaken(string path)
    {
        lock (_lock) return _taken.Contains(path);
    }

    static string Safe(string name) =>
        string.IsNullOrWhiteSpace(name) ? null : new string([.. name.Select(c => char.IsAsciiLetterOrDigit(c) || c is '-' or '_' ? c : '_').Take(40)]);
}
