using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.CompilerServices;
using Nowpose.UnityPlayer.Assets;
using Nowpose.UnityPlayer.Assets.Files;
using Nowpose.UnityPlayer.Assets.Loading;
using Nowpose.UnityPlayer.Assets.Objects;
using UnityEngine;

namespace Nowpose.UnityPlayer;

/// <summary>The assets of a Unity project, found by their .meta files and loaded from Unity's text format.</summary>
/// <remarks>
/// Stricter than the editor: a reference to a missing object, an unknown field, a missing script and similar faults are errors. Scripts and
/// assembly definitions need only their .meta files. Assets are loaded once for each player. Not thread-safe.
/// </remarks>
public sealed class AssetLibrary
{
    readonly AssetFiles _files;
    readonly ConditionalWeakTable<World, LoadedAssets> _loaded = new ConditionalWeakTable<World, LoadedAssets>();

    /// <param name="projectRoot">The folder that contains Assets/ and Packages/. Samples inside packages are found, too.</param>
    /// <exception cref="AssetException">A .meta file has no GUID, or two have the same.</exception>
    public AssetLibrary(string projectRoot)
        : this(AssetIndex.FoldersOf(projectRoot))
    {
    }

    /// <param name="folders">Folders; each name is the first part of its paths.</param>
    /// <exception cref="AssetException">A .meta file has no GUID, or two have the same.</exception>
    public AssetLibrary(IEnumerable<string> folders)
        : this(folders.Select(f => (Path.GetFileName(f.TrimEnd('/', '\\')), f)))
    {
    }

    AssetLibrary(IEnumerable<(string Name, string FullPath)> folders) => _files = new AssetFiles(new AssetIndex(folders));

    internal LoadedAssets Loaded => _loaded.GetValue(World.Current, _ => new LoadedAssets(_files));

    /// <summary>Loads the main object of an asset for the current player; for a prefab, its root.</summary>
    /// <param name="path">Path in Unity's form, or a full path.</param>
    /// <exception cref="AssetException">The asset does not exist, is invalid, or has another type.</exception>
    public T Load<T>(string path)
        where T : Object
    {
        var main = Loaded.Main(FileAt(path));
        return main as T ?? throw new AssetException(path + ": is a " + main.GetType().Name + ", not a " + typeof(T).Name);
    }

    /// <summary>
    /// Creates a copy of a prefab that stays linked to it, as the editor does when a prefab is dragged into a scene. It is saved as an instance
    /// with its changes. It is not in a scene yet.
    /// </summary>
    /// <param name="prefab">The prefab from <see cref="Load{T}"/>.</param>
    /// <exception cref="AssetException">The object is not a prefab of this library.</exception>
    public GameObject InstantiatePrefab(GameObject prefab) => Loaded.InstantiatePrefab(prefab);

    internal LoadedScene LoadScene(string path)
    {
        var file = FileAt(path);
        var settings = SceneSettings.Of(_files.Documents(file), file.Path);
        return new LoadedScene(file.Name, file.Path, Loaded.Instantiate(file).Roots, settings);
    }

    AssetFile FileAt(string path) => _files.Index.ByPath(path) ?? throw new AssetException(path + ": there is no such asset");
}
