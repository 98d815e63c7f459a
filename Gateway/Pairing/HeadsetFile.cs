using System.Text;
using Nowpose.Gateway.Messages;

namespace Nowpose.Gateway.Pairing;

/// <summary>The file of paired headsets, one line each, for programs and people. Only its owner may read it.</summary>
static class HeadsetFile
{
    const string Head = HeadsetListMessages.Head;

    const int Attempts = 20;

    static readonly TimeSpan AttemptInterval = TimeSpan.FromMilliseconds(25);

    /// <summary>Creates the file if it does not exist.</summary>
    /// <exception cref="InputException">The file cannot be created or read, or a line is invalid.</exception>
    public static IReadOnlyList<PairedHeadset> Open(string path) => Guarded(path, () =>
    {
        if (!File.Exists(path)) Rewrite(path, FileMode.OpenOrCreate, text => text.Length == 0 ? Head : text);
        return Load(path);
    });

    /// <summary>Reads the file; a missing file means no headsets.</summary>
    /// <exception cref="InputException">The file cannot be read, or a line is invalid.</exception>
    public static IReadOnlyList<PairedHeadset> Load(string path)
    {
        var headsets = Load(path, out var fault);
        return fault == null ? headsets : throw new InputException(fault);
    }

    /// <summary>Reads all valid lines. An invalid line must not keep a token valid that was removed in the same edit.</summary>
    /// <param name="fault">Describes the first invalid line; null if all are valid.</param>
    /// <exception cref="InputException">The file cannot be read.</exception>
    public static IReadOnlyList<PairedHeadset> Load(string path, out string fault)
    {
        var lines = Guarded(path, () => File.Exists(path) ? Retried(() => File.ReadAllLines(path)) : []);
        return Parse(path, lines, out fault);
    }

    /// <exception cref="InputException">The file cannot be written.</exception>
    public static void Add(string path, PairedHeadset headset) => Rewrite(path, FileMode.OpenOrCreate, text =>
        // An editor may have left the last line without a line end.
        text + (text.Length > 0 && text[^1] != '\n' ? "\n" : "") + headset + "\n");

    /// <summary>Removes lines. Keeps the text between them, and the file's owner.</summary>
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

    // Edited in place with an exclusive lock: a gateway that pairs while a token is revoked loses neither change.
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

    // Another process has the file open for a short time only.
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
