namespace Nowpose.Metas;

/// <summary>
/// Lists the assets that the editor would import: everything in Assets/, in each embedded package and in each sample. The editor ignores a sample
/// until the user imports it, but the .meta files of a sample must already exist.
/// </summary>
public sealed class AssetTree
{
    readonly string _root;
    readonly List<AssetEntry> _assets = new();
    readonly List<string> _metas = new();
    readonly List<string> _buildFiles = new();

    /// <param name="root">Folder that contains Assets/ and Packages/. Either of them can be missing.</param>
    public AssetTree(string root)
    {
        _root = root;
        Walk("Assets");
        foreach (var package in FoldersIn("Packages"))
        {
            Walk(package);
            foreach (var sample in FoldersIn(package + "/Samples~")) Walk(sample);
        }
    }

    /// <summary>The assets, sorted by path (ordinal). Folders come before their contents.</summary>
    public IReadOnlyList<AssetEntry> Assets => _assets;

    /// <summary>Paths of all .meta files, relative to the root.</summary>
    public IReadOnlyList<string> Metas => _metas;

    /// <summary>Build files and folders of .NET at places where Unity would import them.</summary>
    public IReadOnlyList<string> BuildFiles => _buildFiles;

    public string FullPath(string path) => Path.Combine(_root, path);

    IEnumerable<string> FoldersIn(string folder) => NamesIn(folder, Directory.GetDirectories).Where(IsImported);

    void Walk(string folder)
    {
        foreach (var file in NamesIn(folder, Directory.GetFiles).Where(IsImported)) AddFile(file);
        foreach (var child in FoldersIn(folder)) AddFolder(child);
    }

    void AddFile(string path)
    {
        if (AssetNames.IsMeta(path)) _metas.Add(path);
        else if (AssetNames.IsBuildFile(path)) _buildFiles.Add(path);
        else _assets.Add(new AssetEntry(path, IsFolder: false));
    }

    void AddFolder(string path)
    {
        if (AssetNames.IsBuildFolder(Path.GetFileName(path)))
        {
            _buildFiles.Add(path);
            return;
        }
        // Skips empty folders. Git does not store them, so in the next clone their .meta files would have no asset.
        if (ContainsFile(path)) _assets.Add(new AssetEntry(path, IsFolder: true));
        Walk(path);
    }

    bool ContainsFile(string path)
    {
        return Directory.EnumerateFiles(FullPath(path), "*", SearchOption.AllDirectories).Any(f => !AssetNames.IsMeta(f));
    }

    List<string> NamesIn(string folder, Func<string, string[]> list)
    {
        var full = FullPath(folder);
        if (!Directory.Exists(full)) return new List<string>();
        var paths = list(full).Select(p => folder + "/" + Path.GetFileName(p)).ToList();
        paths.Sort(StringComparer.Ordinal);
        return paths;
    }

    static bool IsImported(string path) => !AssetNames.IsHidden(Path.GetFileName(path));
}
