namespace Nowpose.Packing;

/// <summary>A file, folder or symbolic link in an archive.</summary>
/// <param name="Name">Path in the archive with forward slashes, without a leading or trailing slash.</param>
/// <param name="Mode">Permissions.</param>
public sealed record ArchiveEntry(string Name, UnixFileMode Mode)
{
    const UnixFileMode Readable = UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.GroupRead | UnixFileMode.OtherRead;
    const UnixFileMode Executable = Readable | UnixFileMode.UserExecute | UnixFileMode.GroupExecute | UnixFileMode.OtherExecute;

    /// <summary>Opens the content of a file; null for a folder or link.</summary>
    public Func<Stream> Open { get; init; }

    /// <summary>Target of a symbolic link; null for a file or folder.</summary>
    public string LinkTarget { get; init; }

    /// <summary>Numeric id of the owning user and group.</summary>
    public int Owner { get; init; }

    public bool IsFolder => Open == null && LinkTarget == null;

    /// <summary>Lists the contents of a folder, sorted by name. Of the permissions, keeps only the executable bit.</summary>
    /// <param name="place">Path of the folder in the archive; empty for the top level.</param>
    public static IReadOnlyList<ArchiveEntry> OfFolder(string folder, string place)
    {
        var options = new EnumerationOptions { RecurseSubdirectories = true, AttributesToSkip = FileAttributes.None };
        var below = new DirectoryInfo(folder).EnumerateFileSystemInfos("*", options).Where(info => !IsBelowLink(info, folder))
            .Select(info => Of(info, Join(place, Path.GetRelativePath(folder, info.FullName).Replace('\\', '/'))));
        return [.. (place.Length == 0 ? below : below.Prepend(Folder(place))).OrderBy(entry => entry.Name, StringComparer.Ordinal)];
    }

    public static ArchiveEntry Folder(string name) => new(name, Executable);

    public static ArchiveEntry Text(string name, string text) =>
        new(name, Readable) { Open = () => new MemoryStream(System.Text.Encoding.UTF8.GetBytes(text)) };

    static ArchiveEntry Of(FileSystemInfo info, string name)
    {
        if (info.LinkTarget != null) return new ArchiveEntry(name, Executable | UnixFileMode.GroupWrite | UnixFileMode.OtherWrite) { LinkTarget = info.LinkTarget };
        if (info is DirectoryInfo) return Folder(name);
        var isProgram = info.UnixFileMode.HasFlag(UnixFileMode.UserExecute);
        return new ArchiveEntry(name, isProgram ? Executable : Readable) { Open = () => File.OpenRead(info.FullName) };
    }

    // Excludes the files below a link to a folder, because the link itself is an entry.
    static bool IsBelowLink(FileSystemInfo info, string folder)
    {
        for (var at = Path.GetDirectoryName(info.FullName); at != null && at.Length > folder.TrimEnd('/').Length; at = Path.GetDirectoryName(at))
            if (new DirectoryInfo(at).LinkTarget != null) return true;
        return false;
    }

    static string Join(string place, string name) => place.Length == 0 ? name : place + "/" + name;
}
