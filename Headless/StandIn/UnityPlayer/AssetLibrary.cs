using System.Runtime.CompilerServices;
using Nowpose.UnityPlayer.Assets;
using Nowpose.UnityPlayer.Assets.Files;
using Nowpose.UnityPlayer.Assets.Loading;
using Nowpose.UnityPlayer.Assets.Objects;

namespace Nowpose.UnityPlayer;

/// <summary>Loads the assets of a Unity project from Unity's text format. Finds assets by their .meta files.</summary>
/// <remarks>
/// The library is stricter than the editor. For example, it reports a reference to a missing object, an unknown field, or a missing script as an
/// error. Scripts and assembly definitions need only their .meta files. A player loads each asset once. The class is not thread-safe.
/// </remarks>
public sealed class AssetLibrary
{
    readonly AssetFiles _files;
    readonly ConditionalWeakTable<World, LoadedAssets> _loaded = new ConditionalWeakTable<World, LoadedAssets>();

    /// <summary>Constructs a library for a project.</summary>
    /// <param name="projectRoot">Folder that contains Assets/ and Packages/. The samples in packages are included.</param>
    /// <exception cref="AssetException">A .meta file has no GUID, or two files have the same GUID.</exception>
    public AssetLibrary(string projectRoot)
        : this(new AssetFiles(new AssetIndex(AssetIndex.FoldersOf(projectRoot)))) { }

    AssetLibrary(AssetFiles files) => _files = files;

    internal LoadedAssets Loaded => _loaded.GetValue(World.Current, _ => new LoadedAssets(_files));

    /// <summary>Loads the main object of an asset for the current player. The main object of a prefab is its root.</summary>
    /// <param name="path">Path within the project, as in Unity, or an absolute path.</param>
    /// <exception cref="AssetException">The asset does not exist, is invalid, or has another type.</exception>
    public T Load<T>(string path)
        where T : Object
    {
        var main = Loaded.Main(FileAt(path));
        return main as T ?? throw new AssetException(AssetFault.Kind, path + ": is a " + main.GetType().Name + ", not a " + typeof(T).Name);
    }

    /// <summary>
    /// Creates an instance of a prefab, as the editor does when the user drags a prefab into a scene. <see cref="AssetWriter"/> writes it as a prefab
    /// instance with its changes. The instance is not in a scene yet.
    /// </summary>
    /// <param name="prefab">A prefab returned by <see cref="Load{T}"/>.</param>
    /// <exception cref="AssetException">The object is not a prefab of this library.</exception>
    public GameObject InstantiatePrefab(GameObject prefab) => Loaded.InstantiatePrefab(prefab);

    /// <summary>Returns a library for the same files, without any loaded object. Files that have been read are not read again.</summary>
    public AssetLibrary Unloaded() => new AssetLibrary(_files);

    internal LoadedScene LoadScene(string path)
    {
        var file = FileAt(path);
        var settings = SceneSettings.Of(_files.Documents(file), file.Path);
        return new LoadedScene(Loaded.Instantiate(file).Roots, settings);
    }

    AssetFile FileAt(string path) => _files.Index.ByPath(path)
        ?? throw new AssetException(AssetFault.MissingAsset, path + ": there is no such asset");
}
