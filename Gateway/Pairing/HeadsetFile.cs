using System.Text;
using Nowpose.Gateway.Messages;

namespace Nowpose.Gateway.Pairing;

/// <summary>Reads and writes the file of paired headsets: text with one line per headset. It is created readable by its owner only.</summary>
static class HeadsetFile
{
    /// <summary>
    /// Maximum number of attempts to open the file, together 10 s. Another process keeps the file open only for one change, but it can make many
    /// changes in a row, and each flush to a busy disk can take a second.
    /// </summary>
    const int Attempts = 400;

    static readonly TimeSpan AttemptInterval = TimeSpan.FromMilliseconds(25);

    /// <summary>Reads the file, and creates it if it does not exist.</summary>
    /// <exception cref="InputException">The file cannot be created or read, or a line is invalid.</exception>
    public static IReadOnlyList<PairedHeadset> Open(string path) => Guarded(path, () =>
    {
        if (!File.Exists(path)) Rewrite(path, FileMode.OpenOrCreate, text => text.Length == 0 ? HeadsetListMessages.Head : text);
        return Load(path);
    });

    /// <summary>Reads the file. Returns an empty list if it does not exist.</summary>
    /// <exception cref="InputException">The file cannot be read, or a line is invalid.</exception>
    public static IReadOnlyList<PairedHeadset> Load(string path)
    {
        var headsets = Load(path, out var fault);
        return fault == null ? headsets : throw new InputException(fault);
    }

    /// <summary>Reads all valid lines, so that a token is revoked even if the edit that removed it made another line invalid.</summary>
    /// <param name="fault">Message about the first invalid line; null if all lines are valid.</param>
    /// <exception cref="InputException">The file cannot be read.</exception>
    public static IReadOnlyList<PairedHeadset> Load(string path, out string fault)
    {
        var lines = Guarded(path, () => File.Exists(path) ? Retried(() => File.ReadAllLines(path)) : []);
        return Parse(path, lines, out fault);
    }

    /// <summary>Appends the line of a headset.</summary>
    /// <exception cref="InputException">The file cannot be written.</exception>
    public static void Add(string path, PairedHeadset headset) => Rewrite(path, FileMode.OpenOrCreate, text =>
        // Adds a line end if an editor has saved the last line without one.
        text + (text.Length > 0 && text[^1] != '\n' ? "\n" : "") + headset + "\n");

    /// <summary>Removes the lines of headsets. Keeps all other text and the owner of the file.</summary>
    /// <exception cref="InputException">The file cannot be read or written.</exception>
    public static void Remove(string path, IReadOnlyCollection<PairedHeadset> headsets)
    {
        var gone = headsets.Select(headset => headset.ToString()).ToHashSet();
        Rewrite(path, FileMode.Open, text => string.Concat(
            text.Split('\n').Where(line => !gone.Contains(line.Trim())).Select(line => line + "\n")).TrimEnd('\n') + "\n");
    }

    static List<PairedHeadset> Parse(string path, string[] lines, out string fault)
    {
        fault = null;
        var headsets = new List<PairedHeadset>();
        for (var i = 0; i < lines.Length; i++)
        {
            var line = lines[i].Trim();
            if (line.Length == 0 || line[0] == '#') continue;
            if (PairedHeadset.Read(line) is { } headset) headsets.Add(headset);
            else fault ??= HeadsetListMessages.NotAnEntry(path, i + 1);
        }

        return headsets;
    }

    // Edits the file in place under an exclusive lock, so that pairing and revoking at the same time do not overwrite each other's change.
    static void Rewrite(string path, FileMode mode, Func<string, string> change) => Guarded(path, () =>
    {
        var options = new FileStreamOptions { Mode = mode, Access = FileAccess.ReadWrite, Share = FileShare.None };
        if (mode == FileMode.OpenOrCreate && !OperatingSystem.IsWindows())
            options.UnixCreateMode = UnixFileMode.UserRead | UnixFileMode.UserWrite;
        using var file = Retried(() => new FileStream(path, options));
        var before = new byte[file.Length];
        file.ReadExactly(before);
        var after = Encoding.UTF8.GetBytes(change(Encoding.UTF8.GetString(before)));
        file.Position = 0;
        file.Write(after);
        file.SetLength(after.Length);
        file.Flush(flushToDisk: true);
        return true;
    });

    // Tries again while another process has the file open.
    static T Retried<T>(Func<T> work)
    {
        for (var left = Attempts; ; left--)
        {
            try
            {
                return work();
            }
            catch (IOException e) when (left > 1 && e is not (FileNotFoundException or DirectoryNotFoundException))
            {
                Thread.Sleep(AttemptInterval);
            }
        }
    }

    static T Guarded<T>(string path, Func<T> work)
    {
        try
        {
            return work();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new InputException(HeadsetListMessages.Unusable(path, e.Message), e);
        }
    }
}
