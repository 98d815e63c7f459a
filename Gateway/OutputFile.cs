using Nowpose.Gateway.Security;

namespace Nowpose.Gateway;

/// <summary>
/// Writes the files of the commands as a whole: if the process ends or fails while it writes, the earlier file is unchanged. An existing file keeps its
/// owner and permissions, and a symbolic link keeps its target. Pipes and devices are written directly.
/// </summary>
static class OutputFile
{
    /// <summary>Maximum number of symbolic links in a path, as on Linux. More of them form a loop.</summary>
    const int MaxLinks = 40;

    /// <summary>Permissions of a file that only its owner may read. On Windows, a file has the permissions of its folder instead.</summary>
    public const UnixFileMode Secret = UnixFileMode.UserRead | UnixFileMode.UserWrite;

    public static void Write(string path, string text) => Write(path, (TextWriter file) => file.Write(text));

    public static void Write(string path, Action<TextWriter> write) => Write(path, (Stream file) =>
    {
        using var writer = new StreamWriter(file, leaveOpen: true);
        write(writer);
    });

    /// <param name="path">Path of the file. Its folder must exist.</param>
    /// <param name="write">Writes the content.</param>
    /// <param name="mode">Permissions of a new file on Unix; null for the default.</param>
    public static void Write(string path, Action<Stream> write, UnixFileMode? mode = null)
    {
        var target = TargetOf(path);
        // Opens an existing file also to respect its write protection, which does not prevent a replacement.
        using (var present = Existing(path))
        {
            if (present != null && (!present.CanSeek || IsDevice(target)))
            {
                write(present);
                return;
            }
        }

        WholeFile.Write(target, write, temporary => Open(temporary, FileMode.Create, target, mode));
    }

    // Opens the path instead of its target, because the target of /dev/stdout may be a pipe without a path.
    static FileStream Existing(string path)
    {
        try
        {
            return new FileStream(path, FileMode.Open, FileAccess.Write, FileShare.ReadWrite | FileShare.Delete, 0);
        }
        catch (FileNotFoundException)
        {
            return null;
        }
    }

    // Some devices, such as /dev/null, can seek. Below /dev/shm are ordinary files.
    static bool IsDevice(string target) =>
        target.StartsWith("/dev/", StringComparison.Ordinal) && !target.StartsWith("/dev/shm/", StringComparison.Ordinal);

    /// <summary>Writes a new file that only its owner may read. An existing file is kept, and the method throws.</summary>
    public static void CreateSecret(string path, byte[] content) => WholeFile.Write(
        path, file => file.Write(content), temporary => Open(temporary, FileMode.Create, path, Secret), mayExist: false);

    /// <summary>Opens a file for this process only, with the owner and the permissions of another file.</summary>
    /// <param name="like">Path of the other file.</param>
    /// <param name="mode">Permissions if the other file does not exist; null for the default.</param>
    public static FileStream Open(string path, FileMode open, string like, UnixFileMode? mode)
    {
        var options = new FileStreamOptions { Mode = open, Access = FileAccess.Write, Share = FileShare.None };
        if (OperatingSystem.IsWindows()) return new FileStream(path, options);
        var isKept = File.Exists(like);
        if (isKept) mode = File.GetUnixFileMode(like);
        if (mode != null) options.UnixCreateMode = Secret;
        var file = new FileStream(path, options);
        try
        {
            if (mode != null && File.GetUnixFileMode(file.SafeFileHandle) != mode) File.SetUnixFileMode(file.SafeFileHandle, mode.Value);
            if (isKept) FileOwner.Copy(like, path);
            return file;
        }
        catch
        {
            file.Dispose();
            throw;
        }
    }

    /// <summary>Gets the full path of the file to which a path leads, without symbolic links. The file need not exist.</summary>
    /// <exception cref="IOException">The links do not end.</exception>
    public static string TargetOf(string path)
    {
        var links = 0;
        return Resolve(Path.GetFullPath(path));

        string Resolve(string full)
        {
            if (Path.GetDirectoryName(full) is not { } folder) return full;
            folder = Resolve(folder);
            full = Path.Combine(folder, Path.GetFileName(full));
            if (new FileInfo(full).LinkTarget is not { } target) return full;
            return ++links <= MaxLinks ? Resolve(Path.GetFullPath(target, folder)) : throw new IOException(PathMessages.TooManyLinks(path, MaxLinks));
        }
    }

    /// <summary>Checks that files can be created in a folder. Permissions alone do not show that a file system is read-only.</summary>
    /// <exception cref="IOException">No file can be created.</exception>
    /// <exception cref="UnauthorizedAccessException">No file can be created.</exception>
    public static void TryIn(string folder) => new FileStream(
        Path.Combine(folder, Path.GetRandomFileName()), FileMode.CreateNew, FileAccess.Write, FileShare.None, 1, FileOptions.DeleteOnClose).Dispose();
}
