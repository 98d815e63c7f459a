using System.Text.RegularExpressions;

namespace Nowpose.UnityPlayer.Assets.Files;

/// <summary>Finds assets by GUID and by path. Lists the assets by their .meta files.</summary>
sealed class AssetIndex
{
    const string Meta = ".meta";

    static readonly Regex Guids = new Regex("^guid: ([0-9a-f]{32})\\s*$", RegexOptions.Multiline | RegexOptions.CultureInvariant);
    static readonly Regex Importers = new Regex("^(\\w+Importer):\\s*$", RegexOptions.Multiline | RegexOptions.CultureInvariant);

    readonly Dictionary<string, AssetFile> _byGuid = new Dictionary<string, AssetFile>(StringComparer.Ordinal);
    readonly Dictionary<string, AssetFile> _byPath = new Dictionary<string, AssetFile>(StringComparer.Ordinal);

    /// <param name="folders">
    /// Folders, each with the name that replaces its full path in asset paths. Subfolders that Unity ignores are excluded, except samples.
    /// </param>
    /// <exception cref="AssetException">A .meta file has no GUID, or two files have the same GUID.</exception>
    public AssetIndex(IEnumerable<(string Name, string FullPath)> folders)
    {
        foreach (var (name, fullPath) in folders) AddFolder(name, fullPath);
    }

    public IReadOnlyCollection<AssetFile> Files => _byPath.Values;

    /// <summary>Returns the folders of a Unity project that contain assets or stand-ins for the assets of missing packages.</summary>
    public static IEnumerable<(string Name, string FullPath)> FoldersOf(string projectRoot)
    {
        foreach (var name in new[] { "Assets", "Packages", "Headless/StandIn/ForeignAssets" })
        {
            var folder = Path.Combine(projectRoot, name);
            if (Directory.Exists(folder)) yield return (name, folder);
        }
    }

    /// <summary>Returns the asset with this GUID; null if there is none.</summary>
    public AssetFile ByGuid(string guid) => _byGuid.TryGetValue(guid, out var file) ? file : null;

    /// <summary>Returns the asset at this path; null if there is none.</summary>
    /// <param name="path">Path within the project, as in Unity, or an absolute path.</param>
    public AssetFile ByPath(string path)
    {
        if (_byPath.TryGetValue(path.Replace('\\', '/'), out var file)) return file;
        var full = Path.GetFullPath(path);
        return _byPath.Values.FirstOrDefault(f => Path.GetFullPath(f.FullPath) == full);
    }

    void AddFolder(string name, string fullPath)
    {
        foreach (var file in Directory.GetFiles(fullPath, "*" + Meta).OrderBy(f => f, StringComparer.Ordinal)) AddMeta(name, file);
        foreach (var folder in Directory.GetDirectories(fullPath).OrderBy(f => f, StringComparer.Ordinal))
        {
            var child = Path.GetFileName(folder);
            if (child == "Samples~" || !(child.StartsWith('.') || child.EndsWith('~')))
                AddFolder(name + "/" + child, folder);
        }
    }

    void AddMeta(string folder, string metaFile)
    {
        var fullPath = metaFile.Substring(0, metaFile.Length - Meta.Length);
        var path = folder + "/" + Path.GetFileName(fullPath);
        var text = File.ReadAllText(metaFile);
        var guid = Guids.Match(text);
        if (!guid.Success) throw new AssetException(AssetFault.Document, path + Meta + ": has no guid of 32 lower-case hex digits");

        var file = new AssetFile(guid.Groups[1].Value, path, fullPath, Importers.Match(text).Groups[1].Value);
        if (!_byGuid.TryAdd(file.Guid, file))
            throw new AssetException(AssetFault.Duplicate, path + Meta + ": guid " + file.Guid + " is also that of " + _byGuid[file.Guid].Path);
        _byPath.Add(path, file);
    }
}
