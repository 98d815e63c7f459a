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

/// <summary>The assets of a Unity project, found by their .meta files and loaded from the text that Unity keeps them in.</summary>
/// <remarks>
/// Strict, as the editor is not: a reference to nothing, a field that the script does not have, a missing script and the like are errors.
/// Of scripts and assembly definitions only the .meta has to be there. Assets are loaded once for each player; not for use from several threads.
/// </remarks>
public sealed class AssetLibrary
{
    readonly AssetFiles _files;
    readonly ConditionalWeakTable<World, LoadedAssets> _loaded = new ConditionalWeakTable<World, LoadedAssets>();

    /// <param name="projectRoot">The folder that holds Assets/ and Packages/; samples inside packages are found too.</param>
    /// <exception cref="AssetException">A .meta without a GUID, or two with the same.</exception>
    public AssetLibrary(string projectRoot)
        : this(AssetIndex.FoldersOf(projectRoot))
    {
    }

    /// <param name="folders">Each is called by its own name in paths.</param>
    /// <exception cref="AssetException">A .meta without a GUID, or two with the same.</exception>
    public AssetLibrary(IEnumerable<string> folders)
        : this(folders.Select(f => (Path.GetFileName(f.TrimEnd('/', '\\')), f)))
    {
    }

    AssetLibrary(IEnumerable<(string Name, string FullPath)> folders) => _files = new AssetFiles(new AssetIndex(folders));

    /// <summary>Paths of all assets and folders, as Unity calls them: <c>Assets/Scenes/Demo.unity</c>, <c>Packages/…</c>.</summary>
    public IEnumerable<string> Paths => _files.Index.Files.Select(f => f.Path);

    internal LoadedAssets Loaded => _loaded.GetValue(World.Current, _ => new LoadedAssets(_files));

    /// <summary>The main object of an asset, of a prefab its root, for the current player.</summary>
    /// <param name="path">As Unity calls it, or in full.</param>
    /// <exception cref="AssetException">There is no such asset, it is broken, or it is not of that type.</exception>
    public T Load<T>(string path)
        where T : Object
    {
        var main = Loaded.Main(FileAt(path));
        return main as T ?? throw new AssetException(path + ": is a " + main.GetType().Name + ", not a " + typeof(T).Name);
    }

    /// <summary>
    /// A copy of a prefab that stays linked to it, as the editor makes it when a prefab is dragged into a scene: saved, it is an instance with
    /// what was changed in it. It is in no scene yet.
    /// </summary>
    /// <param name="prefab">As <see cref="Load{T}"/> gave it.</param>
    /// <exception cref="AssetException">It is no prefab of this library.</exception>
    public GameObject InstantiatePrefab(GameObject prefab) => Loaded.InstantiatePrefab(prefab);

    internal LoadedScene LoadScene(string path)
    {
        var file = FileAt(path);
        var settings = SceneSettings.Of(_files.Documents(file), file.Path);
        return new LoadedScene(file.Name, file.Path, Loaded.Instantiate(file).Roots, settings);
    }

    AssetFile FileAt(string path) => _files.Index.ByPath(path) ?? throw new AssetException(path + ": there is no such asset");
}
