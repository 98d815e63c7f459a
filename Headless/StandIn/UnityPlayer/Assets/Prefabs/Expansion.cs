namespace Nowpose.UnityPlayer.Assets.Prefabs;

/// <summary>Replaces the prefab instances in a file with their objects, and updates all references to these objects.</summary>
sealed class Expansion(string file, Func<string, ObjectFile> prefabAt)
{
    readonly Dictionary<long, FileObject> _byId = new Dictionary<long, FileObject>();
    readonly Dictionary<long, UnityDocument> _strippedDocuments = new Dictionary<long, UnityDocument>();
    readonly List<(InstanceDocument Document, PrefabInstance Instance)> _instances = new List<(InstanceDocument, PrefabInstance)>();
    readonly Dictionary<long, long> _stripped = new Dictionary<long, long>();
    readonly List<FileObject> _objects = new List<FileObject>();

    public IEnumerable<FileObject> Objects => _objects.Where(o => _byId.ContainsKey(o.FileId));

    /// <summary>FileIDs of the objects that the stripped placeholders represent, by the fileIDs of the placeholders.</summary>
    public IReadOnlyDictionary<long, long> Stripped => _stripped;

    public void Add(UnityDocument document)
    {
        if (document.IsStripped) _strippedDocuments.Add(document.FileId, document);
        else if (document.ClassId == PrefabInstance.ClassId) Add(new InstanceDocument(document, file));
        else Add(new FileObject(document, file));
    }

    /// <summary>Applies the changes of the instances and updates the references. Call this after all documents were added.</summary>
    public void Connect()
    {
        foreach (var document in _strippedDocuments.Values) _stripped.Add(document.FileId, MeaningOf(document));
        foreach (var (document, instance) in _instances) document.Apply(instance, _byId, Resolve);
        foreach (var (_, instance) in _instances) AddFrom(instance);
        foreach (var own in _objects.Where(o => o.Link == null)) Redirect(own);
    }

    void Add(FileObject added)
    {
        if (!_byId.TryAdd(added.FileId, added))
            throw added.Place.Error(AssetFault.Duplicate, "this fileID refers to two objects in the expanded file");
        _objects.Add(added);
    }

    void Add(InstanceDocument document)
    {
        var instance = new PrefabInstance(file, document.FileId, document.SourceGuid, document.SourcePrefab(prefabAt));
        _instances.Add((document, instance));
        foreach (var source in instance.Source.Objects) Add(source.In(instance));
    }

    long MeaningOf(UnityDocument document)
    {
        var stripped = new FileObject(document, file);
        var source = stripped.Reference("m_CorrespondingSourceObject");
        var instance = _instances.Find(i => i.Instance.FileId == stripped.Reference("m_PrefabInstance").FileId).Instance
            ?? throw stripped.Place.In("m_PrefabInstance").Error(AssetFault.Reference, "is not a prefab instance of this file");
        if (source.Guid != instance.SourceGuid)
            throw stripped.Place.In("m_CorrespondingSourceObject").Error(AssetFault.Reference, "is not in the prefab of its instance");
        var found = instance.Source.Find(source.FileId)
            ?? throw stripped.Place.In("m_CorrespondingSourceObject").Error(AssetFault.MissingObject, "the prefab has no object "
                + Numbers.Write(source.FileId));
        if (found.ClassId != document.ClassId) throw stripped.Place.Error(AssetFault.Reference, "refers to a " + found.ClassName);
        return instance.Map(found.FileId);
    }

    /// <summary>Replaces references to placeholders with references to the objects that they represent.</summary>
    void Redirect(FileObject own)
    {
        foreach (var entry in own.Fields.Children.ToList())
        {
            foreach (var id in LocalReferences.In(entry.Value))
            {
                if (!_byId.ContainsKey(Resolve(id)))
                    throw own.Place.In(((YamlScalarNode)entry.Key).Value).Error(AssetFault.MissingObject, "the file has no object "
                        + Numbers.Write(id));
            }
            own.Fields.Children[entry.Key] = LocalReferences.Map(entry.Value, Resolve);
        }
    }

    /// <summary>Adds the children and components that only the instance has to the lists that the instance has from the prefab.</summary>
    void AddFrom(PrefabInstance instance)
    {
        foreach (var own in _objects.Where(o => o.Link == null))
        {
            if (TryUp(own, "m_GameObject", instance, out var owner))
                ListOf(owner, "m_Component").Add(Nodes.Lines(("component", new AssetReference(own.FileId).Write())));
        }
        // The added children, which are objects of the file or of other instances, are sorted by their order in the file.
        var addedChildren = _objects.Where(o => o.IsTransform && o.Link?.Instance != instance && TryUp(o, "m_Father", instance, out _));
        foreach (var child in addedChildren.OrderBy(RootOrder).ToList())
        {
            TryUp(child, "m_Father", instance, out var father);
            ListOf(father, "m_Children").Add(new AssetReference(child.FileId).Write());
        }
    }

    bool TryUp(FileObject from, string upwards, PrefabInstance instance, out FileObject up)
    {
        up = null;
        if (!(Nodes.Find(from.Fields, upwards) is { } node) || !AssetReference.TryRead(node, out var reference)) return false;
        if (reference.Guid != null) return false;
        return IsOf(instance, Resolve(reference.FileId)) && _byId.TryGetValue(Resolve(reference.FileId), out up);
    }

    static long RootOrder(FileObject transform) =>
        Nodes.Find(transform.Fields, "m_RootOrder") is YamlScalarNode node && Numbers.TryRead(node.Value, out long order) ? order : 0;

    static YamlSequenceNode ListOf(FileObject owner, string list)
    {
        var sequence = owner.Place.In(list).Sequence(Nodes.Find(owner.Fields, list));
        sequence.Style = YamlDotNet.Core.Events.SequenceStyle.Block;
        return sequence;
    }

    bool IsOf(PrefabInstance instance, long id) => _byId.TryGetValue(id, out var found) && found.Link?.Instance == instance;

    long Resolve(long id) => _stripped.TryGetValue(id, out var meant) ? meant : id;
}
