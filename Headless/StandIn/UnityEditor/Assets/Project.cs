using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Nowpose.UnityPlayer;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>The project whose assets the editor uses: the one that contains the running code, unless a test opens another.</summary>
static class Project
{
    // Assets that Unity stores as text and that the library can read.
    static readonly string[] NativeAssets = { ".prefab", ".asset", ".mat", ".shader" };

    static readonly Dictionary<string, Object[]> Loaded = new Dictionary<string, Object[]>();
    static readonly Dictionary<string, string> Paths = new Dictionary<string, string>();
    static string _root;
    static AssetLibrary _library;

    /// <summary>Absolute path of the folder that holds Assets and Packages.</summary>
    internal static string Root => _root ?? Open(Above(AppContext.BaseDirectory));

    /// <summary>Discards the loaded assets and opens another project.</summary>
    /// <param name="root">The project's folder; null for the one that contains the running code.</param>
    internal static string Open(string root)
    {
        Loaded.Clear();
        Paths.Clear();
        _library = null;
        return _root = root ?? Above(AppContext.BaseDirectory);
    }

    /// <summary>Adds objects like an importer that has no stand-in; the first is the main object.</summary>
    internal static void Put(string path, params Object[] objects) => Loaded[path] = objects;

    /// <summary>Adds objects for an asset that is found by its GUID.</summary>
    internal static void PutAs(string guid, string path, params Object[] objects)
    {
        PathOf(guid);
        Paths[guid] = path;
        Put(path, objects);
    }

    /// <summary>Gets the objects of an asset, the main one first; empty if there is no such asset.</summary>
    internal static IReadOnlyList<Object> Load(string path)
    {
        if (string.IsNullOrEmpty(path)) return Array.Empty<Object>();
        if (Loaded.TryGetValue(path, out var objects) && objects.All(o => o)) return objects;

        return Loaded[path] = File.Exists(FullPath(path)) ? Read(path) : Array.Empty<Object>();
    }

    /// <summary>Gets the GUIDs of the assets of a type, among those that were added or loaded.</summary>
    internal static IEnumerable<string> OfType(string type) =>
        Loaded.Where(asset => asset.Value.Length > 0 && asset.Value[0].GetType().Name == type).Select(asset => GuidOf(asset.Key));

    internal static string PathOf(string guid)
    {
        if (Paths.Count == 0) FindGuids();
        return Paths.TryGetValue(guid, out var path) ? path : Loaded.Keys.FirstOrDefault(p => GuidOf(p) == guid);
    }

    /// <summary>Gets the GUID of the .meta file. An asset added by a test gets one from its path.</summary>
    internal static string GuidOf(string path)
    {
        var meta = FullPath(path) + ".meta";
        if (File.Exists(meta)) return Regex.Match(File.ReadAllText(meta), "^guid: ([0-9a-f]{32})", RegexOptions.Multiline).Groups[1].Value;
        return Loaded.ContainsKey(path) ? "put:" + path : null;
    }

    internal static string FullPath(string path) => Path.Combine(Root, path);

    /// <summary>Runs an action in the project's folder, because editor code uses relative paths and Unity's working folder is the project.</summary>
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
        throw new DirectoryNotFoundException($"{folder} lies in no Unity project");
    }
}
