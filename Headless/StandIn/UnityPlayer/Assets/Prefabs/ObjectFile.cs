using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.UnityPlayer.Assets.Yaml;

namespace Nowpose.UnityPlayer.Assets.Prefabs;

/// <summary>A prefab or scene as one flat set of objects: its prefab instances are put in, with what is changed in them.</summary>
/// <remarks>Its objects are never changed after; who needs other fields copies them.</remarks>
sealed class ObjectFile
{
    readonly Dictionary<long, FileObject> _objects;
    readonly IReadOnlyDictionary<long, long> _stripped;

    ObjectFile(string name, IEnumerable<FileObject> objects, IReadOnlyDictionary<long, long> stripped, IReadOnlyList<PrefabInstance> instances)
    {
        Name = name;
        Objects = objects.ToList();
        Instances = instances;
        _objects = Objects.ToDictionary(o => o.FileId);
        _stripped = stripped;
    }

    /// <summary>What errors call it.</summary>
    public string Name { get; }

    /// <summary>In the order of the file, those of an instance where the instance stands.</summary>
    public IReadOnlyList<FileObject> Objects { get; }

    public IReadOnlyList<PrefabInstance> Instances { get; }

    /// <param name="documents">Of the file.</param>
    /// <param name="name">What errors call it.</param>
    /// <param name="prefabAt">The prefab of a GUID; throws for any other.</param>
    public static ObjectFile Read(IReadOnlyList<UnityDocument> documents, string name, Func<string, ObjectFile> prefabAt)
    {
        var expansion = new Expansion(name, prefabAt);
        foreach (var document in documents) expansion.Add(document);
        expansion.Connect();
        return new ObjectFile(name, expansion.Objects, expansion.Stripped, expansion.Instances);
    }

    /// <param name="fileId">Of an object of this file or of one of its stripped placeholders.</param>
    public FileObject Find(long fileId)
    {
        if (_stripped.TryGetValue(fileId, out var meant)) fileId = meant;
        return _objects.TryGetValue(fileId, out var found) ? found : null;
    }
}
