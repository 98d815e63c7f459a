using System.Text;

namespace Nowpose.Gateway.Pairing;

/// <summary>
/// Reads and writes the file of paired headsets: text with one line per headset. It is created readable by its owner only, on Windows with the
/// permissions of its folder.
/// </summary>
/// <remarks>
/// Each change replaces the complete file, so that readers need no lock. Processes that change it take turns: each first locks a file beside it, which
/// stays.
/// </remarks>
static class HeadsetFile
{
    /// <summary>
    /// Maximum number of attempts to lock the file, together 10 s. Another process keeps the lock only for one change, but it can make many changes in
    /// a row, and each flush to a busy disk can take a second.
    /// </summary>
    const int Attempts = 400;

    static readonly TimeSpan AttemptInterval = TimeSpan.FromMilliseconds(25);

    /// <summary>Reads the file, and creates it if it does not exist.</summary>
    /// <exception cref="InputException">The file cannot be created or read, or a line is invalid.</exception>
    public static IReadOnlyList<PairedHeadset> Open(string path) => Guarded(path, () =>
    {
        if (!File.Exists(path)) Rewrite(path, text => text.Length == 0 ? HeadsetListMessages.Head : text, mayCreate: true);
        return Load(path);
    });

    /// <summary>Reads the file.</summary>
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
        var text = Guarded(path, () => Text(path));
        return Parse(path, text.Split('\n'), out fault);
    }

    /// <summary>Appends the line of a headset.</summary>
    /// <exception cref="InputException">The file is missing, so that the other headsets would be lost, or cannot be written.</exception>
    public static void Add(string path, PairedHeadset headset) => Rewrite(path, text =>
        // Adds a line end if an editor has saved the last line without one.
        text + (text.Length > 0 && text[^1] != '\n' ? "\n" : "") + headset + "\n");

    /// <summary>Removes the lines of headsets. Keeps all other text and the owner of the file.</summary>
    /// <exception cref="InputException">The file cannot be read or written.</exception>
    public static void Remove(string path, IReadOnlyCollection<PairedHeadset> headsets)
    {
        var gone = headsets.Select(headset => headset.ToString()).ToHashSet();
        Rewrite(path, text => string.Concat(
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

    static void Rewrite(string path, Func<string, string> change, bool mayCreate = false) => Guarded(path, () =>
    {
        var target = OutputFile.TargetOf(path);
        using var turn = Lock(target);
        var content = Encoding.UTF8.GetBytes(change(mayCreate && !File.Exists(target) ? "" : Text(target)));
        OutputFile.Write(target, file => file.Write(content), OutputFile.Secret);
        return true;
    });

    // Allows a change in the meantime: on Windows, a file that is open without this permission cannot be replaced.
    static string Text(string path)
    {
        using var reader = new StreamReader(new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete));
        return reader.ReadToEnd();
    }

    // Tries again while another process has the lock.
    static FileStream Lock(string path)
    {
        for (var left = Attempts; ; left--)
        {
            try
            {
                return OutputFile.Open(path + ".lock", FileMode.OpenOrCreate, path, OutputFile.Secret);
            }
            catch (IOException e) when (left > 1 && e is not DirectoryNotFoundException)
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
