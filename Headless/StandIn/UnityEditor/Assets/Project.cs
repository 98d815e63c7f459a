using System.Text.RegularExpressions;
using Nowpose.UnityPlayer;

namespace UnityEditor;

/// <summary>
/// The project whose assets the editor uses. By default, this is the project that contains the running code. Tests may open another project.
/// </summary>
static class Project
{
    // File extensions of assets in Unity's text format that the library can read.
    static readonly string[] NativeAssets = { ".prefab", ".asset", ".mat", ".shader" };

    static readonly Dictionary<string, Object[]> Loaded = new Dictionary<string, Object[]>();
    static readonly Dictionary<string, string> Paths = new Dictionary<string, string>();
    static string _root;
    static AssetLibrary _library;

    /// <summary>Absolute path of the folder that contains Assets and Packages.</summary>
    internal static string Root => _root ?? Open(Above(AppContext.BaseDirectory));

    /// <summary>Discards the loaded assets and opens another project.</summary>
    /// <param name="root">Folder of the project; null for the project that contains the running code.</param>
    internal static string Open(string root)
    {
        Loaded.Clear();
        Paths.Clear();
        _library = null;
        return _root = root ?? Above(AppContext.BaseDirectory);
    }

    /// <summary>Adds an asset with the given objects, in place of an importer that has no stand-in. The first object is the main object.</summary>
    internal static void Put(string path, params Object[] objects) => Loaded[path] = objects;

    /// <summary>Adds an asset with the given objects and the given GUID.</summary>
    internal static void PutAs(string guid, string path, params Object[] objects)
    {
        PathOf(guid);
        Paths[guid] = path;
        Put(path, objects);
    }

    /// <summary>Returns the objects of an asset, the main object first; empty if no such asset exists.</summary>
    internal static IReadOnlyList<Object> Load(string path)
    {
        if (string.IsNullOrEmpty(path)) return Array.Empty<Object>();
        if (Loaded.TryGetValue(path, out var objects) && objects.All(o => o)) return objects;

        return Loaded[path] = File.Exists(FullPath(path)) ? Read(path) : Array.Empty<Object>();
    }

    /// <summary>Returns the path of the asset that contains an object; null if no loaded asset contains it.</summary>
    internal static string PathOf(Object part) => Loaded.FirstOrDefault(asset => asset.Value.Contains(part)).Key;

    /// <summary>Returns the GUIDs of the assets of a type. Finds only assets that were added or loaded.</summary>
    internal static IEnumerable<string> OfType(string type) =>
        Loaded.Where(asset => asset.Value.Length > 0 && asset.Value[0].GetType().Name == type).Select(asset => GuidOf(asset.Key));

    internal static string PathOf(string guid)
    {
        if (Paths.Count == 0) FindGuids();
        return Paths.TryGetValue(guid, out var path) ? path : Loaded.Keys.FirstOrDefault(p => GuidOf(p) == guid);
    }

    /// <summary>Returns the GUID of an asset from its .meta file. The GUID of an asset added by a test is derived from its path.</summary>
    internal static string GuidOf(string path)
    {
        var meta = FullPath(path) + ".meta";
        if (File.Exists(meta)) return Regex.Match(File.ReadAllText(meta), "^guid: ([0-9a-f]{32})", RegexOptions.Multiline).Groups[1].Value;
        return Loaded.ContainsKey(path) ? "put:" + path : null;
    }

    internal static string FullPath(string path) => Path.Combine(Root, path);

    /// <summary>Runs an action with the project as the current directory, as in Unity. Editor code uses paths relative to it.</summary>
    internal static T InRoot<T>(Func<T> action)
    {
        var before = Directory.GetCurrentDirectory();
        Directory.SetCurrentDirectory(Root);
        try
        {
            return action();
        }
        finally
        {
            Directory.SetCurrentDirectory(before);
        }
    }

    static Object[] Read(string path)
    {
        var importer = Importers.For(path);
        if (importer != null) return Importers.Import(importer, path).Objects;

        return NativeAssets.Contains(Path.GetExtension(path))
            ? new[] { (_library ??= new AssetLibrary(Root)).Load<Object>(path) }
            : Array.Empty<Object>();
    }

    static void FindGuids()
    {
        var folders = new[] { FullPath("Assets"), FullPath("Packages") };
        foreach (var meta in folders.Where(Directory.Exists).SelectMany(f => Directory.EnumerateFiles(f, "*.meta", SearchOption.AllDirectories)))
        {
            var path = meta.Substring(Root.Length + 1, meta.Length - Root.Length - 1 - ".meta".Length).Replace('\\', '/');
            Paths[GuidOf(path)] = path;
        }
    }

    static string Above(string folder)
    {
        for (var at = new DirectoryInfo(folder); at != null; at = at.Parent)
            if (File.Exists(Path.Combine(at.FullName, "Packages", "manifest.json"))) return at.FullName;
        throw new DirectoryNotFoundException($"{folder} is not in a Unity project");
    }
}
