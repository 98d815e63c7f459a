using Nowpose.UnityPlayer.Assets.Loading;

namespace Nowpose.UnityPlayer.Assets.Values;

/// <summary>Resolves the references of one file: to objects of the file itself and to other assets.</summary>
sealed class FileReferences
{
    readonly LoadedAssets _assets;
    readonly IReadOnlyDictionary<long, Object> _objects;
    readonly Dictionary<Object, long> _ids = new Dictionary<Object, long>();
    readonly Dictionary<Transform, int> _roots = new Dictionary<Transform, int>();

    /// <param name="assets">Assets to which the file may refer.</param>
    /// <param name="objects">Objects of the file by fileID.</param>
    /// <param name="roots">Root objects of the file in order.</param>
    public FileReferences(LoadedAssets assets, IReadOnlyDictionary<long, Object> objects, IReadOnlyList<GameObject> roots)
    {
        _assets = assets;
        _objects = objects;
        foreach (var (id, target) in objects) _ids.Add(target, id);
        for (var i = 0; i < roots.Count; i++) _roots.Add(roots[i].transform, i);
    }

    /// <summary>Returns the object to which a reference refers.</summary>
    /// <param name="reference">The reference, which must not be empty.</param>
    /// <param name="type">Type of the field that contains the reference.</param>
    /// <param name="place">Place for error messages.</param>
    /// <exception cref="AssetException">The object does not exist, or its type does not fit the field.</exception>
    public Object ObjectAt(AssetReference reference, Type type, Place place)
    {
        var found = reference.Guid != null ? _assets.ObjectAt(reference, place) : OwnObject(reference.FileId, place);
        return type.IsInstanceOfType(found)
            ? found
            : throw place.Error(AssetFault.Reference, reference + " is a " + found.GetType().Name + ", but the field takes a " + type.Name);
    }

    /// <summary>Returns the reference to an object.</summary>
    /// <param name="target">The object, which must not be null or destroyed.</param>
    /// <param name="place">Place for error messages.</param>
    /// <exception cref="AssetException">The object is neither in this file nor an asset of the library.</exception>
    public AssetReference ReferenceTo(Object target, Place place) =>
        _ids.TryGetValue(target, out var id) ? new AssetReference(id) : _assets.ReferenceTo(target, place);

    /// <summary>Returns the reference to the script file of a class.</summary>
    /// <param name="type">Type of a component or ScriptableObject in a script.</param>
    /// <param name="place">Place for error messages.</param>
    /// <exception cref="AssetException">No script file exists for this class.</exception>
    public AssetReference ScriptOf(Type type, Place place) => _assets.ScriptOf(type, place);

    /// <summary>Returns the index of a transform among the children of its parent, or among the roots of the file.</summary>
    public int SiblingIndex(Transform transform) => _roots.TryGetValue(transform, out var index) ? index : transform.GetSiblingIndex();

    Object OwnObject(long fileId, Place place) =>
        _objects.TryGetValue(fileId, out var found) ? found
            : throw place.Error(AssetFault.MissingObject, "the file has no object " + Numbers.Write(fileId));
}
