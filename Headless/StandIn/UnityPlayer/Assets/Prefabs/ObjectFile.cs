namespace Nowpose.UnityPlayer.Assets.Prefabs;

/// <summary>A prefab or scene as one flat list of objects. The objects of its prefab instances are included, with their changes applied.</summary>
/// <remarks>Do not change the fields of its objects. Copy an object to change its fields.</remarks>
sealed class ObjectFile
{
    readonly Dictionary<long, FileObject> _objects;
    readonly IReadOnlyDictionary<long, long> _stripped;

    ObjectFile(string name, IEnumerable<FileObject> objects, IReadOnlyDictionary<long, long> stripped)
    {
        Name = name;
        Objects = objects.ToList();
        _objects = Objects.ToDictionary(o => o.FileId);
        _stripped = stripped;
    }

    /// <summary>Name of the file in error messages.</summary>
    public string Name { get; }

    /// <summary>The objects in the order of the file. In this order, the objects of a prefab instance take the place of the instance.</summary>
    public IReadOnlyList<FileObject> Objects { get; }

    /// <summary>Reads the documents of a prefab or scene.</summary>
    /// <param name="documents">Documents of the file.</param>
    /// <param name="name">Name of the file in error messages.</param>
    /// <param name="prefabAt">Returns the prefab with this GUID. Throws if the GUID is unknown.</param>
    public static ObjectFile Read(IReadOnlyList<UnityDocument> documents, string name, Func<string, ObjectFile> prefabAt)
    {
        var expansion = new Expansion(name, prefabAt);
        foreach (var document in documents) expansion.Add(document);
        expansion.Connect();
        return new ObjectFile(name, expansion.Objects, expansion.Stripped);
    }

    /// <summary>Returns an object; null if there is none with this fileID.</summary>
    /// <param name="fileId">FileID of an object, or of a stripped placeholder for an object.</param>
    public FileObject Find(long fileId)
    {
        if (_stripped.TryGetValue(fileId, out var meant)) fileId = meant;
        return _objects.TryGetValue(fileId, out var found) ? found : null;
    }
}
