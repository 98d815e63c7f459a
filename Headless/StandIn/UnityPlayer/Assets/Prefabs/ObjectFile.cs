using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.UnityPlayer.Assets.Yaml;

namespace Nowpose.UnityPlayer.Assets.Prefabs;

/// <summary>A prefab or scene as one flat set of objects, with its prefab instances inserted and modified.</summary>
/// <remarks>Its objects are immutable; copy them to change fields.</remarks>
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

    /// <summary>Name of the file in errors.</summary>
    public string Name { get; }

    /// <summary>The objects in the order of the file; those of an instance are at the instance's position.</summary>
    public IReadOnlyList<FileObject> Objects { get; }

    /// <param name="documents">Documents of the file.</param>
    /// <param name="name">Name of the file in errors.</param>
    /// <param name="prefabAt">Gets the prefab of a GUID; throws for an unknown one.</param>
    public static ObjectFile Read(IReadOnlyList<UnityDocument> documents, string name, Func<string, ObjectFile> prefabAt)
    {
        var expansion = new Expansion(name, prefabAt);
        foreach (var document in documents) expansion.Add(document);
        expansion.Connect();
        return new ObjectFile(name, expansion.Objects, expansion.Stripped);
    }

    /// <param name="fileId">FileID of an object of this file or of one of its stripped placeholders.</param>
    public FileObject Find(long fileId)
    {
        if (_stripped.TryGetValue(fileId, out var meant)) fileId = meant;
        return _objects.TryGetValue(fileId, out var found) ? found : null;
    }
}
