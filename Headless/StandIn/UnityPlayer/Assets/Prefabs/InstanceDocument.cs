namespace Nowpose.UnityPlayer.Assets.Prefabs;

/// <summary>Document of a prefab instance in a file, with its prefab, its parent and its changes.</summary>
sealed class InstanceDocument
{
    static readonly string[] Known = { "serializedVersion", "m_TransformParent", "m_Modifications", "m_RemovedComponents" };

    /// <summary>Lists that Unity 2022.2 and newer write. They are supported only if they are empty.</summary>
    static readonly string[] LaterLists = { "m_RemovedGameObjects", "m_AddedGameObjects", "m_AddedComponents" };

    readonly Place _place;
    readonly YamlMappingNode _modification;
    readonly AssetReference _source;

    public InstanceDocument(UnityDocument document, string file)
    {
        var read = new FileObject(document, file);
        FileId = document.FileId;
        _place = read.Place;
        RequireOnly(read.Fields, _place, "m_ObjectHideFlags", "serializedVersion", "m_Modification", "m_SourcePrefab");
        _source = read.Reference("m_SourcePrefab");
        if (_source.Guid == null || _source.FileId != PrefabInstance.PrefabFileId || _source.Type != AssetReference.Imported)
            throw _place.In("m_SourcePrefab").Error(AssetFault.Kind, "has to be {fileID: 100100000, guid: …, type: 3}");

        _modification = _place.Mapping(Nodes.Find(document.Fields, "m_Modification"));
        RequireOnly(_modification, _place.In("m_Modification"), Known.Concat(LaterLists).ToArray());
        foreach (var list in LaterLists.Where(l => Nodes.Find(_modification, l) != null && Items(l).Count > 0))
            throw _place.In(list).Error(AssetFault.Unsupported, "is not supported; undo it in the editor or write it as Unity 2021 does");
        if (!AssetReference.TryRead(Nodes.Find(_modification, "m_TransformParent"), out var parent) || parent.Guid != null)
            throw _place.In("m_TransformParent").Error(AssetFault.Kind, "has to be a reference within the file");
        Parent = parent.FileId;
    }

    public long FileId { get; }

    public string SourceGuid => _source.Guid;

    /// <summary>FileID of the parent Transform; 0 if there is none.</summary>
    public long Parent { get; }

    /// <summary>Root Transform of the prefab; null before the first call of <see cref="SourcePrefab"/>.</summary>
    public FileObject RootTransform { get; private set; }

    public ObjectFile SourcePrefab(Func<string, ObjectFile> prefabAt)
    {
        ObjectFile source;
        try
        {
            source = prefabAt(SourceGuid);
        }
        catch (AssetException exception)
        {
            throw new AssetException(exception.Fault, _place.In("m_SourcePrefab") + ": " + exception.Message, exception);
        }
        RootTransform = source.Objects.Single(o => o.IsTransform && o.Reference("m_Father").IsNone);
        return source;
    }

    /// <summary>Applies the changes to the objects of the instance.</summary>
    /// <param name="instance">The instance whose objects are changed.</param>
    /// <param name="objects">All objects of the file. Removed components are deleted from it.</param>
    /// <param name="resolve">Returns the fileID of the object that a placeholder represents, given the fileID of the placeholder.</param>
    public void Apply(PrefabInstance instance, Dictionary<long, FileObject> objects, Func<long, long> resolve)
    {
        SetParent(instance, objects, resolve(Parent));
        foreach (var item in Items("m_Modifications")) Modify(_place.Mapping(item), instance, objects, resolve);
        foreach (var item in Items("m_RemovedComponents")) Remove(item, instance, objects);
    }

    void SetParent(PrefabInstance instance, Dictionary<long, FileObject> objects, long parent)
    {
        if (parent != 0 && !(objects.TryGetValue(parent, out var found) && found.IsTransform))
            throw _place.In("m_TransformParent").Error(AssetFault.MissingObject, "the file has no Transform " + Numbers.Write(parent));
        objects[instance.Map(RootTransform.FileId)].Fields.Children[Nodes.Text("m_Father")] = new AssetReference(parent).Write();
    }

    void Modify(YamlMappingNode item, PrefabInstance instance, Dictionary<long, FileObject> objects, Func<long, long> resolve)
    {
        var place = _place.In("m_Modifications");
        RequireOnly(item, place, "target", "propertyPath", "value", "objectReference");
        var path = place.Scalar(Nodes.Find(item, "propertyPath"));
        var value = place.Scalar(Nodes.Find(item, "value"));
        if (!AssetReference.TryRead(Nodes.Find(item, "objectReference"), out var reference))
            throw place.In(path).Error(AssetFault.UnknownField, "has no objectReference");
        if (reference.Guid == null) reference = Local(reference.FileId, objects, resolve, place.In(path));
        var target = Target(Nodes.Find(item, "target"), instance, objects, place.In(path));
        PropertyPath.Set(target.Fields, path, value, reference, target.Place);
    }

    static AssetReference Local(long fileId, Dictionary<long, FileObject> objects, Func<long, long> resolve, Place place)
    {
        var meant = resolve(fileId);
        return meant == 0 || objects.ContainsKey(meant)
            ? new AssetReference(meant)
            : throw place.Error(AssetFault.MissingObject, "the file has no object " + Numbers.Write(fileId));
    }

    void Remove(YamlNode item, PrefabInstance instance, Dictionary<long, FileObject> objects)
    {
        var removed = Target(item, instance, objects, _place.In("m_RemovedComponents"));
        var owner = objects[removed.Reference("m_GameObject").FileId];
        var components = _place.Sequence(Nodes.Find(owner.Fields, "m_Component"));
        foreach (var entry in components.Children.Where(c => LocalReferences.In(c).Contains(removed.FileId)).ToList())
            components.Children.Remove(entry);
        objects.Remove(removed.FileId);
    }

    FileObject Target(YamlNode node, PrefabInstance instance, Dictionary<long, FileObject> objects, Place place)
    {
        if (!AssetReference.TryRead(node, out var target) || target.Guid != SourceGuid)
            throw place.Error(AssetFault.Reference, "target has to be an object of the prefab with GUID " + SourceGuid);
        var source = instance.Source.Find(target.FileId);
        if (source == null || !objects.TryGetValue(instance.Map(source.FileId), out var found))
            throw place.Error(AssetFault.MissingObject, "the prefab " + instance.Source.Name + " has no object " + Numbers.Write(target.FileId));
        return found;
    }

    IList<YamlNode> Items(string list) =>
        Nodes.Find(_modification, list) is { } node ? _place.In(list).Sequence(node).Children : Array.Empty<YamlNode>();

    static void RequireOnly(YamlMappingNode mapping, Place place, params string[] known)
    {
        foreach (var key in mapping.Children.Keys)
        {
            var name = place.Scalar(key);
            if (!known.Contains(name)) throw place.Error(AssetFault.UnknownField, "has no field " + name);
        }
    }
}
