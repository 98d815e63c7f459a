using System.Text;

namespace Nowpose.Gateway.Pairing;

/// <summary>The headsets that were paired, a line each, for programs and people; only its owner may read it.</summary>
static class HeadsetFile
{
    const string Head = "# Headsets that this gateway has paired. Remove a line to revoke its token; it holds for the next connection.\n";

    /// <summary>Makes the file where there is none.</summary>
    /// <exception cref="InputException">It cannot be made or read, or a line is something else.</exception>
    public static IReadOnlyList<PairedHeadset> Open(string path) => Guarded(path, () =>
    {
        if (!File.Exists(path)) Append(path, Head);
        return Read(path);
    });

    /// <summary>No file is no headsets.</summary>
    /// <exception cref="InputException">It cannot be read, or a line is something else.</exception>
    public static IReadOnlyList<PairedHeadset> Load(string path) => Guarded(path, () => File.Exists(path) ? Read(path) : []);

    /// <exception cref="InputException">It cannot be written.</exception>
    public static void Add(string path, PairedHeadset headset) => Guarded(path, () =>
    {
        // An editor may have left the last line without its end.
        var isOpenEnded = File.Exists(path) && File.ReadAllText(path) is { Length: > 0 } text && text[^1] != '\n';
        Append(path, (isOpenEnded ? "\n" : "") + headset + "\n");
        return true;
    });

    /// <summary>Removes lines, and keeps what stands between them.</summary>
    /// <exception cref="InputException">It cannot be read or written.</exception>
    public static void Remove(string path, IReadOnlyCollection<PairedHeadset> headsets) => Guarded(path, () =>
    {
        var gone = headsets.Select(headset => headset.ToString()).ToHashSet();
        var left = File.ReadAllLines(path).Where(line => !gone.Contains(line.Trim())).Select(line => line + "\n");
        var unfinished = path + ".new";
        File.Delete(unfinished);
        Append(unfinished, string.Concat(left));
        File.Move(unfinished, path, overwrite: true);
        return true;
    });

    static List<PairedHeadset> Read(string path)
    {
        var lines = File.ReadAllLines(path).Select((line, index) => (Text: line.Trim(), Number: index + 1));
        return [.. lines.Where(line => line.Text.Length > 0 && line.Text[0] != '#').Select(line => PairedHeadset.Read(line.Text)
            ?? throw new InputException($"{path}, line {line.Number}: is no paired headset; correct or remove it"))];
    }

    static void Append(string path, string text)
    {
        var options = new FileStreamOptions { Mode = FileMode.Append, Access = FileAccess.Write, Share = FileShare.Read };
        if (!OperatingSystem.IsWindows())
            options.UnixCreateMode = UnixFileMode.UserRead | UnixFileMode.UserWrite;
        using var file = new FileStream(path, options);
        file.Write(Encoding.UTF8.GetBytes(text));
        file.Flush(flushToDisk: true);
    }

    static T Guarded<T>(string path, Func<T> work)
    {
        try
        {
            return work();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new InputException($"{path}: the list of paired headsets cannot be used ({e.Message})", e);
        }
    }
}
