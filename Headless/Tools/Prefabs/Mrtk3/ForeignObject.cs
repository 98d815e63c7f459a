using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Prefabs.Mrtk3;

/// <summary>An object of another package's prefab, with its fileID and those of its components.</summary>
sealed class ForeignObject
{
    readonly Dictionary<Object, long> _fileIds;

    ForeignObject(GameObject made, Dictionary<Object, long> fileIds)
    {
        GameObject = made;
        _fileIds = fileIds;
    }

    public GameObject GameObject { get; }

    public IReadOnlyDictionary<Object, long> FileIds => _fileIds;

    public static ForeignObject Root<TTransform>(string name, long fileId, long transformId)
        where TTransform : Transform
    {
        return Make<TTransform>(new Dictionary<Object, long>(), name, fileId, transformId, null);
    }

    public ForeignObject Child<TTransform>(string name, long fileId, long transformId)
        where TTransform : Transform
    {
        return Make<TTransform>(_fileIds, name, fileId, transformId, GameObject.transform);
    }

    public T Add<T>(long fileId)
        where T : Component
    {
        var added = GameObject.AddComponent<T>();
        _fileIds.Add(added, fileId);
        return added;
    }

    static ForeignObject Make<TTransform>(Dictionary<Object, long> fileIds, string name, long fileId, long transformId, Transform parent)
        where TTransform : Transform
    {
        var made = new GameObject(name);
        made.AddComponent<TTransform>();
        if (parent != null) made.transform.SetParent(parent, worldPositionStays: false);
        fileIds.Add(made, fileId);
        fileIds.Add(made.transform, transformId);
        return new ForeignObject(made, fileIds);
    }
}
