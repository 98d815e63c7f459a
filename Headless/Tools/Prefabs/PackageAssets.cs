using Nowpose.UnityPlayer;
using Object = UnityEngine.Object;

namespace Nowpose.Prefabs;

/// <summary>Loads existing assets and writes new ones.</summary>
sealed class PackageAssets
{
    readonly string _root;
    readonly AssetLibrary _library;
    readonly AssetWriter _writer;

    public PackageAssets(string root)
    {
        _root = root;
        _library = new AssetLibrary(root);
        _writer = new AssetWriter(_library);
    }

    public T Load<T>(string path)
        where T : Object
    {
        return _library.Load<T>(path);
    }

    public string ReadText(string path) => File.ReadAllText(Path.Combine(_root, path));

    /// <summary>Creates an instance that stays linked to its prefab.</summary>
    /// <param name="parent">Parent of the instance; null for a root object.</param>
    public GameObject Instantiate(string prefabPath, Transform parent)
    {
        var made = _library.InstantiatePrefab(Load<GameObject>(prefabPath));
        if (parent != null) made.transform.SetParent(parent, worldPositionStays: false);
        return made;
    }

    public string Prefab(GameObject root)
    {
        TransformRounding.Apply(root.transform);
        return _writer.Prefab(root);
    }

    public string Scene(params GameObject[] roots) => _writer.Scene(roots);

    public string Asset(ScriptableObject asset) => _writer.Asset(asset);
}
