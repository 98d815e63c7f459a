using Nowpose.Editor.Setup;

namespace Nowpose.Cli.Unity;

/// <summary>A folder with a Unity project.</summary>
sealed class UnityProject
{
    // A link may lead to a folder above it.
    static readonly EnumerationOptions Below = new()
    {
        RecurseSubdirectories = true, IgnoreInaccessible = true, AttributesToSkip = FileAttributes.ReparsePoint,
    };

    UnityProject(string root, UnityVersion version)
    {
        Root = root;
        Version = version;
    }

    /// <summary>Absolute path of the folder that contains Assets and Packages.</summary>
    public string Root { get; }

    /// <summary>Unity version with which the project was last opened.</summary>
    public UnityVersion Version { get; }

    public string ManifestPath => ManifestIn(Root);
    public string VersionPath => VersionIn(Root);

    /// <exception cref="InputException">The folder is not a Unity project.</exception>
    public static UnityProject Open(string path)
    {
        if (string.IsNullOrWhiteSpace(path)) throw new InputException(UnityProjectMessages.NoPath);
        var root = Path.TrimEndingDirectorySeparator(Path.GetFullPath(path));
        if (File.Exists(root)) throw new InputException(UnityProjectMessages.IsAFile(path));
        if (!Directory.Exists(root)) throw new InputException(UnityProjectMessages.NoFolder(path));
        foreach (var needed in new[] { VersionIn(root), ManifestIn(root) })
            if (!File.Exists(needed))
                throw new InputException(UnityProjectMessages.NotAProject(path, Path.GetRelativePath(root, needed), ProjectAbove(root)));

        var version = UnityVersion.InProjectFile(File.ReadAllText(VersionIn(root)));
        return new UnityProject(root, version ?? throw new InputException(UnityProjectMessages.NoVersion(VersionIn(root))));
    }

    /// <summary>Gets whether a package is embedded in the project. The manifest has no effect on an embedded package.</summary>
    public bool Embeds(string package) => File.Exists(Path.Combine(Root, "Packages", package, "package.json"));

    /// <summary>
    /// Finds the files of this name below Assets that Unity imports. It ignores names that begin with a dot or end with a tilde, links, and folders
    /// that the user may not read.
    /// </summary>
    /// <returns>Absolute paths, in ordinal order.</returns>
    public IEnumerable<string> Imported(string name)
    {
        var assets = Path.Combine(Root, "Assets");
        if (!Directory.Exists(assets)) return [];
        return Directory.EnumerateFiles(assets, name, Below)
            .Where(file => !Path.GetRelativePath(assets, file).Split(Path.DirectorySeparatorChar).Any(IsIgnored))
            .Order(StringComparer.Ordinal);
    }

    static bool IsIgnored(string name) => name.StartsWith('.') || name.EndsWith('~');

    static string VersionIn(string root) => Path.Combine(root, "ProjectSettings", "ProjectVersion.txt");

    static string ManifestIn(string root) => Path.Combine(root, "Packages", "manifest.json");

    // The user may have given the folder Assets or Packages of a project.
    static string ProjectAbove(string root)
    {
        var parent = Path.GetDirectoryName(root);
        return parent != null && File.Exists(VersionIn(parent)) ? parent : null;
    }
}
